"""Hard cases of cams: contacts where profiles come to a cusp or turn hollow, where motions join dwells, at odd sizes."""
from mpmath import asin, atan2, conj, cos, exp, fabs, findroot, mpc, mpf, pi, sin, sqrt

from rows import between_sides, moves_alone, short, with_moves, write, written


def polynomial(*coefficients):
    """With its first two derivatives, of coefficients of u^0, u^1, ..."""
    def at(u):
        terms = list(enumerate(coefficients))
        return (sum(c * u ** i for i, c in terms), sum(c * i * u ** (i - 1) for i, c in terms if i > 0),
                sum(c * i * (i - 1) * u ** (i - 2) for i, c in terms if i > 1))
    return at


def cycloidal(u):
    return u - sin(2 * pi * u) / (2 * pi), 1 - cos(2 * pi * u), 2 * pi * sin(2 * pi * u)


def harmonic(u):
    return (1 - cos(pi * u)) / 2, pi * sin(pi * u) / 2, pi ** 2 * cos(pi * u) / 2


def modified_sine(u):
    """Norton, Cam Design and Manufacturing Handbook: three sines, of 1/4, 3/2 and 1/4 of a wave."""
    first = (pi * u - sin(4 * pi * u) / 4, pi * (1 - cos(4 * pi * u)), 4 * pi ** 2 * sin(4 * pi * u))
    phase = (4 * pi * u + pi) / 3
    middle = (2 + pi * u - 9 * sin(phase) / 4, pi * (1 - 3 * cos(phase)), 4 * pi ** 2 * sin(phase))
    last = (4 + first[0], first[1], first[2])
    return tuple(x / (4 + pi) for x in (first if u <= 0.125 else middle if u <= 0.875 else last))


KM = [mpf(x) / 100000 for x in (609755, -2078040, 2673155, -1360965, 256095)]  # Product Engineering 1955
LAWS = {"cycloidal": cycloidal, "harmonic": harmonic, "modified-sine": modified_sine,
        "3-4-5": polynomial(0, 0, 0, 10, -15, 6), "4-5-6-7": polynomial(0, 0, 0, 0, 35, -84, 70, -20),
        "kloomok-muffley": polynomial(0, 0, 0, KM[0], 0, *KM[1:])}


def motion(law, angle, lift, u):
    s, v, a = LAWS[law](u)
    return s * lift, v * lift / angle, a * lift / angle ** 2


def on_roller(centre, first, second, rise, sense, roller):
    """The answers of a roller whose centre has these derivatives by the cam angle in the fixed plane, and goes in the
    direction `rise` in a rise. The cam sees the centre turn against its own sense."""
    turning = mpc(0, sense)
    seen_first = first - turning * centre
    seen_second = second - 2 * turning * first - centre
    curvature = -sense * (conj(seen_first) * seen_second).imag / fabs(seen_first) ** 3
    normal = turning * seen_first / fabs(seen_first)
    across = normal * conj(rise)  # real along the rise
    contact = centre - roller * normal
    return [atan2(sense * across.imag, across.real), curvature, 1 - roller * curvature, contact.real, contact.imag]


def translating_roller(s, v, a, sense, prime, offset, roller):
    centre = mpc(sense * offset, sqrt(prime ** 2 - offset ** 2) + s)
    return on_roller(centre, mpc(0, v), mpc(0, a), mpc(0, 1), sense, roller)


def oscillating_roller(s, v, a, sense, prime, roller, pivot, arm):
    direction = exp(mpc(0, pi - between_sides(pivot, arm, prime) - s))
    return on_roller(pivot + arm * direction, arm * mpc(0, -v) * direction, arm * mpc(-v ** 2, -a) * direction,
                     mpc(0, -1) * direction, sense, roller)


def translating_flat(s, v, a, sense, base):
    """Radius of curvature from the support function base + s."""
    radius = base + s + a
    return [mpf(0), radius, radius / base, sense * v, base + s]


def oscillating_flat(s, v, a, sense, base, pivot, offset):
    """The cam is the envelope of the face, whose distance from its centre is a function of its direction."""
    face = asin((base + offset) / pivot) + s
    turning, turning_slope = -(v + sense), -a
    first = pivot * cos(face) * v / turning
    slope = (-pivot * sin(face) * v ** 2 + pivot * cos(face) * a - first * turning_slope) / turning ** 2
    distance = pivot * sin(face) - offset
    radius = distance + slope
    contact = mpc(sin(face), cos(face)) * mpc(distance, first)
    along = ((contact - pivot) * mpc(-cos(face), -sin(face))).real  # the face, from the foot of its pivot
    return [atan2(offset, along), radius, radius / base, contact.real, contact.imag]


FOLLOWERS = {"roller": translating_roller, "arm": oscillating_roller, "flat": translating_flat,
             "swinging-flat": oscillating_flat}
ANSWERS = ["lift_here", "velocity", "acceleration", "pressure_angle", "curvature", "undercut_margin", "contact_x",
           "contact_y"]
SIZES = {"roller": ("prime_radius", "offset", "roller_radius"),
         "arm": ("prime_radius", "roller_radius", "pivot_distance", "arm_length"), "flat": ("base_radius",),
         "swinging-flat": ("base_radius", "pivot_distance", "face_offset")}


def answers(follower, law, sense, angle, lift, u, *sizes):
    here = motion(law, angle, lift, u)
    return list(here) + FOLLOWERS[follower](*here, sense, *sizes)


def critical(follower, law, sense, angle, lift, u, sizes, which, column, value, between):
    """The size number `which` at which an answer takes a value, as a double."""
    def miss(x):
        changed = list(map(mpf, sizes))
        changed[which] = x
        return answers(follower, law, sense, mpf(angle), mpf(lift), mpf(u), *changed)[ANSWERS.index(column)] - value
    return float(findroot(miss, tuple(map(mpf, between)), solver="anderson", tol=mpf(10) ** -60))


def with_size(sizes, which, value):
    return sizes[:which] + (value,) + sizes[which + 1:]


USUAL = {"roller": (40.0, 4.0, 5.0), "arm": (40.0, 5.0, 80.0, 60.0), "flat": (40.0,),
         "swinging-flat": (30.0, 80.0, 4.0)}
LIFT = {"roller": 20.0, "arm": 0.375, "flat": 20.0, "swinging-flat": 0.25}
CLOSE = (10, 20, 30, 40, 50)


def joins():
    for follower, sizes in USUAL.items():
        for law in LAWS if follower == "roller" else ("cycloidal", "modified-sine"):
            for u in [0.0, 1.0] + [x for k in CLOSE for x in (2.0 ** -k, 1 - 2.0 ** -k)]:
                yield "joint with a dwell", follower, law, 1, 1.0, LIFT[follower], u, sizes


def cusps():
    """Rollers as large as the radius of curvature, faces on a radius of zero, and a hair beside."""
    for sense in (1, -1):
        for u in (0.625, 0.8125):  # the pitch curve is most convex where the lift is slowed down
            for follower, which in (("roller", 2), ("arm", 1), ("flat", 0), ("swinging-flat", 0)):
                law, lift, sizes, angle = "cycloidal", LIFT[follower], USUAL[follower], 1.5
                size = critical(follower, law, sense, angle, lift, u, sizes, which, "undercut_margin", 0, (4, 72))
                yield "cusp", follower, law, sense, angle, lift, u, with_size(sizes, which, size)
                for k in CLOSE:
                    for side in (-1, 1):
                        beside = with_size(sizes, which, size * (1 + side * 2.0 ** -k))
                        yield f"2^-{k} beside a cusp", follower, law, sense, angle, lift, u, beside


def inflections():
    """Pitch curves that turn hollow."""
    for u in (0.1875, 0.25):
        sizes, angle, lift = USUAL["roller"], 1.0, 20.0
        size = critical("roller", "cycloidal", 1, angle, lift, u, sizes, 0, "curvature", 0, (40, 400))
        yield "inflection", "roller", "cycloidal", 1, angle, lift, u, with_size(sizes, 0, size)
        for k in CLOSE:
            for side in (-1, 1):
                beside = with_size(sizes, 0, size * (1 + side * 2.0 ** -k))
                yield f"2^-{k} beside an inflection", "roller", "cycloidal", 1, angle, lift, u, beside


def odd_sizes():
    for u in (0.0, 0.3125, 0.5, 0.75):
        for law in ("cycloidal", "modified-sine"):
            for k in CLOSE:
                e = 2.0 ** -k
                yield f"offset beside the prime radius by 2^-{k}", "roller", law, 1, 1.0, 20.0, u, (
                    40.0, 40.0 * (1 - e), 5.0)
                yield f"arm that begins on the line of centres, 2^-{k}", "arm", law, -1, 1.0, 0.375, u, (
                    20.0 * (1 + e), 5.0, 80.0, 60.0)
                yield f"face that begins square to the line of centres, 2^-{k}", "swinging-flat", law, 1, 1.0, 0.25, \
                    u, (76.0 * (1 - e), 80.0, 4.0)
            for small in (1e-3, 1e-6):
                yield f"lift {small}", "roller", law, 1, 1.0, 20 * small, u, USUAL["roller"]
                yield f"prime radius {small} of the lift", "roller", law, 1, 1.0, 20.0, u, (20 * small, 0.0, 5 * small)
                yield f"roller {small}", "roller", law, -1, 1.0, 20.0, u, (40.0, 4.0, 5 * small)
                yield f"arm {small} of its pivot distance", "arm", law, 1, 1.0, 0.375, u, (
                    80.0 - 30 * small, 5.0, 80.0, 60 * small)
                yield f"lift {small}", "flat", law, 1, 1.0, 20 * small, u, USUAL["flat"]
                yield f"rise within {small}", "roller", law, 1, small, 20.0, u, USUAL["roller"]


def cases():
    rows = []
    for make in (joins, cusps, inflections, odd_sizes):
        for name, follower, law, sense, angle, lift, u, sizes in make():
            inputs = [mpf(x) for x in (angle, lift, u) + sizes]
            function = lambda *x: answers(follower, law, sense, *x)
            row = [name, follower, law, str(sense), repr(angle), repr(lift), repr(u)]
            row += [repr(x) for x in sizes] + [""] * (4 - len(sizes))
            for answer, move in zip(function(*inputs), moves_alone(function, inputs)):
                row += [written(answer), short(move)]
            rows.append(row)
    return rows


def write_tables():
    columns = ["name", "follower", "law", "sense", "angle", "lift", "part", "size_1", "size_2", "size_3", "size_4"]
    write("cams.csv", columns + with_moves(ANSWERS), cases(),
          "Contacts of cams at hard places, in fifty digits; sizes as the functions of cams.py take them.")

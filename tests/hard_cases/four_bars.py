"""Hard cases of four-bars: poses and motion, limit positions, frames far away, assemblies at the last unit."""
import math

from mpmath import conj, cos, exp, fabs, mpc, mpf, pi, sin

from rows import between_sides, exact_angle, moves, short, with_moves, write, written


class Pose:
    """Ground, crank, coupler, rocker, crank angle, side (+1 open), coupler point along and across."""

    def __init__(self, g, k, c, r, angle, side, along, across):
        crank = mpc(cos(angle), sin(angle)) if angle != pi else mpc(-1, 0)
        pin = k * crank
        to_pivot = g - pin
        d = fabs(to_pivot)
        if d < mpf(10) ** -100:
            d = mpf(0)
        self.stretch, self.fold = c + r - d, d - fabs(c - r)
        tiny = mpf(10) ** -100
        if fabs(self.stretch) < tiny:
            self.stretch = mpf(0)
        if fabs(self.fold) < tiny:
            self.fold = mpf(0)
        self.assembled = self.stretch >= 0 and self.fold >= 0
        line = to_pivot / d if d > 0 else mpc(0, -1)  # the limit as the crank turns on
        if self.assembled:
            at_pin = between_sides(c, d, r) if d > 0 else pi / 2
            self.mu = between_sides(c, r, d)
            self.coupler = line * exp(mpc(0, side * at_pin))
            self.rocker = (pin + c * self.coupler - g) / r
        else:
            stretched = self.stretch < 0
            self.mu = +pi if stretched else mpf(0)
            self.coupler = line if stretched or c >= r else -line
            self.rocker = -line if stretched else self.coupler
        self.sine = side * sin(self.mu) if self.stretch != 0 and self.fold != 0 and self.assembled else mpf(0)
        arm = mpc(along, across) * self.coupler
        self.point = pin + arm
        self.ratio = self.ratio_slope = self.velocity = self.acceleration = None
        if self.sine != 0:
            spin = k * (crank * conj(self.rocker)).imag / (c * self.sine)
            self.ratio = k * (crank * conj(self.coupler)).imag / (r * self.sine)
            self.velocity = mpc(0, 1) * (pin + spin * arm)
            # The loop pin + c coupler = g + r rocker, differentiated twice; what is known of it on one side.
            known = pin + c * spin ** 2 * self.coupler - r * self.ratio ** 2 * self.rocker
            spin_slope = (known * conj(self.rocker)).real / (c * self.sine)
            self.ratio_slope = (known * conj(self.coupler)).real / (r * self.sine)
            self.acceleration = -pin + mpc(-spin ** 2, spin_slope) * arm

    def answers(self):
        """The answers in the order of the columns; None where there is none."""
        flat = [self.stretch, self.fold, self.mu, self.sine, self.coupler.real, self.coupler.imag,
                self.rocker.real, self.rocker.imag, self.point.real, self.point.imag, self.ratio]
        if self.velocity is None:
            return flat + [None] * 5
        return flat + [self.velocity.real, self.velocity.imag, self.ratio_slope, self.acceleration.real,
                       self.acceleration.imag]


POSE_ANSWERS = ["stretch", "fold", "transmission_angle", "transmission_sine", "coupler_x", "coupler_y", "rocker_x",
                "rocker_y", "point_x", "point_y", "velocity_ratio", "velocity_x", "velocity_y", "ratio_slope",
                "acceleration_x", "acceleration_y"]


def turns_fully(g, k, c, r):
    g, k, c, r = map(mpf, (g, k, c, r))
    return c + r >= g + k and fabs(g - k) >= fabs(c - r)


def pose_row(name, links, angle, side=1, point=(0.5, 0.25)):
    inputs = [mpf(x) for x in links] + [exact_angle(angle), mpf(side)] + [mpf(x) for x in point]
    pose = Pose(*inputs)
    fixed = (4, 5) if angle in ("pi", 0) else (5,)
    by = moves(lambda *x: Pose(*x).answers(), inputs, fixed)
    cells = [name] + [repr(float(x)) for x in links] + ["pi" if angle == "pi" else repr(float(angle))]
    cells += ["open" if side > 0 else "crossed"] + [repr(float(x)) for x in point]
    cells += ["yes" if pose.assembled else "no", "yes" if turns_fully(*links) else "no"]
    for answer, move in zip(pose.answers(), by):
        cells += [written(answer), "" if answer is None else short(move)]
    return cells


def toggle(links, stretched=True):
    g, k, c, r = map(mpf, links)
    return between_sides(g, k, c + r if stretched else fabs(c - r))


def pose_cases():
    rows = []

    def add(*args, **more):
        for side in (1, -1):
            rows.append(pose_row(*args, side=side, **more))

    folding, stretching = (4.0, 2.0, 5.0, 3.0), (6.0, 2.0, 3.0, 5.0)
    for links, line, offset in ((folding, 0, 0.0), (stretching, "pi", float(pi))):
        name = "folds" if line == 0 else "stretches"
        add(f"change point: {name}, exact", links, line)
        for k in (10, 20, 30, 40, 50):
            beside = offset + (1 if line == 0 else -1) * 2.0 ** -k
            add(f"change point: {name}, exact, 2^-{k} beside it", links, beside)
        for k in (5, 10, 20, 30, 40, 50):
            e = 2.0 ** -k
            turning = links[:3] + (links[3] * (1 + e),)
            add(f"change point + 2^-{k}: {name}", turning, line)
            add(f"change point + 2^-{k}: {name}, beside it", turning, offset + (e if line == 0 else -e))
            blocked = links[:3] + (links[3] * (1 - e),)
            edge = float(toggle(blocked, line != 0))
            add(f"change point - 2^-{k}: {name}, past its toggle", blocked, line)
            before = edge + (1 if line == 0 else -1) * abs(edge - offset) / 64
            add(f"change point - 2^-{k}: {name}, before its toggle", blocked, before)
    book = (600.0, 300.0, 360.0, 360.0)
    near = (1.0, 0.875, 1.0, 0.5)
    for k in (2, 5, 10, 20, 30, 40):
        for sign, where in ((-1, "before"), (1, "past")):
            add(f"stretched toggle, 2^-{k} {where} it", book, float(toggle(book)) + sign * 2.0 ** -k)
            add(f"folded toggle, 2^-{k} {where} it", near, float(toggle(near, False)) - sign * 2.0 ** -k)
    for angle in (0, 2.0 ** -50, 2.0 ** -30, 2.0 ** -10, 0.75, 2.5, 3.140625, "pi"):
        add("parallelogram", (4.0, 2.0, 4.0, 2.0), angle)
        add("rhombus", (3.0, 3.0, 3.0, 3.0), angle)
        add("kite, its pins meet", (4.0, 4.0, 3.0, 3.0), angle)
        add("kite, coupler on crank", (5.0, 2.0, 2.0, 5.0), angle)
    for k in (10, 20, 30, 40, 50):
        e = 2.0 ** -k
        for angle in (0, e, 0.75, "pi"):
            add(f"near-parallelogram, 2^-{k}", (4.0, 2.0, 4.0 * (1 + e), 2.0 * (1 + e)), angle)
            add(f"near-kite, 2^-{k}", (4.0, 4.0 * (1 - e), 3.0 * (1 + e / 2), 3.0), angle)
    for angle in (0, 1e-7, 0.75, 2.0, "pi"):
        add("crank 1e-6 of the frame", (1.0, 1e-6, 0.75, 0.625), angle)
        add("crank 1e-6, close to its change point", (1.0, 1e-6, 0.5, 0.5 + 1.5e-6), angle)
        add("crank 1e-6 on a frame of 1e6", (1e6, 1.0, 1e6, 1.0 + 1e-6), angle)
    for small in (1e-3, 1e-6):
        for angle in (0, 0.75, 2.0, 4.0, "pi"):
            add(f"ground {small} of the others", (small, 1.0, 0.75, 0.75 + small / 4), angle)
            add(f"ground and crank {small} of the others", (1.0, 0.5, 1 / small, 1 / small + 0.25), angle)
            add(f"crank and coupler {small} of the others", (1.0, small, 2 * small, 1.0), angle)
            add(f"crank and rocker {small} of the others", (1.0, small, 1.0, 2 * small), angle)
    rocker_small = (1.0, 0.75, 0.5, 1e-6)
    edges = [float(toggle(rocker_small, False)), float(toggle(rocker_small))]
    coupler_small = (1.0, 0.75, 1e-6, 0.5)
    for share in (0.25, 0.5, 0.9375):
        add("rocker 1e-6 of the frame", rocker_small, edges[0] + share * (edges[1] - edges[0]))
        add("coupler 1e-6 of the frame", coupler_small, edges[0] + share * (edges[1] - edges[0]))
    plain = (1.0, 0.3125, 0.9, 0.75)
    for point, name in (((0.0, 0.0), "on the crank pin"), ((0.9, 0.0), "on the rocker pin"), ((1e6, -1e6), "at 1e6"),
                        ((1e-6, 1e-6), "at 1e-6")):
        for angle in (0.5, 4.0):
            add(f"coupler point {name}", plain, angle, point=point)
    for angle in (0.5, 2.0, 4.0):
        # The pole of the coupler: a point there has no velocity, and its curve a cusp.
        for side in (1, -1):
            p = Pose(*map(mpf, plain), mpf(angle), side, 0, 0)
            crank = mpc(cos(mpf(angle)), sin(mpf(angle)))
            pole = mpf(plain[0]) * p.rocker.imag / (conj(crank) * p.rocker).imag * crank
            local = (pole - mpf(plain[1]) * crank) * conj(p.coupler)
            point = (float(local.real), float(local.imag))
            rows.append(pose_row("cusp of the coupler curve", plain, angle, side, point))
    return rows


LIMIT_ANSWERS = ["swing", "stroke_excess", "extended_crank", "folded_crank", "extended_rocker", "folded_rocker",
                 "extended_transmission", "folded_transmission"]


def limits(g, k, c, r):
    """Of the open assembly."""
    reach, back = c + k, c - k
    crank = (between_sides(g, reach, r), between_sides(g, back, r) if back > 0 else mpf(0))
    rocker = (between_sides(g, r, reach), between_sides(g, r, back) if back > 0 else mpf(0))
    transmission = (between_sides(reach, r, g), between_sides(back, r, g) if back > 0 else pi / 2)
    return [rocker[0] - rocker[1], crank[1] - crank[0], crank[0], pi + crank[1], pi - rocker[0], pi - rocker[1],
            transmission[0], transmission[1]]


def limit_cases():
    cases = [("plain", (100.0, 25.0, 90.0, 75.0))]
    for k in (10, 20, 30, 40, 50):
        e = 2.0 ** -k
        cases += [(f"change point + 2^-{k}: folds", (4.0, 2.0, 5.0, 3.0 * (1 + e))),
                  (f"change point + 2^-{k}: stretches", (6.0, 2.0, 3.0, 5.0 * (1 + e))),
                  (f"near-parallelogram, 2^-{k}", (4.0 * (1 + e), 2.0, 4.0 * (1 + e), 2.0 * (1 + e / 2))),
                  (f"near-kite, 2^-{k}", (5.0, 2.0, 2.0 * (1 + e), 5.0 * (1 + e / 4))),
                  (f"nearly without quick return, 2^-{k}", (4.0, 1.0, 3.0 * (1 + e), 2.8284271247461903))]
    for crank in (1e-3, 1e-6, 1e-9, 1e-12):
        cases += [(f"crank {crank}", (1.0, crank, 0.75, 0.625)),
                  (f"crank {crank}, margins like it", (1.0, crank, 0.5 + crank, 0.5 + crank)),
                  (f"crank {crank}, rocker alike", (1.0, crank, 1.0, 3 * crank)),
                  (f"crank {crank}, coupler alike", (1.0, crank, 3 * crank, 1.0))]
    cases += [("change point: folds", (4.0, 2.0, 5.0, 3.0)), ("change point: stretches", (6.0, 2.0, 3.0, 5.0)),
              ("parallelogram", (4.0, 2.0, 4.0, 2.0)), ("frame of 1e6", (1e6, 1.0, 1e6, 1.0 + 1e-6))]
    rows = []
    for name, links in cases:
        inputs = [mpf(x) for x in links]
        assert turns_fully(*links), name
        row = [name] + [repr(x) for x in links]
        for answer, move in zip(limits(*inputs), moves(limits, inputs)):
            row += [written(answer), short(move)]
        rows.append(row)
    return rows


def frame_cases():
    """The miss of a target near the coupler point, the linkage a million away from the origin."""
    rows = []
    links, point, angle = (1.0, 0.3125, 0.9, 0.75), (0.5, 0.25), 2.0
    for offset in (0.0, 1.0, 2.0 ** 10, 1e6, 1048576.0, -3e6):
        for tilt in (0.0, 0.75, -2.0):
            origin = (offset, 0.5 - 2 * offset)
            target = (origin[0] + 0.25, origin[1] + 0.5)
            p = Pose(*map(mpf, links), mpf(angle), 1, *map(mpf, point))
            at = mpc(*origin) + p.point * exp(mpc(0, tilt))
            off = mpc(*target) - at
            numbers = links + (angle,) + point + origin + (tilt,) + target
            rows.append(["frame far away"] + [repr(x) for x in numbers] + [written(off.real), written(off.imag)])
    return rows


def assembly_cases():
    """Whether linkages assemble with the crank on the ground line, at the edge and one unit in the last place off."""
    rows = []
    plain = [(1.0, 0.3, 0.7), (0.7, 0.1, 0.3), (3.3, 1.1, 2.9), (1.0, 1e-6, 0.9), (1e6, 0.3, 7.1), (0.2, 0.7, 0.1)]
    for g, k, c in plain:
        for line, d in ((0, fabs(mpf(g) - k)), ("pi", mpf(g) + k)):
            edges = (("stretched", d - c), ("folded; rocker longer", c + d), ("folded; coupler longer", c - d))
            for name, edge in edges:
                if edge <= 0:
                    continue
                nearest = float(edge)
                for r in (math.nextafter(nearest, 0), nearest, math.nextafter(nearest, math.inf)):
                    assembles = fabs(mpf(c) - r) <= d <= mpf(c) + r
                    rows.append([name, repr(g), repr(k), repr(c), repr(r), str(line), "yes" if assembles else "no"])
    return rows


def write_tables():
    links = ["name", "ground", "crank", "coupler", "rocker"]
    place = ["crank_angle", "assembly", "along", "across", "assembled", "turns"]
    frame = ["crank_angle", "along", "across", "origin_x", "origin_y", "tilt", "target_x", "target_y"]
    write("poses.csv", links + place + with_moves(POSE_ANSWERS), pose_cases(),
          "Poses, velocities and accelerations of four-bars at hard places, in fifty digits.")
    write("limits.csv", links + with_moves(LIMIT_ANSWERS), limit_cases(),
          "Limit positions, swing and stroke of crank-rockers, in fifty digits.")
    write("frames.csv", links + frame + ["miss_x", "miss_y"], frame_cases(),
          "From coupler points to targets near them, far from the origin, in fifty digits.")
    write("assembly.csv", links + ["crank_angle", "assembles"], assembly_cases(),
          "Linkages that just assemble with the crank on the ground line, and that just do not.")

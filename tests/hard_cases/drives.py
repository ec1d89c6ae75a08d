"""Hard cases of slotted arms, slider-cranks and the drives that are made of them."""
from mpmath import acos, arg, asin, atan2, conj, cos, exp, fabs, mpc, mpf, pi, sin, sqrt

from four_bars import Pose
from rows import between_sides, exact_angle, moves, moves_alone, short, with_moves, write, written

SLOTTED_ANSWERS = ["arm_angle", "reach", "arm_velocity", "arm_acceleration", "slide_velocity"]


def slotted_arm(d, r, angle):
    """Arm pivot at the origin, crank pivot at d; block at d + r exp(i angle), its derivatives divided by it."""
    pin = d + r * (mpc(cos(angle), sin(angle)) if angle != pi else mpc(-1, 0))
    if fabs(pin) == 0:
        return [None] * 5
    first = mpc(0, 1) * (pin - d) / pin
    second = -(pin - d) / pin - first * first
    return [arg(pin), fabs(pin), first.imag, second.imag, fabs(pin) * first.real]


def slotted_cases():
    rows = []
    for k in (10, 20, 30, 40, 50):
        e = 2.0 ** -k
        for crank in (1.5 * (1 - e), 1.5 * (1 + e)):
            for angle in (0, 0.75, 2.5, 3.0, 3.140625, float(pi) - e, float(pi) + 3 * e, "pi"):
                inputs = [mpf(1.5), mpf(crank), exact_angle(angle)]
                by = moves(slotted_arm, inputs, (2,) if angle in ("pi", 0) else ())
                cells = [f"crank = centre distance (1 {'+' if crank > 1.5 else '-'} 2^-{k})", "1.5", repr(crank)]
                cells += ["pi" if angle == "pi" else repr(float(angle))]
                for answer, move in zip(slotted_arm(*inputs), by):
                    cells += [written(answer), short(move)]
                rows.append(cells)
    return rows


SLOTTED_STROKES = ["slow_stroke", "fast_stroke"]


def slotted_strokes(d, r):
    fast = 2 * acos(min(d, r) / max(d, r))
    return [2 * pi - fast, fast]


def slotted_stroke_cases():
    rows = []
    for k in range(10, 51, 5):
        for crank in (1.5 * (1 - 2.0 ** -k), 1.5 * (1 + 2.0 ** -k)):
            row = [f"crank beside centre distance by 2^-{k}", "1.5", repr(crank)]
            inputs = [mpf(1.5), mpf(crank)]
            for answer, move in zip(slotted_strokes(*inputs), moves(slotted_strokes, inputs)):
                row += [written(answer), short(move)]
            rows.append(row)
    return rows


SLIDER_ANSWERS = ["position", "rod_slope", "transmission_angle", "velocity", "acceleration"]


def slider_crank(r, l, e, angle, speed=mpf(1), acceleration=mpf(0)):
    """Position = r cos(angle) + sqrt(l^2 - height^2), differentiated once and twice."""
    height = e - r * sin(angle)
    run = sqrt(l * l - height * height)
    along, across = r * cos(angle), r * sin(angle)
    first = -across + height * along / run
    second = -along - (along ** 2 + height * across) / run - (height * along) ** 2 / run ** 3
    return [along + run, atan2(height, run), pi / 2 - fabs(atan2(height, run)), first * speed,
            second * speed ** 2 + first * acceleration]


SLIDER_STROKES = ["stroke", "inward_stroke"]


def slider_strokes(r, l, e):
    outer, inner = sqrt((l + r) ** 2 - e * e), sqrt((l - r) ** 2 - e * e)
    return [outer - inner, pi + asin(e / (l - r)) - asin(e / (l + r))]


def slider_links():
    """Crank, rod, offset with little or nothing to spare where the crank stands square to the slide; and r = l in line,
    where the ram comes back to the crank pivot."""
    for k in (10, 20, 30, 40, 50):
        e = 2.0 ** -k
        for offset in (0.75, -0.75):
            yield f"rod = crank + offset (1 + 2^-{k})", (1.0, 1.0 + 0.75 * (1 + e), offset)
        yield f"offset 2^-{k}", (1.0, 3.0, e)
        yield f"rod = crank (1 + 2^-{k}) in line", (1.0, 1.0 + e, 0.0)
    for crank in (1e-3, 1e-6, 1e-9):
        yield f"crank {crank}", (crank, 1.0, 0.5)
        yield f"crank {crank}, offset alike", (crank, 1.0, 2 * crank)
    yield "rod a million cranks long", (1.0, 1e6, 0.5)


def slider_cases():
    rows = []
    for name, links in slider_links():
        for angle in (0, 0.75, 2.5, 3.140625, 3.9, -1.5625, 1.5625, float(-pi / 2) + 2.0 ** -20):
            inputs = [mpf(x) for x in links] + [mpf(angle)]
            cells = [name] + [repr(x) for x in links] + [repr(float(angle))]
            by = moves(slider_crank, inputs, (3,) if angle == 0 else ())
            for answer, move in zip(slider_crank(*inputs), by):
                cells += [written(answer), short(move)]
            rows.append(cells)
    return rows


def slider_stroke_cases():
    rows = []
    for name, links in slider_links():
        inputs = [mpf(x) for x in links]
        row = [name] + [repr(x) for x in links]
        for answer, move in zip(slider_strokes(*inputs), moves(slider_strokes, inputs)):
            row += [written(answer), short(move)]
        rows.append(row)
    return rows


RAM_ANSWERS = ["position", "transmission_angle", "velocity", "acceleration"]


def ram(arm, rod, offset, angle, speed, acceleration):
    """What an arm at an angle to the slide does to a ram, in the order of the columns."""
    position, _, transmission, velocity, second = slider_crank(arm, rod, offset, angle, speed, acceleration)
    return [position, transmission, velocity, second]


def crank_shaper(d, r, lever, rod, ram_distance, angle):
    turn, _, speed, acceleration, _ = slotted_arm(d, r, angle)
    return ram(lever, rod, -ram_distance, turn - pi / 2, speed, acceleration)


def whitworth(d, r, arm, rod, slide_angle, angle):
    turn, _, speed, acceleration, _ = slotted_arm(d, r, angle)
    return ram(arm, rod, mpf(0), turn + pi - slide_angle, speed, acceleration)


def drag_link(g, k, c, f, arm, arm_angle, rod, slide_angle, offset, angle, side=1):
    p = Pose(g, k, c, f, angle, side, 0, 0)
    if p.ratio is None:
        return [None] * 4
    return ram(arm, rod, offset, arg(p.rocker) + arm_angle - slide_angle, p.ratio, p.ratio_slope)


DRAG_STROKES = ["outward_stroke", "inward_stroke", "stroke"]


def drag_link_strokes(g, k, c, f, arm, arm_angle, rod, slide_angle, offset, side=1):
    def crank_at(arm_to_slide):
        follower = exp(mpc(0, arm_to_slide + slide_angle - arm_angle))
        pin = g + f * follower
        for sign in (1, -1):
            crank = pin / fabs(pin) * exp(mpc(0, sign * between_sides(k, fabs(pin), c)))
            if ((follower * conj(pin - k * crank)).imag > 0) == (side > 0):
                return arg(crank)
        raise ValueError("no such assembly")

    outer = crank_at(asin(offset / (rod + arm)))
    inner = crank_at(pi + asin(offset / (rod - arm)))
    inward = (inner - outer) % (2 * pi)
    return [2 * pi - inward, inward, sqrt((rod + arm) ** 2 - offset ** 2) - sqrt((rod - arm) ** 2 - offset ** 2)]


def beside(number, k):
    return (number * (1 - 2.0 ** -k), number * (1 + 2.0 ** -k))


CLOSE = (10, 20, 30, 40, 50)
TURN = (0, 0.75, 2.5, 3.140625, "pi", 4.5)


def rows_of(function, cases, fixed=()):
    """Rows for the cases (name, dimensions, crank angle, further cells that are no numbers)."""
    rows = []
    for name, links, angle, *more in cases:
        inputs = [mpf(x) for x in links] + [exact_angle(angle)]
        held = tuple(fixed) + ((len(links),) if angle in ("pi", 0) else ())
        cells = [name] + [repr(float(x)) for x in links] + ["pi" if angle == "pi" else repr(float(angle))]
        side = [1 if m == "open" else -1 for m in more]
        by = moves_alone(lambda *x: function(*x, *side), inputs, held)
        for answer, move in zip(function(*inputs, *side), by):
            more = more + [written(answer), "" if answer is None else short(move)]
        rows.append(cells + more)
    return rows


def shaper_cases():
    for angle in TURN:
        for k in CLOSE:
            yield f"crank beside centre distance by 2^-{k}", (1.5, beside(1.5, k)[0], 2.0, 3.0, 1.0), angle
            yield f"rod reaches the ram by 2^-{k}", (1.5, 0.75, 2.0, 0.5 * (1 + 2.0 ** -k), 1.5), angle
        for crank in (1e-3, 1e-6):
            yield f"crank {crank} of the centre distance", (1.5, 1.5 * crank, 2.0, 3.0, 1.5), angle
        yield "centre distance a million", (1e6, 0.75e6, 2.0, 3.0, 1.5), angle
        yield "rod a million levers long", (1.5, 0.75, 2.0, 2e6, 1.5), angle
        yield "lever a million cranks long", (1.5, 0.75, 1e6, 1e6, 0.75e6), angle


def whitworth_cases():
    for angle in TURN:
        for slide in (0.0, 1.5):
            for k in CLOSE:
                yield f"crank beside centre distance by 2^-{k}", (1.5, beside(1.5, k)[1], 2.0, 3.0, slide), angle
                yield f"rod beside arm by 2^-{k}", (0.75, 1.5, 2.0, beside(2.0, k)[1], slide), angle
            yield "crank a million centre distances long", (1e-6, 1.0, 2.0, 3.0, slide), angle
            yield "rod a million arms long", (0.75, 1.5, 1.0, 1e6, slide), angle


STRETCHES, FOLDS = (1.0, 2.5, 2.25, 1.25), (1.0, 2.25, 2.5, 1.25)


def drag_links():
    """Links, arm, arm angle, rod, slide angle, offset."""
    output = (1.5, 0.5, 4.0, 0.25, 0.5)
    for k in CLOSE:
        e = 2.0 ** -k
        for name, links in (("stretches", STRETCHES), ("folds", FOLDS)):
            yield f"change point + 2^-{k}: {name}", links[:3] + (links[3] * (1 + e),) + output
        yield f"rod = arm + offset (1 + 2^-{k})", (1.0, 2.0, 2.25, 2.5, 1.5, 0.5, 1.5 + 0.5 * (1 + e), 0.25, 0.5)
        yield f"near-parallelogram, 2^-{k}", (1.0 * (1 - e), 2.0, 1.0 * (1 + e), 2.0) + output
    for small in (1e-3, 1e-6):
        yield f"ground {small} of the others", (small, 1.0, 0.75, 0.5) + output
        yield f"ground {small}, links alike", (small, 1.0, 1.0, 1.0) + output
        yield f"output {small} of the links", (1.0, 2.0, 2.25, 2.5, small, 0.5, 3 * small, 0.25, 0.5 * small)
    yield "rod a million arms long", (1.0, 2.0, 2.25, 2.5, 1.0, 0.5, 1e6, 0.25, 0.5)


def drag_link_cases():
    for name, dimensions in drag_links():
        for angle in TURN:
            for assembly in ("open", "crossed"):
                if turns(dimensions):
                    yield name, dimensions, angle, assembly


def turns(dimensions):
    """Whether the ground link is shortest and Grashof's rule holds."""
    g, *others = sorted(map(mpf, dimensions[:4]))
    return g == mpf(dimensions[0]) and g + others[2] <= others[0] + others[1]


def drag_stroke_cases():
    rows = []
    for name, dimensions in drag_links():
        for assembly, side in (("open", 1), ("crossed", -1)):
            if not turns(dimensions):
                continue
            inputs = [mpf(x) for x in dimensions]
            row = [name] + [repr(float(x)) for x in dimensions] + [assembly]
            by = moves_alone(lambda *x: drag_link_strokes(*x, side=side), inputs)
            for answer, move in zip(drag_link_strokes(*inputs, side=side), by):
                row += [written(answer), short(move)]
            rows.append(row)
    return rows


def write_tables():
    slotted = ["name", "centre_distance", "crank"]
    write("slotted_arms.csv", slotted + ["crank_angle"] + with_moves(SLOTTED_ANSWERS), slotted_cases(),
          "Slotted arms with the crank as long as the centre distance, nearly, in fifty digits.")
    write("slotted_strokes.csv", slotted + with_moves(SLOTTED_STROKES), slotted_stroke_cases(),
          "Strokes of crank shapers and Whitworth drives on the same, in fifty digits.")
    slider = ["name", "crank", "rod", "offset"]
    write("slider_cranks.csv", slider + ["crank_angle"] + with_moves(SLIDER_ANSWERS), slider_cases(),
          "Slider-cranks with little to spare and at odd sizes, in fifty digits.")
    write("slider_strokes.csv", slider + with_moves(SLIDER_STROKES), slider_stroke_cases(),
          "Strokes of the same, in fifty digits.")
    ram_columns = ["crank_angle"] + with_moves(RAM_ANSWERS)
    write("crank_shapers.csv", slotted + ["lever", "rod", "ram_distance"] + ram_columns,
          rows_of(crank_shaper, shaper_cases()), "The ram of crank shapers at hard places, in fifty digits.")
    write("whitworths.csv", slotted + ["arm", "rod", "slide_angle"] + ram_columns,
          rows_of(whitworth, whitworth_cases()), "The ram of Whitworth drives at hard places, in fifty digits.")
    drag = ["name", "ground", "crank", "coupler", "follower", "arm", "arm_angle", "rod", "slide_angle", "offset"]
    write("drag_links.csv", drag + ["crank_angle", "assembly"] + with_moves(RAM_ANSWERS),
          rows_of(drag_link, drag_link_cases()), "The ram of drag links at hard places, in fifty digits.")
    write("drag_strokes.csv", drag + ["assembly"] + with_moves(DRAG_STROKES), drag_stroke_cases(),
          "Strokes of the same, in fifty digits.")

#!/usr/bin/env python3
"""Writes the answers of the hard cases, tests/hard_cases/data/*.csv, in fifty digits. Needs mpmath (1.3).

    tests/hard_cases/generate.py

Every answer comes from the double dimensions in its row, taken exactly, by textbook formulas (law of cosines, complex
numbers) in 120 digits, where their cancellation does no harm; nothing of the program is used. Beside each answer stands
how far it moves when every input moves by its rounding (2^-53 of itself, the worst of all signs): what even a perfect
method has to be forgiven. A crank angle `pi` means exactly that, and neither it nor 0 is moved.
"""
import itertools
import math
import os

from mpmath import acos, arg, asin, atan2, conj, cos, exp, fabs, mp, mpc, mpf, nstr, pi, sin, sqrt

mp.dps = 120
ROUNDING = mpf(2) ** -53
FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "data")


def between_sides(a, b, c):
    """The angle between the sides a and b of a triangle, opposite to c; 0 or pi where it does not close."""
    cosine = (a * a + b * b - c * c) / (2 * a * b)
    return mpf(0) if cosine >= 1 else +pi if cosine <= -1 else acos(cosine)


def exact_angle(angle):
    return +pi if angle == "pi" else mpf(angle)


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
        self.ratio = self.velocity = None
        if self.sine != 0:
            spin = k * (crank * conj(self.rocker)).imag / (c * self.sine)
            self.ratio = k * (crank * conj(self.coupler)).imag / (r * self.sine)
            self.velocity = mpc(0, 1) * (pin + spin * arm)

    def answers(self):
        """The answers in the order of the columns; None where there is none."""
        flat = [self.stretch, self.fold, self.mu, self.sine, self.coupler.real, self.coupler.imag,
                self.rocker.real, self.rocker.imag, self.point.real, self.point.imag, self.ratio]
        return flat + ([self.velocity.real, self.velocity.imag] if self.velocity is not None else [None, None])


def moves(function, inputs, fixed=()):
    """How far each answer moves when each input moves by its rounding."""
    here = function(*inputs)
    worst = [mpf(0)] * len(here)
    free = [i for i in range(len(inputs)) if i not in fixed and inputs[i] != 0]
    for signs in itertools.product((-1, 1), repeat=len(free)):
        moved = list(inputs)
        for i, sign in zip(free, signs):
            moved[i] = inputs[i] * (1 + sign * ROUNDING)
        for i, there in enumerate(function(*moved)):
            if there is None or here[i] is None:
                continue
            worst[i] = max(worst[i], fabs(there - here[i]))
    return worst


def written(x):
    if x is None:
        return ""
    return "0" if x == 0 else nstr(x, 50, strip_zeros=True)


def short(x):
    return "0" if x == 0 else nstr(x, 3)


POSE_ANSWERS = ["stretch", "fold", "transmission_angle", "transmission_sine", "coupler_x", "coupler_y", "rocker_x",
                "rocker_y", "point_x", "point_y", "velocity_ratio", "velocity_x", "velocity_y"]


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


SLIDER_ANSWERS = ["position", "rod_slope", "transmission_angle", "velocity"]


def slider_crank(r, l, e, angle):
    height = e - r * sin(angle)
    run = sqrt(l * l - height * height)
    slope = height / run
    return [r * cos(angle) + run, atan2(height, run), pi / 2 - fabs(atan2(height, run)),
            -r * sin(angle) + slope * r * cos(angle)]


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


def write(file, header, rows, about):
    with open(os.path.join(FOLDER, file), "w", encoding="ascii", newline="\n") as out:
        out.write(f"# {about} Written by tests/hard_cases/generate.py.\n")
        out.write(",".join(header) + "\n")
        for row in rows:
            assert len(row) == len(header)
            out.write(",".join(cell.replace(",", ";") for cell in row) + "\n")


def with_moves(answers):
    return [column for answer in answers for column in (answer, answer + "_moves")]


def main():
    links = ["name", "ground", "crank", "coupler", "rocker"]
    place = ["crank_angle", "assembly", "along", "across", "assembled", "turns"]
    frame = ["crank_angle", "along", "across", "origin_x", "origin_y", "tilt", "target_x", "target_y"]
    write("poses.csv", links + place + with_moves(POSE_ANSWERS), pose_cases(),
          "Poses and velocities of four-bars at hard places, in fifty digits.")
    write("limits.csv", links + with_moves(LIMIT_ANSWERS), limit_cases(),
          "Limit positions, swing and stroke of crank-rockers, in fifty digits.")
    write("frames.csv", links + frame + ["miss_x", "miss_y"], frame_cases(),
          "From coupler points to targets near them, far from the origin, in fifty digits.")
    write("assembly.csv", links + ["crank_angle", "assembles"], assembly_cases(),
          "Linkages that just assemble with the crank on the ground line, and that just do not.")
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


if __name__ == "__main__":
    main()

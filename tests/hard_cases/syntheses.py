"""Whole problems whose optimum lies at a change point, at a toggle, at a limit of a dimension or at a cusp, with the
best value of the objective from closed forms, or from conditions of optimality solved in 120 digits. A mechanism at such
a place is none: the program keeps a millionth of its unit of length away, which is the longest length given. The tables
have the best values there and at the place itself."""
import os
import re

from mpmath import acos, asin, atan, cos, degrees, diff, findroot, mpf, pi, radians, sin, sqrt

import cams
from rows import FOLDER, between_sides, write, written

PROBLEMS = []


def problem(name, place, objective, best, mechanism, *lines):
    """A problem at a place; lines of its file, after which the objective stands. `best` says the best value by how far,
    as a length, the design has to stay away from change points, toggles and cusps."""
    text = [f'title     = "{name}"', "schema    = 1", f'mechanism = "{mechanism}"', *lines]
    way, quantity = objective.split()
    text += ["", "[objective]", f'{way} = "{quantity}"']
    PROBLEMS.append((name, place, quantity, best, "\n".join(text) + "\n"))


def dimensions(**sizes):
    """A number is given, a pair of them a range."""
    def value(size):
        return f"{{ min = {size[0]}, max = {size[1]} }}" if isinstance(size, tuple) else str(size)
    return "\n".join(["", "[dimensions]"] + [f"{name.replace('_', '-')} = {value(s)}" for name, s in sizes.items()])


def require(quantity, **limits):
    return "\n".join(["", "[[require]]", f'quantity = "{quantity}"'] + [f"{k} = {v}" for k, v in limits.items()])


def widest_swing(crank):
    """Ground 100, coupler 90, rocker 75."""
    def at(reach):
        return between_sides(mpf(100), mpf(75), reach)
    return degrees(at(90 + crank) - at(90 - crank))


def four_bars():
    # The longest crank that still turns: crank + ground = coupler + rocker. The swing grows with the crank, at its end
    # infinitely fast.
    problem("widest swing of a crank-rocker", "change point", "maximize swing",
            lambda kept: widest_swing(65 - kept), "four-bar",
            dimensions(ground=100, crank=(5, 80), coupler=90, rocker=75))
    # The ground link is shorter than the others, which are alike.
    problem("most even links", "change point", "minimize link-ratio", lambda kept: (100 + kept) / 100,
            "four-bar",
            dimensions(ground=100, crank=(10, 300), coupler=(10, 300), rocker=(10, 300)))
    # Coupler and rocker in line at the end of the motion.
    end = sqrt(mpf(100) ** 2 + 50 ** 2 - 2 * 100 * 50 * cos(radians(mpf(150))))
    problem("shortest linkage that reaches", "toggle", "minimize total-length", lambda kept: 150 + end + kept,
            "four-bar",
            dimensions(ground=100, crank=50, coupler=(10, 300), rocker=70), "", "[motion]", "crank_range = [30, 150]")
    # Without quick return ground^2 + crank^2 = coupler^2 + rocker^2 and crank = rocker sin(swing / 2), from which the
    # cosine of the worst transmission angle is ground sin(swing / 2) / coupler: the longest coupler is best.
    problem("crank-rocker without quick return", "limit of a dimension", "maximize transmission-angle-worst",
            lambda _: degrees(acos(100 * sin(radians(mpf(30))) / 90)), "four-bar",
            dimensions(ground=100, crank=(5, 60), coupler=(20, 90), rocker=(20, 300)),
            require("swing", equal=60), require("time-ratio", equal=1))


def slider_stroke(r, l, e):
    return sqrt((l + r) ** 2 - e ** 2) - sqrt((l - r) ** 2 - e ** 2)


def slider_cranks():
    problem("longest stroke of an offset slider-crank", "toggle", "maximize stroke",
            lambda kept: slider_stroke(90 - kept, mpf(100), mpf(10)), "slider-crank",
            dimensions(crank=(5, 200), rod=100, offset=10))
    problem("longest stroke in line", "toggle", "maximize stroke", lambda kept: 200 - 2 * kept, "slider-crank",
            dimensions(crank=(5, 200), rod=100, offset=0))
    problem("slider-crank with the longest rod", "limit of a dimension", "maximize transmission-angle-worst",
            lambda _: degrees(acos(mpf(50) / 300)), "slider-crank",
            dimensions(crank=(5, 200), rod=(20, 300), offset=(0, 100)), require("stroke", equal=100),
            require("time-ratio", equal=1))


def greatest_ratio(sine):
    return (pi + 2 * asin(sine)) / (pi - 2 * asin(sine))


def quick_returns():
    # The lever's end moves between lever and lever cos(swing) above its pivot: the ram line lies best in the middle.
    swing = pi / 6  # half of it; of time ratio 2: (pi + 2 swing) / (pi - 2 swing)
    lever = 100 / sin(swing)
    problem("crank shaper with the longest rod", "limit of a dimension", "maximize transmission-angle-worst",
            lambda _: degrees(acos(lever * (1 - cos(swing)) / 2 / 300)), "crank-shaper",
            dimensions(centre_distance=200, crank=(10, 199), lever=(20, 800), rod=(50, 300), ram_distance=(10, 800)),
            require("time-ratio", equal=2), require("stroke", equal=200))
    for k in (10, 15):
        crank, longer = 1 - 2.0 ** -k, 1 + 2.0 ** -k
        problem(f"slowest lever, its crank {k} bits short of the centre distance", "limit of a dimension",
                "maximize time-ratio", lambda _, x=crank: greatest_ratio(mpf(x)), "crank-shaper",
                dimensions(centre_distance=1, crank=(0.125, repr(crank)), lever=2, rod=3, ram_distance=0.001))
        problem(f"slowest Whitworth drive, its crank {k} bits past the centre distance", "limit of a dimension",
                "maximize time-ratio", lambda _, x=longer: greatest_ratio(1 / mpf(x)), "whitworth",
                dimensions(centre_distance=1, crank=(repr(longer), 8), arm=2, rod=3, slide_angle=90))
    problem("longest stroke of a Whitworth drive", "toggle", "maximize stroke", lambda kept: 200 - 2 * kept,
            "whitworth",
            dimensions(centre_distance=50, crank=120, arm=(10, 300), rod=100, slide_angle=90))
    problem("Whitworth drive with the longest rod", "limit of a dimension", "maximize transmission-angle-worst",
            lambda _: degrees(acos(mpf(100) / 400)), "whitworth",
            dimensions(centre_distance=50, crank=(51, 500), arm=(10, 300), rod=(50, 400), slide_angle=90),
            require("time-ratio", equal=2), require("stroke", equal=200))


def drag_links():
    output = {"arm_angle": 20, "slide_angle": 10}
    # The ground link turns as long as ground + crank <= coupler + follower.
    problem("shortest drag link that turns", "change point", "minimize total-length",
            lambda kept: 100 + 250 + 150 + kept + 200 + 400, "drag-link",
            dimensions(ground=100, crank=250, coupler=(50, 400), follower=200, arm=100, rod=300,
                                    slide_offset=0, **output))
    problem("longest stroke of a drag link", "toggle", "maximize stroke",
            lambda kept: slider_stroke(280 - kept, mpf(300), mpf(20)), "drag-link",
            dimensions(ground=100, crank=250, coupler=225, follower=200, arm=(50, 400), rod=300, slide_offset=20,
                       **output))
    problem("drag link with the longest arm", "limit of a dimension", "maximize stroke",
            lambda _: slider_stroke(mpf(150), mpf(400), mpf(50)), "drag-link",
            dimensions(ground=100, crank=250, coupler=225, follower=200, arm=(50, 150), rod=400, slide_offset=50,
                       **output))


def motion_lines(follower, lift, rise=60, fall=120, head=()):
    lines = ["", "[cam]", f'follower = "{follower}"', *head]
    for kind, angle in (("rise", rise), ("dwell", 30), ("return", fall), ("dwell", 330 - rise - fall)):
        lines += ["", "[[segment]]", f'kind = "{kind}"', f"angle = {angle}"]
        if kind != "dwell":
            lines += [f"lift = {lift}", 'law = "cycloidal"']
    return lines


def cusp_size(follower, angle, lift, sizes, which, start, kept):
    """The size at which the least undercut margin along a cycloidal rise, times that size, is what is kept."""
    column = cams.ANSWERS.index("undercut_margin")

    def margin(size, u):
        changed = [mpf(x) for x in sizes]
        changed[which] = size
        return cams.answers(follower, "cycloidal", 1, angle, mpf(lift), u, *changed)[column] - kept / size
    size, part = findroot(lambda x, u: (margin(x, u), diff(lambda w: margin(x, w), u)), start)
    # Nowhere else along the rise is it less.
    assert all(margin(size, mpf(i) / 512) > -mpf(10) ** -50 for i in range(513))
    return size


def cam_problems():
    rise = radians(mpf(60))
    no_undercut = require("undercut-margin", min=0)
    problem("smallest cam for a roller", "cusp", "minimize prime-radius",
            lambda kept: cusp_size("roller", rise, 20, (0, 0, 10), 0, (50, 0.7), kept), "cam", *motion_lines("roller", 20),
            dimensions(prime_radius=(12, 300), offset=0, roller_radius=10))  # that it exists is required of any cam
    problem("smallest cam for a roller on an arm", "cusp", "minimize prime-radius",
            lambda kept: cusp_size("arm", rise, radians(mpf(15)), (0, 10, 80, 60), 0, (45, 0.7), kept), "cam",
            *motion_lines("roller", 15, head=('motion = "oscillating"',)),
            dimensions(prime_radius=(25, 130), pivot_distance=80, arm_length=60, roller_radius=10), no_undercut)
    problem("smallest cam under a flat face", "cusp", "minimize base-radius",
            lambda _: cusp_size("flat", rise, 20, (0,), 0, (100, 0.7), 0), "cam", *motion_lines("flat", 20),
            dimensions(base_radius=(1, 300)), no_undercut)

    def slope(u):
        s, v, _ = cams.motion("cycloidal", rise, mpf(20), u)
        return v / (60 + s)
    at = findroot(lambda u: diff(slope, u), mpf(0.45))
    problem("flattest pressure angle on the largest cam", "limit of a dimension", "minimize pressure-angle-max",
            lambda _: degrees(atan(slope(at))), "cam", *motion_lines("knife", 20),
            dimensions(prime_radius=(20, 60), offset=0))


def file_name(name):
    return name.lower().replace(",", "").replace(" ", "-") + ".toml"


def kept_away(text):
    """A millionth of the longest length given in a problem."""
    given = re.findall(r"^(?!.*(?:angle|lift|equal|max|crank_range)).* = ([0-9.]+)$", text, re.MULTILINE)
    return max(map(mpf, given)) / 1000000


def write_tables():
    for family in (four_bars, slider_cranks, quick_returns, drag_links, cam_problems):
        family()
    os.makedirs(os.path.join(FOLDER, "syntheses"), exist_ok=True)
    rows = []
    for name, place, quantity, best, text in PROBLEMS:
        with open(os.path.join(FOLDER, "syntheses", file_name(name)), "w", encoding="ascii", newline="\n") as out:
            out.write(text)
        rows.append([name, file_name(name), place, quantity, written(best(mpf(0))), written(best(kept_away(text)))])
    write("syntheses.csv", ["name", "file", "place", "quantity", "limit", "best"], rows,
          "The best values of the problems in data/syntheses, in the units of their files, in fifty digits.")

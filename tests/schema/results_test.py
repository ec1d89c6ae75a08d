"""The schema of result documents: every document of every problem that comes with mechwright is valid, every member of
the schema is in one of them, and a member that the schema does not have makes a document invalid."""

import json
import tempfile
import unittest
from pathlib import Path

from common import PROBLEMS, SOURCE, cases_to_try, faults, run, schema_of, tables_in, validator_of

SCHEMA = schema_of("result")
VALIDATOR = validator_of(SCHEMA)

# Little time: what is found does not matter here, only what is said of it.
QUICKLY = ("--json", "--quiet", "--time-limit", "0.05")

# Solved to their end, so that what their documents say does not depend on the time that is left.
WHOLE = ["exact/five-poses", "exact/five-timed-points", "exact/reciprocal-three-points",
         "exact/velocities-of-an-instant", "cam/not-possible", "cam/eccentric", "cam/flat-harmonic", "cam/knife-table",
         "function/tangent", "function/samples", "line/lambda-120", "four-bar/crank-rocker-compact",
         "quick-return/slider-crank-not-reachable", "path/six-points-compact", "four-bar/links-from-stock",
         "four-bar/transmission-then-size"]

# What no problem that comes with mechwright has, as designs that are given.
LINKAGE = """schema = 1
mechanism = "four-bar"
[dimensions]
ground = {ground}
crank = 34
coupler = {coupler}
rocker = 70
point-along = 40
point-across = 20
"""
POINTS = """timing = "prescribed"
crank_angles = [0, 60, 120]
weights = [1, 2, 1]
"""
CAM = """schema = 1
mechanism = "cam"
[cam]
follower = "flat"
[dimensions]
base-radius = 40
[[segment]]
kind = "rise"
angle = 180
lift = 10
law = "polynomial"
start = [0, 0]
end = "R"
shape = [0]
[[segment]]
kind = "return"
angle = 180
lift = 10
law = "cycloidal"
"""
OWN_LINKS = """schema = 1
mechanism = "linkage"
[dimensions]
crank = 34
[links]
frame = { A = [0, 0], D = [100, 0] }
crank = { A = [0, 0], B = ["crank", 0] }
coupler = { B = [0, 0], C = [93, 0] }
rocker = { D = [0, 0], C = [70, 0] }
[drive]
link = "crank"
[signals]
swing = { angle = "rocker" }
bend = { curvature-of = "B" }
[[require]]
quantity = "swing.range"
min = 10
"""
SEVERAL_TARGETS = """
[[path]]
name = "upper"
point = "C"
points = [[0, 0], [10, 5], [20, 0]]
timing = "prescribed"
crank_angles = [0, 60, 120]
weights = [1, 2, 1]
[[path]]
name = "lower"
weight = 0.5
point = "B"
points = [[0, 0], [10, 5]]
timing = "prescribed"
crank_angles = [0, 60]
[poses]
name = "plate"
point = "C"
link = "coupler"
poses = [[0, 0, 0], [10, 5, 10], [20, 0]]
timing = "prescribed"
crank_angles = [0, 60, 120]
[[function]]
name = "dial"
weight = 2
signal = "swing"
expression = "x^2"
x = [1, 2]
input = { start = 10, range = 60 }
output = { start = 60, range = 30 }
[[line]]
name = "flat"
point = "C"
start = 20
range = 40
angle = 30
offset = 50
[arc]
name = "round"
point = "B"
start = 20
range = 40
centre-x = 0
centre-y = 0
radius = 30
"""
ROOMS = """
[[room]]
name = "all"
of = "mechanism"
direction = 10
[[room]]
name = "wiped"
of = ["C", "P"]
screen = [[-200, 0], [200, 0], [0, 200]]
[[region]]
name = "bay"
keep = "in"
polygon = [[-300, -300], [300, -300], [300, 300], [-300, 300]]
[[region]]
name = "post"
keep = "out"
of = ["coupler", "P"]
circle = { centre = [50, 200], radius = 10 }
margin = 2
[[region]]
name = "wall"
keep = "in"
half-plane = { through = [0, 250], direction = 180 }
[[region]]
name = "crank"
keep = "out"
of = ["D"]
link = { name = "crank", width = 8 }
"""
WHOLE_LINKAGE = LINKAGE.format(ground=100, coupler=93)
USED = '[motion]\nfrom = "first-target"\nto = "last-target"\n'
# Its face would turn with it.
NO_CAM = """schema = 1
mechanism = "cam"
[cam]
follower = "flat"
motion = "oscillating"
rotation = "ccw"
[dimensions]
base-radius = 91.4949
pivot-distance = 142.912
face-offset = -5.97594
[[segment]]
kind = "rise"
angle = 305
lift = 18
law = "3-4-5"
[[segment]]
kind = "dwell"
angle = 27
[[segment]]
kind = "return"
angle = 10
lift = 18
law = "cycloidal"
[[segment]]
kind = "dwell"
angle = 18
"""

GIVEN = {
    "whole": WHOLE_LINKAGE,
    "never assembled": LINKAGE.format(ground=1000, coupler=93),
    "close to a change point": LINKAGE.format(ground=100, coupler=64.0001),
    "rooms": WHOLE_LINKAGE + ROOMS,
    "path": WHOLE_LINKAGE + "[path]\npoints = [[0, 0], [10, 5], [20, 0]]\n" + POINTS,
    "poses": WHOLE_LINKAGE + "[poses]\nposes = [[0, 0, 0], [10, 5, 10], [20, 0]]\n" + POINTS,
    "range of use": WHOLE_LINKAGE + USED + "[path]\npoints = [[0, 0], [10, 5], [20, 0]]\n" + POINTS,
    "arc": WHOLE_LINKAGE + "[arc]\nstart = 10\nrange = 60\ncentre-x = 0\ncentre-y = 0\nradius = 50\n",
    "signals of a kind": WHOLE_LINKAGE + '[signals]\nhigh = { y = "P" }\n',
    "cam": CAM,
    "no cam": NO_CAM,
    "links of one's own": OWN_LINKS,
    "dwell": OWN_LINKS + '[objective]\nminimize = "swing.deviation(30, 60)"\n',
    "several targets": OWN_LINKS + SEVERAL_TARGETS,
}

# The same as a problem.
CHOICES = """schema = 1
mechanism = "four-bar"
[dimensions]
ground = 100
crank = { choices = [20, 30] }
coupler = 90
rocker = { choices = [40, 60, 80] }
[[require]]
quantity = "swing"
min = 45
max = 47
[objective]
minimize = "total-length"
"""

# A single start finds nothing in some parts, and there are too many combinations to search each of them.
LEFT_OUT = """schema = 1
mechanism = "four-bar"
[dimensions]
ground = 100
crank = { min = 10, max = 60, step = 5 }
coupler = { min = 50, max = 150 }
rocker = { min = 20, max = 100, step = 5 }
[[require]]
quantity = "swing"
min = 45
max = 46
[[require]]
quantity = "time-ratio"
min = 1.2
max = 1.21
[objective]
minimize = "total-length"
[solver]
starts = 1
"""

# Searches begin about the four-bar that carries the point, too.
ON_A_FOUR_BAR = """schema = 1
mechanism = "linkage"
[dimensions]
ground = { min = 50, max = 200 }
crank = { min = 20, max = 60 }
coupler = { min = 50, max = 200 }
rocker = { min = 50, max = 200 }
rod = { min = 50, max = 300 }
last = { min = 50, max = 300 }
p-x = { min = 20, max = 60 }
p-y = { min = -60, max = 60 }
[links]
frame = { A = [0, 0], D = ["ground", 0], F = [150, 0] }
crank = { A = [0, 0], B = ["crank", 0] }
coupler = { B = [0, 0], C = ["coupler", 0], P = ["p-x", "p-y"] }
rocker = { D = [0, 0], C = ["rocker", 0] }
rod = { C = [0, 0], G = ["rod", 0] }
last = { F = [0, 0], G = ["last", 0] }
[drive]
link = "crank"
[assembly]
C = { side = "either", from = "B", to = "D" }
G = { side = "either", from = "C", to = "F" }
[path]
point = "P"
points = [[30, 60], [0, 50], [-20, 20], [-10, 0], [10, 10], [40, 30], [60, 40]]
timing = "prescribed"
crank_angles = [0, 50, 110, 160, 210, 260, 310]
crank-start = { min = 0, max = 360 }
[objective]
minimize = "path-rms"
[solver]
starts = 16
"""

# Where the file of a linkage makes the names itself.
FREE = ("design", "quantities", "dimensions", "linkage")


def documents(name, *arguments):
    """What the program prints: (name, document), ..."""
    code, text, message = run(*arguments)
    assert code in (0, 4, 5, 7), (name, message)
    return [(name, json.loads(text))]


def members_of(schema, place=()):
    """Every member that a table of the schema can have, by the names that lead to it."""
    for name, below in schema.get("properties", {}).items():
        yield (*place, name)
        yield from members_of(below, (*place, name))
    if "items" in schema:
        yield from members_of(schema["items"], place)
    for one in schema.get("anyOf", []):
        yield from members_of(one, place)


class Results(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.found = documents("--all", "solve", SOURCE / "problems/exact/five-poses.toml", "--json", "--quiet", "--all")
        for name in WHOLE:
            cls.found += documents(name, "solve", SOURCE / f"problems/{name}.toml", "--json", "--quiet")
        for file in [f for f in PROBLEMS if f.parent.name != "linkage"][::cases_to_try(3, 1)]:
            cls.found += documents(file.name, "solve", file, *QUICKLY)
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        for name, text in (GIVEN | {"choices": CHOICES, "left out": LEFT_OUT, "on a four-bar": ON_A_FOUR_BAR}).items():
            file = Path(folder.name) / f"{name}.toml"
            file.write_text(text)
            cls.found += documents(name, "solve", file, "--json", "--quiet")
            if name in GIVEN:
                cls.found += documents(name, "analyse", file, "--json", "--quiet")

    def test_every_document_is_valid(self):
        self.assertGreater(len(self.found), cases_to_try(60, 100))
        for name, document in self.found:
            with self.subTest(file=name):
                self.assertEqual(faults(VALIDATOR, document), [])

    def test_a_list_of_documents_is_valid(self):
        self.assertEqual(faults(VALIDATOR, [document for _, document in self.found[:3]]), [])

    def test_every_member_of_the_schema_is_written(self):
        written = {(*place, key) for _, document in self.found for place, table in tables_in(document) for key in table}
        missing = [member for member in members_of(SCHEMA["definitions"]["result"])
                   if member not in written and (member[0] != "front" or len(member) == 1)]
        self.assertEqual(missing, [])

    def test_an_unknown_member_is_refused(self):
        seen = set()
        for name, document in self.found:
            for place, table in tables_in(document):
                mark = (document["problem"]["mechanism"], place)
                if mark in seen or (mark[0] == "linkage" and any(name in FREE for name in place)):
                    continue
                seen.add(mark)
                table["surprise"] = 1
                with self.subTest(file=name, place=".".join(place)):
                    self.assertNotEqual(faults(VALIDATOR, document), [])
                del table["surprise"]
        self.assertGreater(len(seen), 100)

    def test_documents_without_what_they_always_have_are_refused(self):
        for member in SCHEMA["definitions"]["result"]["required"]:
            document = dict(self.found[0][1])
            del document[member]
            self.assertNotEqual(faults(VALIDATOR, document), [])


if __name__ == "__main__":
    unittest.main()

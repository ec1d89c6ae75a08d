"""Drawings for CAD, read back by programs that know nothing of mechwright: ezdxf and SolveSpace."""

import csv
import io
import math
import re
import subprocess
import unittest
from pathlib import Path

import ezdxf
from common import PROBLEMS, PROGRAM, Results, run, succeed

SOLVED = ["four-bar/crank-rocker.toml", "exact/five-poses.toml", "cam/roller-offset.toml", "cam/flat-harmonic.toml",
          "quick-return/uniform-speed-drag-link.toml", "quick-return/uniform-speed-crank-shaper.toml",
          "quick-return/uniform-speed-whitworth.toml", "quick-return/slider-crank-compact.toml",
          "exact/slider-crank-four-poses.toml", "line/lambda-120.toml", "line/dwell.toml"]
NAMES = [Path(problem).stem for problem in SOLVED]


def setUpModule():  # pylint: disable=invalid-name
    global results  # pylint: disable=global-variable-undefined
    results = Results(*SOLVED)


def exported(name, ending, *options):
    file = results.folder / f"{name}.{ending}"
    succeed("export", results.result(name), "--out", file, *options)
    return file


def plane(point):
    return point[0], point[1]


def pieces(polyline):
    """Lines and arcs of a polyline, as ezdxf resolves its bulges: distance functions from a point."""
    for entity in polyline.virtual_entities():
        if entity.dxftype() == "ARC":
            yield entity.dxf.center, entity.dxf.radius, math.radians(entity.dxf.start_angle), math.radians(
                entity.dxf.end_angle)
        else:
            yield entity.dxf.start, entity.dxf.end


def distance_from(point, piece):
    x, y = point
    if len(piece) == 2:
        (ax, ay, _), (bx, by, _) = piece
        length = (bx - ax) ** 2 + (by - ay) ** 2
        share = min(1, max(0, ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / length)) if length else 0
        return math.hypot(x - ax - share * (bx - ax), y - ay - share * (by - ay))
    centre, radius, start, end = piece
    angle = math.atan2(y - centre.y, x - centre.x)
    if (angle - start) % (2 * math.pi) <= (end - start) % (2 * math.pi):
        return abs(math.hypot(x - centre.x, y - centre.y) - radius)
    return min(math.hypot(x - centre.x - radius * math.cos(a), y - centre.y - radius * math.sin(a))
               for a in (start, end))


class Dxf(unittest.TestCase):
    def test_is_without_faults(self):
        for name in NAMES:
            with self.subTest(name):
                drawing = ezdxf.readfile(exported(name, "dxf"))
                self.assertEqual(drawing.audit().errors, [])
                used = {entity.dxf.layer for entity in drawing.modelspace()}
                self.assertLessEqual(used, {layer.dxf.name for layer in drawing.layers})
                self.assertIn("PIVOTS", used)

    def test_has_the_links_where_trigonometry_has_them(self):
        design = results.document("crank-rocker")["design"]
        for angle in (0, 77.5, 210):
            drawing = ezdxf.readfile(exported("crank-rocker", "dxf", "--at", angle)).modelspace()
            line = {kind: drawing.query(f'LINE[layer=="{kind}"]').first for kind in ("CRANK", "COUPLER", "ROCKER")}
            pin = (design["crank"] * math.cos(math.radians(angle)), design["crank"] * math.sin(math.radians(angle)))
            for end, place in ((line["CRANK"].dxf.start, (0, 0)), (line["CRANK"].dxf.end, pin),
                               (line["COUPLER"].dxf.start, pin), (line["ROCKER"].dxf.start, (design["ground"], 0)),
                               (line["COUPLER"].dxf.end, plane(line["ROCKER"].dxf.end))):
                self.assertLess(math.dist(plane(end), place), 1e-12)
            for kind, drawn in line.items():
                self.assertAlmostEqual(math.dist(plane(drawn.dxf.start), plane(drawn.dxf.end)), design[kind.lower()],
                                       delta=1e-12)

    def test_has_the_coupler_curve_as_arcs(self):
        for name, fineness in (("five-poses", 1e-6), ("five-poses", 1e-3), ("lambda-120", 1e-5)):
            drawing = ezdxf.readfile(exported(name, "dxf", "--fineness", fineness)).modelspace()
            # The arrow of a guided body is on that layer, too: the curve is what has most vertices.
            curve = max(drawing.query('POLYLINE[layer=="PATH"]'), key=len)
            arcs = list(pieces(curve))
            self.assertGreater(sum(len(piece) == 4 for piece in arcs), 4)
            table = list(csv.DictReader(io.StringIO(succeed("export", results.result(name), "--format", "csv"))))
            points = [(float(row["point-x [mm]"]), float(row["point-y [mm]"])) for row in table[::5]]
            extent = 3 * max(abs(c) for point in points for c in point) + 500
            for point in points:
                self.assertLess(min(distance_from(point, piece) for piece in arcs), fineness * extent)

    def test_has_the_cam_as_arcs(self):
        for name in ("roller-offset", "flat-harmonic"):
            drawing = ezdxf.readfile(exported(name, "dxf", "--at", 0)).modelspace()
            profile = drawing.query('POLYLINE[layer=="CAM"]').first
            self.assertTrue(profile.is_closed)
            arcs = list(pieces(profile))
            table = csv.reader(io.StringIO(succeed("profile", results.result(name), "--steps", 90)))
            head = next(table)
            x, y = head.index("profile-x [mm]"), head.index("profile-y [mm]")
            for row in table:
                self.assertLess(min(distance_from((float(row[x]), float(row[y])), piece) for piece in arcs), 2e-4)

    def test_says_its_unit_and_the_names_of_the_links(self):
        drawing = ezdxf.readfile(exported("crank-rocker", "dxf"))
        self.assertEqual(drawing.header["$INSUNITS"], 4)
        names = {text.dxf.text for text in drawing.modelspace().query('TEXT[layer=="NAMES"]')}
        self.assertLessEqual({"crank", "coupler", "rocker"}, names)

    def test_has_the_roller_as_a_circle(self):
        drawing = ezdxf.readfile(exported("roller-offset", "dxf")).modelspace()
        radius = results.document("roller-offset")["design"]["roller-radius"]
        self.assertEqual([c.dxf.radius for c in drawing.query('CIRCLE[layer=="FOLLOWER"]')], [radius])

    def test_marks_the_targets(self):
        drawing = ezdxf.readfile(exported("five-poses", "dxf")).modelspace()
        centres = sorted(plane(c.dxf.center) for c in drawing.query('CIRCLE[layer=="TARGETS"]'))
        self.assertEqual(centres, sorted(tuple(p) for p in results.document("five-poses")["poses"]["points"]))


class Sketch(unittest.TestCase):
    """What SolveSpace makes of a sketch: it solves its constraints and writes the file anew."""

    def parameters(self, file):
        text = file.read_bytes().decode("latin-1")
        return {name: float(value) for name, value in
                re.findall(r"Param\.h\.v\.=([0-9a-f]+)\nParam\.val=([-0-9.]+)\n", text)}

    def lines(self, file):
        """Both ends of every line, by the number of its request."""
        text = file.read_bytes().decode("latin-1")
        requests = re.findall(r"Request\.h\.v=([0-9a-f]+)\nRequest\.type=200\n", text)
        parameters = self.parameters(file)
        return {request: [parameters.get(f"{(int(request, 16) << 16) + offset:08x}", 0.0)
                          for offset in (16, 17, 19, 20)] for request in requests}

    def regenerate(self, file):
        done = subprocess.run(["solvespace-cli", "regenerate", file], capture_output=True, text=True, check=True)
        self.assertIn("Written", done.stderr + done.stdout)

    def test_is_solved_as_it_stands(self):
        for name in NAMES:
            with self.subTest(name):
                file = exported(name, "slvs")
                before = self.parameters(file)
                self.regenerate(file)
                after = self.parameters(file)
                for number, value in before.items():
                    self.assertAlmostEqual(after.get(number, 0.0), value, delta=1e-6, msg=number)

    def test_moves_as_the_mechanism_does(self):
        for name in ("crank-rocker", "uniform-speed-drag-link", "uniform-speed-crank-shaper",
                     "uniform-speed-whitworth", "slider-crank-compact"):
            with self.subTest(name):
                file = exported(name, "slvs", "--at", 100)
                before = self.lines(file)
                crank = min(before, key=lambda number: int(number, 16))
                ax, ay, bx, by = before[crank]
                # The crank pin is put a little further, in every line that ends there: the others must follow.
                turn = math.radians(2)
                text = file.read_bytes()
                for old, new in ((bx, ax + (bx - ax) * math.cos(turn) - (by - ay) * math.sin(turn)),
                                 (by, ay + (bx - ax) * math.sin(turn) + (by - ay) * math.cos(turn))):
                    text = text.replace(f"Param.val={old:.20f}\n".encode(), f"Param.val={new:.20f}\n".encode())
                file.write_bytes(text)
                self.regenerate(file)
                after = self.lines(file)
                self.assertGreater(math.dist(after[crank][2:], before[crank][2:]), 0.01 * math.hypot(bx - ax, by - ay))
                moved = 0
                for number, (ax, ay, bx, by) in before.items():
                    length = math.hypot(bx - ax, by - ay)
                    cx, cy, dx, dy = after[number]
                    self.assertAlmostEqual(math.hypot(dx - cx, dy - cy), length, delta=1e-6 * length)
                    moved += math.hypot(cx - ax, cy - ay) + math.hypot(dx - bx, dy - by) > 1e-3 * length
                self.assertGreaterEqual(moved, 2 if name.startswith("slider") else 3)

    def test_is_exported_by_solvespace_with_the_same_lines(self):
        file = exported("crank-rocker", "slvs", "--at", 60)
        subprocess.run(["solvespace-cli", "export-wireframe", "--output", "%-again.dxf", file.name], check=True,
                       capture_output=True, cwd=results.folder)
        again = ezdxf.readfile(results.folder / "crank-rocker-again.dxf").modelspace()
        points = [plane(v) for entity in again for v in
                  ([entity.dxf.start, entity.dxf.end] if entity.dxftype() == "LINE" else
                   entity.points() if entity.dxftype() == "POLYLINE" else [])]
        for expected in self.lines(file).values():
            for end in (expected[:2], expected[2:]):
                self.assertLess(min(math.dist(end, point) for point in points), 1e-4)


class Pictures(unittest.TestCase):
    def test_are_what_their_names_say(self):
        for ending, start in (("png", b"\x89PNG"), ("pdf", b"%PDF"), ("svg", b"<svg")):
            file = results.folder / f"crank-rocker.{ending}"
            succeed("draw", results.result("crank-rocker"), "--out", file, "--plots")
            self.assertTrue(file.read_bytes().startswith(start))

    def test_are_as_wide_as_asked_for(self):
        # pylint: disable=import-outside-toplevel
        from PIL import Image

        file = results.folder / "wide.png"
        succeed("draw", results.result("roller-offset"), "--out", file, "--width", 400)
        image = Image.open(file).convert("RGB")
        self.assertEqual(image.size[0], 800)
        self.assertGreater(len(image.getcolors(1 << 24)), 10)
        self.assertEqual(image.getpixel((2, 2)), (255, 255, 255))

    def test_faults_are_named(self):
        for arguments, code, what in (
                (("draw", results.result("crank-rocker"), "--out", "picture.bmp"), 2, "must end in .svg, .png, .pdf, or .gif"),
                (("draw", results.result("crank-rocker"), "--out", "a.dxf"), 2, "; mechwright export writes .dxf"),
                (("draw", "nowhere.json"), 6, "nowhere.json: "),
                (("draw", results.result("crank-rocker"), "--alternative", 7), 2, "--alternative 7"),
                (("draw", PROBLEMS / "four-bar/crank-rocker.toml"), 3, "leaves something to be designed"),
                (("export", results.result("crank-rocker")), 2, "--out FILE or --format NAME"),
                (("export", results.result("crank-rocker"), "--format", "dfx"), 2, "did you mean 'dxf'?"),
                (("export", results.result("crank-rocker"), "--out", "/proc/x.dxf"), 6, "/proc/x.dxf")):
            got, out, err = run(*arguments)
            self.assertEqual((got, out), (code, ""), err)
            self.assertIn(what, err)

    def test_without_their_programs_say_which_is_missing(self):
        # On this path there is neither gnuplot nor rsvg-convert.
        for options, missing in ((["--out", str(results.folder / "x.png")], "rsvg-convert"), (["--plots"], "gnuplot")):
            done = subprocess.run([PROGRAM, "draw", results.result("crank-rocker"), *options],
                                  env={"PATH": str(results.folder)}, capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 6)
            self.assertIn(f"there is no {missing}: install it", done.stderr)
        done = subprocess.run([PROGRAM, "report", results.result("crank-rocker")],
                              env={"PATH": str(results.folder)}, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0)
        self.assertIn("no plots for browsers without scripts", done.stderr)


if __name__ == "__main__":
    unittest.main(warnings="ignore")

"""analyse() and verify() against the program, and against what is known of four-bars."""

import copy
import csv
import io
import json
import unittest

import mechwright
import numpy as np
from common import PROBLEMS, Folder, given_linkage, plain, run, solved_by_program
from solve_test import FILES, solved

GIVEN = """schema = 1
mechanism = "four-bar"
{more}
[dimensions]
ground = 100
crank = {crank}
coupler = 93
rocker = 70
point-along = 40
point-across = 20
"""


def given_file(folder, crank=34, more=""):
    return folder.write("given.toml", GIVEN.format(crank=crank, more=more))


def table_of_program(file, *options):
    rows = list(csv.reader(io.StringIO(run("analyse", file, "--csv", *options)[1])))
    names = [name.split(" [")[0] for name in rows[0]]
    return plain({name: [float(row[c]) for row in rows[1:]] for c, name in enumerate(names)})


class TheSameAsTheProgram(unittest.TestCase):
    def setUp(self):
        self.folder = Folder(self)

    def test_the_motion(self):
        files = [given_file(self.folder), PROBLEMS / "quick-return/drag-link-given.toml"]
        for file in files:
            for steps in (1, 7, 360):
                with self.subTest(file=file.name, steps=steps):
                    motion = mechwright.analyse(file, steps=steps)["motion"]
                    self.assertEqual(plain(motion), table_of_program(file, "--steps", steps))
                    self.assertEqual(list(motion), list(table_of_program(file)))

    def test_the_motion_of_a_linkage_that_cannot_turn(self):
        file = given_file(self.folder, crank=90)
        motion = mechwright.analyse(file)["motion"]
        self.assertEqual(plain(motion), table_of_program(file))
        self.assertLess(np.ptp(motion["crank-angle"]), 359)

    def test_the_motion_in_radians(self):
        file = given_file(self.folder, more='[units]\nangle = "rad"\n')
        self.assertEqual(plain(mechwright.analyse(file)["motion"]), table_of_program(file))

    def test_a_mechanism_that_does_not_assemble(self):
        analysis = mechwright.analyse(given_file(self.folder, crank=900))
        self.assertEqual(analysis["quantities"], {})
        self.assertEqual(analysis["motion"]["rocker-angle"].shape, (0,))

    def test_the_document(self):
        for file in (given_file(self.folder), PROBLEMS / "quick-return/drag-link-given.toml"):
            analysis = plain(mechwright.analyse(file))
            del analysis["motion"]
            self.assertEqual(analysis, json.loads(run("analyse", file, "--json")[1]))

    def test_what_is_open_is_named(self):
        file = PROBLEMS / "four-bar/crank-rocker.toml"
        with self.assertRaises(mechwright.ProblemError) as caught:
            mechwright.analyse(file)
        self.assertEqual(f"{caught.exception}\n", run("analyse", file)[2])


class CrankAngles(unittest.TestCase):
    def test_they_come_back_in_their_shape(self):
        asked = np.arange(0, 360, 15.0).reshape(4, 6)
        motion = mechwright.analyse(given_linkage(), crank_angles=asked)["motion"]
        for name, column in motion.items():
            self.assertEqual(column.shape, (4, 6), name)
            self.assertEqual(column.dtype, np.float64, name)
        np.testing.assert_allclose(motion["crank-angle"], asked, rtol=1e-15)

    def test_they_are_those_of_the_steps(self):
        steps = mechwright.analyse(given_linkage(), steps=360)["motion"]
        asked = mechwright.analyse(given_linkage(), crank_angles=list(range(361)))["motion"]
        for name in steps:
            np.testing.assert_allclose(asked[name], steps[name], rtol=1e-13, atol=1e-13)

    def test_every_kind_of_array(self):
        expected = mechwright.analyse(given_linkage(), crank_angles=[10, 20, 30])["motion"]["rocker-angle"]
        whole = np.arange(60)
        for asked in ((10, 20, 30), np.array([10, 20, 30], dtype=np.uint8), whole[10:31:10],
                      np.array([10, 20, 30], dtype=">f4"), range(10, 31, 10)):
            np.testing.assert_array_equal(
                mechwright.analyse(given_linkage(), crank_angles=asked)["motion"]["rocker-angle"], expected)
        one = mechwright.analyse(given_linkage(), crank_angles=20)["motion"]["rocker-angle"]
        self.assertEqual((one.shape, float(one)), ((), expected[1]))
        none = mechwright.analyse(given_linkage(), crank_angles=[])["motion"]["rocker-angle"]
        self.assertEqual(none.shape, (0,))

    def test_the_loop_closes(self):
        angle = np.linspace(0, 360, 100)
        motion = mechwright.analyse(given_linkage(), crank_angles=angle)["motion"]
        pin = 34 * np.exp(1j * np.radians(angle)) + 93 * np.exp(1j * np.radians(motion["coupler-angle"]))
        np.testing.assert_allclose(pin, 100 + 70 * np.exp(1j * np.radians(motion["rocker-angle"])), atol=1e-11)

    def test_nan_where_it_does_not_assemble(self):
        linkage = given_linkage()
        linkage["dimensions"]["crank"] = 90.0
        asked = [30.0, 60.0, 180.0, np.nan, np.inf, 1e300]
        motion = mechwright.analyse(linkage, crank_angles=asked)["motion"]
        for column in motion.values():
            self.assertEqual(np.isnan(column[:5]).tolist(), [False, False, True, True, True])

    def test_what_is_no_array_of_numbers(self):
        for asked in ("abc", [[1], [2, 3]], {"a": 1}, object(), [1j]):
            with self.assertRaises((TypeError, ValueError)):
                mechwright.analyse(given_linkage(), crank_angles=asked)

    def test_steps_out_of_range(self):
        for steps in (0, -1, 10**6 + 1):
            with self.assertRaisesRegex(ValueError, "steps"):
                mechwright.analyse(given_linkage(), steps=steps)


class OfResults(unittest.TestCase):
    """What solve returned can be analysed and verified, as a dict and from a file."""

    def assert_close(self, one, other, place):
        """Equal but for numbers, which may differ in their last digits: angles are rounded where they are written."""
        self.assertEqual(type(one), type(other), place)
        if isinstance(one, dict):
            self.assertEqual(list(one), list(other), place)
            for name in one:
                self.assert_close(one[name], other[name], f"{place}.{name}")
        elif isinstance(one, list):
            self.assertEqual(len(one), len(other), place)
            for a, b in zip(one, other):
                self.assert_close(a, b, place)
        elif isinstance(one, float):
            np.testing.assert_allclose(one, other, rtol=1e-11, atol=1e-11, err_msg=place)
        else:
            self.assertEqual(one, other, place)

    def test_the_findings_of_the_result(self):
        folder = Folder(self)
        for name in FILES:
            result = copy.deepcopy(solved(PROBLEMS / name))
            if "design" not in result:
                continue
            file = folder.write("result.json", json.dumps(plain(result)))
            with self.subTest(name):
                analysis = plain(mechwright.analyse(result))
                again = plain(mechwright.analyse(file))
                self.assertEqual(again, analysis)
                # Angles are read in degrees and told in degrees, by way of radians: to rounding the same.
                self.assert_close(analysis["design"], plain(result)["design"], "design")
                self.assertGreater(len(next(iter(analysis["motion"].values()))), 100)
                result["problem"].pop("text", None)  # an analysis is not of a problem file
                for member in ("problem", "units", "design", "dimensions", "quantities", "requirements", "objective",
                               "path", "poses", "function", "line", "arc", "settings", "tolerance"):
                    self.assert_close(analysis.get(member), plain(result).get(member), member)

    def test_the_motion_of_a_result_is_that_of_its_dimensions(self):
        result = mechwright.solve(PROBLEMS / "four-bar/crank-rocker.toml")
        given = given_linkage()
        given["dimensions"] = {name: result["design"][name] for name in ("ground", "crank", "coupler", "rocker")}
        self.assertEqual(plain(mechwright.analyse(result)["motion"]), plain(mechwright.analyse(given)["motion"]))

    def test_verification(self):
        result = mechwright.solve(PROBLEMS / "four-bar/crank-rocker.toml")
        again = mechwright.verify(result)
        self.assertTrue(again["passed"])
        for check in result["verification"]["checks"]:
            self.assertIn(check, again["checks"])
        result["design"]["crank"] += 0.001
        again = mechwright.verify(result)
        self.assertFalse(again["passed"])
        self.assertIn("swing equals 60 deg", [check["name"] for check in again["checks"] if not check["passed"]])

    def test_verification_of_every_kind_of_result(self):
        for name in FILES:
            result = solved(PROBLEMS / name)
            with self.subTest(name):
                if "verification" in result:
                    # That of a finished document looks at the proof and the other designs, too.
                    again = mechwright.verify(result)
                    self.assertEqual(again["passed"], result["verification"]["passed"])
                    for check in result["verification"]["checks"]:
                        self.assertIn(check, again["checks"])

    def test_a_changed_file_fails_as_in_the_program(self):
        document = solved_by_program(PROBLEMS / "four-bar/crank-rocker.toml")
        document["design"]["rocker"] = 71.0
        file = Folder(self).write("changed.json", json.dumps(document))
        failed = [check for check in mechwright.verify(str(file))["checks"] if not check["passed"]]
        self.assertGreater(len(failed), 0)
        self.assertIn(f"{len(failed)} of ", run("verify", file)[1])

    def test_what_is_no_result(self):
        folder = Folder(self)
        for text in ("", "{", "[]", "7", '{"schema": 2, "problem": {}}', '{"schema": "1"}', '{"schema": 1}',
                     '{"schema": 1, "problem": 3}', "\xff\xfe", '{"a": 1e999}', "[" * 100):
            file = folder.write("no.json", text)
            with self.subTest(text):
                message = run("verify", file)[2]
                for function in (mechwright.verify, mechwright.analyse):
                    with self.assertRaises(ValueError) as caught:
                        function(file)
                    if not text.startswith("[]"):
                        self.assertEqual(f"mechwright: {caught.exception}\n", message)

    def test_a_design_that_is_none(self):
        result = mechwright.solve(PROBLEMS / "four-bar/crank-rocker.toml")
        for change in ({"crank": -3.0}, {"crank": "long"}, {"crank": None}, {"crank": float("nan")},
                       {"assembly": "neither"}, {"wing": 3}):
            broken = {**result, "design": {**result["design"], **change}}
            with self.subTest(change):
                with self.assertRaisesRegex(ValueError, "<dict>: not a result document: .*"):
                    mechwright.analyse(broken)
                self.assertFalse(mechwright.verify(broken)["passed"])
        broken.pop("design")
        with self.assertRaisesRegex(ValueError, "not a result document: the document has no design"):
            mechwright.analyse(broken)

    def test_a_file_that_is_not_there(self):
        for function in (mechwright.verify, mechwright.analyse):
            with self.assertRaises(OSError) as caught:
                function("/nowhere/result.json")
            self.assertEqual(f"mechwright: {caught.exception}\n", run("verify", "/nowhere/result.json")[2])


if __name__ == "__main__":
    unittest.main()

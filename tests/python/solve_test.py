"""solve() gives what the program gives, digit for digit, whether the problem is a file or a dict."""

import functools
import inspect
import os
import unittest
from pathlib import Path

import mechwright
import numpy as np
from common import (POINTS, PROBLEMS, Folder, but_for_time, cases_to_try, crank_rocker, given_linkage, long_search,
                    path_search, plain, run, solved_by_program, table_of, without_file)

# One of each mechanism and of each kind of target.
FILES = [
    "four-bar/crank-rocker.toml",
    "four-bar/transmission-not-reachable.toml",
    "quick-return/whitworth.toml",
    "quick-return/drag-link-given.toml",
    "cam/roller-harmonic.toml",
    "cam/choice-of-law.toml",
    "cam/oscillating-roller.toml",
    "cam/knife-table.toml",
    "function/power.toml",
    "function/ram-square.toml",
    "poses/tipper.toml",
    "path/case-2.toml",
    "line/hoekens-180.toml",
    "exact/five-timed-points.toml",
    "exact/three-poses-four-points.toml",
    "exact/velocities-of-an-instant.toml",
    "studies/transmission-chart.toml",
]


@functools.cache
def solved(file):
    return mechwright.solve(file)


class TheSameAsTheProgram(unittest.TestCase):
    def test_the_result_of_a_file(self):
        for name in FILES[::cases_to_try(2, 1)]:
            with self.subTest(name):
                file = PROBLEMS / name
                self.assertEqual(but_for_time(plain(solved(file))), but_for_time(solved_by_program(file)))

    def test_the_result_of_a_dict(self):
        for name in FILES[::cases_to_try(4, 1)]:
            with self.subTest(name):
                file = PROBLEMS / name
                self.assertEqual(without_file(plain(mechwright.solve(table_of(file)))),
                                 without_file(plain(solved(file))))

    def test_the_order_of_members(self):
        file = PROBLEMS / "four-bar/crank-rocker.toml"
        self.assertEqual(list(mechwright.solve(str(file))), list(solved_by_program(file)))

    def test_options(self):
        file = PROBLEMS / "path/case-2.toml"
        result = mechwright.solve(file, jobs=1, method="slsqp", seed=7, time_limit=50)
        again = solved_by_program(file, "--method", "slsqp", "--seed", 7, "--time-limit", 50, "--jobs", 2)
        self.assertEqual(but_for_time(plain(result)), but_for_time(again))
        self.assertEqual((result["search"]["method"], result["search"]["seed"]), ("slsqp", 7))

    def test_all_designs_of_an_exact_method(self):
        file = PROBLEMS / "exact/three-poses-four-points.toml"
        result = mechwright.solve(file, all=True)
        self.assertEqual(but_for_time(plain(result)), but_for_time(solved_by_program(file, "--all")))
        self.assertTrue(any("defect" in one for one in result["alternatives"]))
        self.assertFalse(any("defect" in one for one in mechwright.solve(file)["alternatives"]))


class KnownOptima(unittest.TestCase):
    def test_the_crank_rocker_of_the_readme(self):
        result = mechwright.solve(crank_rocker())
        self.assertEqual(result["status"], "solved")
        self.assertAlmostEqual(result["objective"]["value"], 45.008219, places=6)
        self.assertAlmostEqual(result["design"]["crank"], 34.099741, places=6)

    def test_the_drag_link_of_the_readme(self):
        result = mechwright.solve(PROBLEMS / "quick-return/uniform-speed-drag-link.toml")
        self.assertTrue(result["verification"]["passed"])
        self.assertAlmostEqual(result["objective"]["value"], 0.079614628, places=8)
        self.assertAlmostEqual(mechwright.analyse(result)["quantities"]["stroke"], 200, places=6)

    def test_what_is_not_found_is_no_exception(self):
        result = mechwright.solve(PROBLEMS / "four-bar/transmission-not-reachable.toml")
        self.assertEqual(result["status"], "infeasible")
        self.assertIn("note", result)

    def test_a_time_limit(self):
        result = mechwright.solve(long_search(), time_limit=0.3)
        self.assertEqual(result["status"], "limit")
        self.assertLess(result["search"]["seconds"], 20)


class NumPy(unittest.TestCase):
    """Arrays in mean what lists of the same numbers mean; arrays come out."""

    def solved(self, points, **more):
        problem = path_search(points, starts=1)
        problem["path"].update(more)
        return without_file(plain(mechwright.solve(problem)))

    def test_arrays_of_every_kind_in(self):
        of_lists = self.solved(POINTS)
        array = np.array(POINTS, dtype=float)
        wide = np.zeros((len(POINTS), 4))
        wide[:, ::2] = array
        fortran = np.asfortranarray(array)
        read_only = array.copy()
        read_only.flags.writeable = False
        for name, points in {
                "float64": array, "float32": array.astype(np.float32), "float16": array.astype(np.float16),
                "longdouble": array.astype(np.longdouble), "int64": array.astype(int),
                "uint8": array.astype(np.uint8), "big-endian": array.astype(">f8"), "not contiguous": wide[:, ::2],
                "reversed twice": array[::-1][::-1], "Fortran": fortran, "read-only": read_only,
                "objects": array.astype(object), "list of arrays": list(array),
                "tuples": tuple(map(tuple, POINTS))}.items():
            with self.subTest(name):
                self.assertEqual(self.solved(points), of_lists)

    def test_scalars_in(self):
        expected = without_file(plain(mechwright.solve(crank_rocker())))
        problem = crank_rocker()
        problem["schema"] = np.int64(1)
        problem["dimensions"]["ground"] = np.float32(100)
        problem["dimensions"]["crank"] = {"min": np.uint8(5), "max": np.array(60)}
        problem["dimensions"]["coupler"] = {"min": np.float64(20), "max": np.float16(300)}
        problem["require"] = tuple(problem["require"])
        problem["objective"]["maximize"] = np.str_("transmission-angle-worst")
        self.assertEqual(without_file(plain(mechwright.solve(problem))), expected)

    def test_truth_values_in(self):
        closed = self.solved(POINTS, closed=True)
        self.assertEqual(self.solved(POINTS, closed=np.True_), closed)
        self.assertTrue(closed["path"]["closed"])

    def test_doubles_survive_to_the_last_digit(self):
        values = [0.1 + 0.2, np.nextafter(35, 36), 1e-300 + 30, 1 / 3 * 100]
        for value in values:
            problem = given_linkage()
            problem["dimensions"]["ground"] = value
            self.assertEqual(mechwright.analyse(problem)["design"]["ground"], value)

    def test_arrays_out(self):
        path = mechwright.solve(path_search(np.array(POINTS), starts=1))["path"]
        for name, shape in {"points": (9, 2), "reached": (9, 2), "crank_angles": (9,), "distances": (9,)}.items():
            self.assertIsInstance(path[name], np.ndarray, name)
            self.assertEqual(path[name].dtype, np.float64, name)
            self.assertEqual(path[name].shape, shape, name)
        np.testing.assert_allclose(np.hypot(*(path["points"] - path["reached"]).T), path["distances"], atol=1e-12)

    def test_what_is_no_list_of_numbers_stays_a_list(self):
        result = mechwright.solve(PROBLEMS / "cam/choice-of-law.toml")
        self.assertIsInstance(result["design"]["laws"], list)
        self.assertIsInstance(result["alternatives"], list)
        self.assertIsInstance(result["verification"]["checks"], list)

    def test_a_direction_that_does_not_matter_is_nan(self):
        poses = mechwright.solve(PROBLEMS / "exact/three-poses-four-points.toml")["poses"]
        self.assertEqual(np.count_nonzero(np.isnan(poses["directions"])), 4)
        self.assertEqual(poses["directions"].dtype, np.float64)

    def test_the_array_that_is_given_is_left_alone(self):
        points = np.array(POINTS, dtype=float)
        before = points.copy()
        result = mechwright.solve(path_search(points, starts=1))
        result["path"]["points"][:] = 0
        np.testing.assert_array_equal(points, before)


class Paths(unittest.TestCase):
    def test_every_kind_of_path(self):
        file = PROBLEMS / "four-bar/crank-rocker.toml"

        class Own:
            def __fspath__(self):
                return str(file)

        for path in (str(file), file, Own()):
            self.assertEqual(mechwright.solve(path)["problem"]["file"], str(file))

    def test_a_name_beyond_ascii_and_one_that_is_not_utf8(self):
        folder = Folder(self)
        text = (PROBLEMS / "four-bar/crank-rocker.toml").read_text()
        self.assertEqual(mechwright.solve(folder.write("Kurbelschwinge-ü.toml", text))["status"], "solved")
        name = os.fsdecode(b"\xff.toml")
        self.assertEqual(mechwright.solve(folder.write(name, text))["status"], "solved")

    def test_files_named_in_a_dict_are_looked_for_in_the_current_folder(self):
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        folder = Folder(self)
        folder.write("points.csv", "x,y\n" + "".join(f"{x},{y}\n" for x, y in POINTS))
        problem = path_search([], starts=1)
        problem["path"] = {"points_file": "points.csv"}
        with self.assertRaisesRegex(OSError, "points.csv"):
            mechwright.solve(problem)
        os.chdir(folder.path)
        named = without_file(plain(mechwright.solve(problem)))
        self.assertEqual(named, without_file(plain(mechwright.solve(path_search(POINTS, starts=1)))))


class Module(unittest.TestCase):
    def test_version(self):
        self.assertIn(mechwright.__version__, run("--version")[1])

    def test_quantities(self):
        listed = run("quantities", "four-bar")[1]
        quantities = mechwright.quantities("four-bar")
        self.assertEqual(quantities["swing"]["unit"], "angle")
        for name, one in quantities.items():
            self.assertRegex(listed, rf"(?m)^  {name} +{one['unit']} ")
        self.assertEqual(len(quantities), sum(line.startswith("  ") and line[2] != " " for line in listed.splitlines()))

    def test_an_unknown_mechanism(self):
        with self.assertRaises(ValueError) as caught:
            mechwright.quantities("four-barr")
        self.assertEqual(f"mechwright: {caught.exception}\n", run("quantities", "four-barr")[2])

    def test_everything_says_what_it_does(self):
        for one in (mechwright, *(getattr(mechwright, name) for name in mechwright.__all__)):
            self.assertGreater(len(one.__doc__), 50)

    def test_what_is_public_has_types(self):
        for name in mechwright.__all__:
            one = getattr(mechwright, name)
            functions = [one] if inspect.isfunction(one) else [f for f in vars(one).values() if inspect.isfunction(f)]
            for function in functions:
                parameters = inspect.signature(function).parameters
                self.assertEqual(set(function.__annotations__), {*parameters, "return"} - {"self"}, function)
        self.assertTrue(Path(mechwright.__file__).with_name("py.typed").exists())


if __name__ == "__main__":
    unittest.main()

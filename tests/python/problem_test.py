"""Problems as values: made in every way, changed, compared, written and solved."""

import copy
import pickle
import tomllib
import unittest
import warnings

import mechwright
import numpy as np
from common import POINTS, PROBLEMS, Folder, crank_rocker, path_search, plain, run, table_of, without_file
from solve_test import FILES

FILE = PROBLEMS / "four-bar/crank-rocker.toml"


class Made(unittest.TestCase):
    def test_in_every_way_it_is_the_same(self):
        table = table_of(FILE)
        made = [mechwright.Problem(FILE), mechwright.Problem(str(FILE)), mechwright.Problem(table),
                mechwright.Problem.from_toml(FILE.read_text()), mechwright.Problem(**table),
                mechwright.Problem(mechwright.Problem(FILE)), mechwright.Problem(FILE, title=table["title"])]
        for problem in made:
            self.assertEqual(problem, made[0])
            self.assertEqual(problem, table)
            self.assertEqual(without_file(plain(problem.solve())), without_file(plain(mechwright.solve(FILE))))

    def test_keywords_take_the_place_of_sections(self):
        problem = mechwright.Problem(FILE, title="Another", quick_return={"working-share": 0.5})
        self.assertEqual(problem, {**table_of(FILE), "title": "Another", "quick-return": {"working-share": 0.5}})
        self.assertNotEqual(problem, mechwright.Problem(FILE))
        self.assertEqual(mechwright.Problem(mechanism="four-bar"), {"schema": 1, "mechanism": "four-bar"})

    def test_it_owns_what_it_was_made_from(self):
        table = crank_rocker()
        problem = mechwright.Problem(table)
        table["dimensions"]["crank"]["max"] = 1
        self.assertEqual(problem.dimensions.crank.max, 60)
        points = np.array([[1.0, 2], [3, 4]])
        problem = mechwright.Problem(path_search(points))
        points[:] = 0
        self.assertEqual(problem.path.points, [[1, 2], [3, 4]])

    def test_what_no_file_holds_is_refused_with_its_key(self):
        broken = crank_rocker()
        broken["require"][0]["equal"] = None
        with self.assertRaisesRegex(TypeError, r"^require\[0\]\.equal: "):
            mechwright.Problem(broken)

    def test_messages_about_a_file_and_a_text_name_lines(self):
        file = Folder(self).write("bad.toml", FILE.read_text().replace("ground  = 100.0", "ground = -1"))
        for make in (lambda: mechwright.Problem(file), lambda: mechwright.Problem.from_toml(file.read_text(), str(file))):
            with self.assertRaises(mechwright.ProblemError) as caught:
                make()
            self.assertEqual(f"{caught.exception}\n", run("check", file)[2])
        with self.assertRaises(OSError):
            mechwright.Problem("/nowhere/problem.toml")

    def test_copies(self):
        problem = mechwright.Problem(FILE)
        for one in (copy.copy(problem), copy.deepcopy(problem), pickle.loads(pickle.dumps(problem))):
            self.assertIsInstance(one, mechwright.Problem)
            self.assertEqual(one, problem)
            self.assertEqual(one.solve().problem.file, str(FILE))

    def test_its_representation_makes_it_again(self):
        problem = mechwright.Problem(crank_rocker())
        self.assertEqual(eval(repr(problem), {"Problem": mechwright.Problem}), problem)


class Changed(unittest.TestCase):
    def test_attributes(self):
        problem = mechwright.Problem(FILE)
        problem.dimensions.crank.max = 50
        problem.objective = {"minimize": "total-length"}
        problem.quick_return = {"working-share": 0.5}
        self.assertEqual(problem["dimensions"]["crank"], {"min": 5, "max": 50})
        self.assertEqual(problem.objective.minimize, "total-length")
        self.assertEqual(problem["quick-return"].working_share, 0.5)
        self.assertIsNone(problem.solver)
        self.assertIn("dimensions", dir(problem))
        for name in ("dimension", "objectives"):
            with self.assertRaisesRegex(AttributeError, f"'{name}' is not known here; did you mean '{name[:9]}"):
                getattr(problem, name)
        problem.dimension = {}
        with self.assertRaisesRegex(mechwright.ProblemError, "(?m)^dimension: unknown key 'dimension'"):
            problem.check()

    def test_then_messages_name_keys_and_files_stand_where_they_stood(self):
        folder = Folder(self)
        folder.write("points.csv", "".join(f"{x},{y}\n" for x, y in POINTS))
        table = path_search([], starts=1)
        table["path"] = {"points_file": "points.csv"}
        file = folder.path / "problem.toml"
        mechwright.Problem(table).save(file)
        problem = mechwright.Problem(file)
        problem.solver.seed = 2
        self.assertEqual(problem.solve().search.seed, 2)
        problem.dimensions.crank = -3
        with self.assertRaisesRegex(mechwright.ProblemError, "^dimensions.crank: 'crank' is a length"):
            problem.check()
        self.assertEqual(mechwright.Problem(file).solve().problem.file, str(file))

    def test_every_fault_of_a_study_is_named(self):
        problem = crank_rocker()
        problem["study"] = {"require.swing.equal": [60, "wide"]}
        with self.assertRaisesRegex(mechwright.ProblemError, r"^study: \[study\] with require.swing.equal = "):
            mechwright.solve(problem)

    def test_warnings_are_shown_where_the_package_was_called(self):
        problem = mechwright.Problem(mechanism="four-bar", require=[{"quantity": "swing", "equal": 60}],
                                     dimensions={"ground": 100, "crank": 34, "coupler": 93, "rocker": 70})
        for call in (problem.check, problem.solve, lambda: mechwright.solve(problem)):
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                call()
            self.assertEqual([one.filename for one in caught], [__file__])


class Written(unittest.TestCase):
    def test_a_file_that_was_read_is_written_as_it_was(self):
        problem = mechwright.Problem(FILE)
        self.assertEqual(problem.to_toml(), FILE.read_text())
        problem.title = "Another"
        self.assertEqual(tomllib.loads(problem.to_toml()), problem)

    def test_every_problem_reads_back(self):
        odd = {**crank_rocker(), "title": "\0\x1b\r\n\t\"'\\ü\u2028😀'''\"\"\" # \\u0041"}
        odd["dimensions"]["ground"] = 0.1 + 0.2
        odd["study"] = {"require.swing.equal": {"from": 1e-30, "to": 100.0, "count": 3}}
        for table in [odd, *(table_of(PROBLEMS / name) for name in FILES)]:
            self.assertEqual(tomllib.loads(mechwright.Problem(table).to_toml()), table)

    def test_the_document_of_a_dict_has_a_problem_that_asks_for_the_same(self):
        for name in FILES:
            result = mechwright.solve(table_of(PROBLEMS / name))
            with self.subTest(name):
                if "text" in result["problem"] and "design" in result:
                    checks = {one.name: one.passed for one in result.verify().checks}
                    self.assertTrue(checks["asks for what its problem does"])


if __name__ == "__main__":
    unittest.main()

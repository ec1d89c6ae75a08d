"""study() and compare() against the program."""

import csv
import io
import json
import os
import signal
import threading
import unittest
import warnings

import mechwright
import numpy as np
from common import PROBLEMS, Folder, but_for_time, crank_rocker, given_linkage, plain, run

STUDY = {
    **given_linkage(),
    "title": "Cranks",
    "study": {"quantities": ["swing"], "dimensions.crank": {"from": 30, "to": 36, "count": 7}},
}
TEXT = """schema = 1
title = "Cranks"
mechanism = "four-bar"
dimensions = { ground = 100, crank = 34, coupler = 93, rocker = 70 }
[study]
quantities = ["swing"]
"dimensions.crank" = { from = 30, to = 36, count = 7 }
"""


class Studies(unittest.TestCase):
    def setUp(self):
        self.folder = Folder(self)

    def test_it_has_the_data_of_the_program(self):
        file = self.folder.write("study.toml", TEXT)
        self.assertEqual(run("study", file, "--out", self.folder.path / "a", "--quiet")[0], 0)
        printed = json.loads(run("study", "export", self.folder.path / "a", "--json")[1])
        for given in (file, mechwright.Problem(file), STUDY):
            study = mechwright.study(given, jobs=1)
            data = study.data()
            self.assertEqual(list(data), list(printed[0]))
            np.testing.assert_array_equal(data["dimensions.crank"], np.linspace(30, 36, 7))
            np.testing.assert_array_equal(data.swing, [row["swing"] for row in printed])
            self.assertEqual(data.status, [row["status"] for row in printed])

    def test_what_it_has_come_to(self):
        chart = {"kind": "curves", "name": "swings", "x": "dimensions.crank", "value": "swing"}
        study = mechwright.study({**STUDY, "study": {**STUDY["study"], "chart": [chart]}})
        self.assertEqual((study.title, study.points, study.done, study.complete), ("Cranks", 7, 7, True))
        self.assertEqual(sum(study.statuses.values()), 7)
        self.assertEqual(json.loads(study.to_json())["points"], 7)
        self.assertIn("7 of 7 points", repr(study))
        html = study._repr_html_()
        self.assertIn("<td>7</td>", html)
        self.assertIn("<svg", html)
        self.assertEqual(list(study.charts()), ["swings"])
        self.assertTrue(study.charts()["swings"].startswith("<svg"))
        self.assertEqual(mechwright.study(STUDY).charts(), {})

    def test_a_folder_keeps_it(self):
        place = self.folder.path / "kept"
        study = mechwright.study(STUDY, place)
        self.assertEqual(mechwright.study(STUDY, place), study)
        self.assertEqual(mechwright.Study(place).data(), study.data())
        page = mechwright.report(place, self.folder.path / "page.html", designs=3)
        self.assertEqual(page, (self.folder.path / "page.html").read_text())
        self.assertEqual(study.report(designs=3), page)
        with self.assertRaisesRegex(OSError, "another"):
            mechwright.study({**STUDY, "title": "Others"}, place)

    def test_sql(self):
        study = mechwright.study(STUDY)
        longest = study.data('SELECT max("dimensions.crank") AS longest, count(*) AS number FROM points')
        self.assertEqual((longest.longest[0], longest.number[0]), (36, 7))
        for sql in ("SELEC", "DELETE FROM points"):
            with self.assertRaises(ValueError):
                study.data(sql)

    def test_tolerances(self):
        problem = {**STUDY, "study": {"count": 50, "seed": 1, "tolerance": {"lengths": "IT7"}}}
        study = mechwright.study(problem)
        self.assertIn("swing", study.tolerances)
        self.assertEqual(mechwright.study(STUDY).tolerances, "")

    def test_a_time_limit_leaves_points(self):
        many = {**STUDY, "study": {"dimensions.crank": {"from": 30, "to": 36, "count": 100000}}}
        study = mechwright.study(many, time_limit=0.05, jobs=1)
        self.assertFalse(study.complete)
        self.assertLess(study.done, study.points)

    def test_ctrl_c_ends_it_and_it_goes_on(self):
        many = {**STUDY, "study": {"dimensions.crank": {"from": 30, "to": 36, "count": 100000}}}
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        self.addCleanup(timer.cancel)
        with self.assertRaises(KeyboardInterrupt):
            mechwright.study(many, self.folder.path / "kept", jobs=1)
        before = mechwright.Study(self.folder.path / "kept").done
        after = mechwright.study(many, self.folder.path / "kept", jobs=1, time_limit=0.2).done
        self.assertLess(0, before)
        self.assertLess(before, after)

    def test_what_is_odd_is_warned_of_once(self):
        odd = {**STUDY, "require": [{"quantity": "swing", "equal": 60}]}
        file = self.folder.write("study.toml", mechwright.Problem(odd).to_toml())
        for given in (odd, file):
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                mechwright.study(given)
            self.assertEqual([one.category for one in caught], [mechwright.ProblemWarning])

    def test_what_is_no_study(self):
        with self.assertRaisesRegex(mechwright.ProblemError, r"there is no \[study\] in it: write \[study\]"):
            mechwright.study(given_linkage())
        with self.assertRaisesRegex(mechwright.ProblemError, r"study.toml:5:1: .*did you mean 'crank'"):
            mechwright.study(self.folder.write("study.toml", TEXT.replace("dimensions.crank", "dimensions.krank")))
        with self.assertRaises(OSError):
            mechwright.study("/nowhere/a.toml")
        with self.assertRaises(OSError):
            mechwright.Study(self.folder.path)
        with self.assertRaisesRegex(ValueError, "jobs"):
            mechwright.study(STUDY, jobs=0)


class Comparisons(unittest.TestCase):
    files = [PROBLEMS / f"quick-return/uniform-speed-{name}.toml" for name in ("whitworth", "drag-link")]

    def test_it_is_that_of_the_program(self):
        comparison = mechwright.compare(self.files)
        printed = json.loads(run("compare", *self.files, "--json", "--quiet")[1])
        document = json.loads(json.dumps(comparison.document))

        def without_time(rows):
            return [{**row, "result": but_for_time(row["result"])} for row in rows]

        self.assertEqual(without_time(document), without_time(printed))
        self.assertEqual(comparison.csv, run("compare", *self.files, "--csv", "--quiet")[1])
        rows = list(csv.DictReader(io.StringIO(comparison.csv)))
        self.assertEqual([row["mechanism"] for row in rows], [row.mechanism for row in comparison])
        self.assertEqual(repr(comparison), comparison.table)
        self.assertIn("<table>", comparison._repr_html_())
        self.assertTrue(comparison[0].result.verify().passed)

    def test_problems_as_values(self):
        other = {**crank_rocker(), "objective": {"minimize": "total-length"}}
        comparison = mechwright.compare([crank_rocker(), other])
        self.assertEqual([row.file for row in comparison], ["problem 1", "problem 2"])
        self.assertIn("minimize total-length", comparison.differences)
        self.assertEqual(plain(comparison[0].result.design), plain(mechwright.solve(crank_rocker()).design))

    def test_what_cannot_be_compared(self):
        for few in ([crank_rocker()], crank_rocker(), "a.toml"):
            with self.assertRaisesRegex(ValueError, "two problems"):
                mechwright.compare(few)
        with self.assertRaises(mechwright.ProblemError):
            mechwright.compare([crank_rocker(), {**crank_rocker(), "mechanism": "five-bar"}])
        with self.assertRaises(mechwright.ProblemError):
            mechwright.compare([crank_rocker(), crank_rocker()], method="best")


if __name__ == "__main__":
    unittest.main()

"""Results as values: attributes, files, tables and drawings."""

import copy
import json
import pickle
import unittest
import xml.etree.ElementTree as ElementTree

import mechwright
import numpy as np
from common import PROBLEMS, Folder, crank_rocker, given_linkage, plain, run, solved_by_program

FILE = PROBLEMS / "four-bar/crank-rocker.toml"


class Results(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.result = mechwright.solve(FILE)
        cls.infeasible = mechwright.solve(PROBLEMS / "four-bar/transmission-not-reachable.toml")

    def test_every_member_is_an_attribute(self):
        for name, value in self.result.items():
            self.assertIs(getattr(self.result, name), self.result[name])
            self.assertIn(name, dir(self.result))
        self.assertEqual(self.result.design.crank, self.result["design"]["crank"])
        self.assertEqual(self.result.quantities.transmission_angle_worst, self.result.objective.value)
        self.assertEqual(self.result.requirements[0].quantity, "swing")

    def test_what_a_document_does_not_have(self):
        self.assertIsNone(self.result.front)
        self.assertEqual(self.infeasible.alternatives, [])
        self.assertEqual(self.result.warnings, [])
        with self.assertRaisesRegex(AttributeError, "did you mean 'objective'"):
            self.result.objectives
        with self.assertRaisesRegex(AttributeError, "known are ground, crank"):
            self.result.design.wing

    def test_assignment_changes_the_document(self):
        result = copy.deepcopy(self.result)
        result.design.crank += 0.001
        self.assertEqual(result["design"]["crank"], self.result.design.crank + 0.001)
        self.assertNotEqual(result, self.result)
        self.assertFalse(result.verify().passed)

    def test_equality_is_that_of_the_numbers(self):
        path = mechwright.solve(PROBLEMS / "exact/three-poses-four-points.toml")
        for one in (copy.deepcopy(path), pickle.loads(pickle.dumps(path)), mechwright.Result(path.to_dict())):
            self.assertIsInstance(one, mechwright.Result)
            self.assertEqual(one, path)
        one.poses.points[0][0] += 1
        self.assertNotEqual(one, path)
        self.assertNotEqual(path, 3)
        self.assertNotEqual(path, {"a": {1}})

    def test_the_plain_document(self):
        document = self.result.to_dict()
        self.assertEqual(document, plain(self.result))
        self.assertEqual(json.loads(json.dumps(document)), document)

    def test_json_writes_a_result(self):
        path = mechwright.solve(PROBLEMS / "exact/three-poses-four-points.toml")
        for result in (path, self.result, self.infeasible, copy.deepcopy(path), pickle.loads(pickle.dumps(path))):
            for indent in (None, 2):
                self.assertEqual(json.dumps(result, indent=indent, ensure_ascii=False), result.to_json(indent=indent))
            self.assertEqual(json.loads(json.dumps([{"one": result}])), [{"one": result.document}])
        self.assertIsInstance(copy.deepcopy(path).poses.points, np.ndarray)

    def test_a_saved_one_is_the_document_of_the_program(self):
        file = Folder(self).path / "result.json"
        for name in ("four-bar/crank-rocker.toml", "exact/three-poses-four-points.toml", "cam/knife-table.toml"):
            document = solved_by_program(PROBLEMS / name)
            result = mechwright.Result(document)
            result.save(file)
            self.assertEqual(json.loads(file.read_text()), document)
            self.assertEqual(mechwright.Result.load(file), result)
        self.assertEqual(run("verify", file)[0], 0)
        with self.assertRaisesRegex(ValueError, "not a result document"):
            mechwright.Result(given_linkage()).save(file)
        with self.assertRaises(OSError):
            mechwright.Result.load("/nowhere/result.json")

    def test_arrays_come_back_from_files(self):
        file = Folder(self).path / "result.json"
        result = mechwright.solve(PROBLEMS / "exact/three-poses-four-points.toml")
        result.save(file)
        np.testing.assert_array_equal(mechwright.Result.load(file).poses.directions, result.poses.directions)

    def test_its_representation_is_one_line(self):
        self.assertRegex(repr(self.result), r"^<Result: status solved, transmission-angle-worst 45\.0082.*crank 34\.0997")
        self.assertIn("status infeasible, note ", repr(self.infeasible))
        self.assertEqual(len(repr(self.infeasible).splitlines()), 1)

    def test_the_table_for_notebooks(self):
        html = ElementTree.fromstring(self.result._repr_html_())
        rows = {row[0].text: row[1].text for row in html.iter("tr")}
        self.assertEqual(rows["crank"], f"{self.result.design.crank:.9g}")
        self.assertEqual(rows["swing (equal 60)"], "60")
        self.assertEqual(rows["total-length"], f"{self.result.quantities.total_length:.9g}")
        self.assertNotIn("<svg", mechwright.Result({**self.result, "design": {}})._repr_html_())

    def test_nothing_of_a_title_is_markup(self):
        title = "<script>&\"' a < b"
        html = mechwright.solve({**crank_rocker(), "title": title})._repr_html_()
        self.assertNotIn("<script", html)
        self.assertEqual(next(ElementTree.fromstring(html).iter("caption")).text, title)

    def test_the_drawing(self):
        self.assertEqual(self.result._repr_svg_(), run("draw", self.saved(self.result))[1])
        self.assertIsNone(mechwright.Result({**self.result, "design": {}})._repr_svg_())
        with self.assertRaisesRegex(ValueError, "design"):
            mechwright.Result({**self.result, "design": {}}).svg()

    def saved(self, result):
        file = Folder(self).path / "result.json"
        result.save(file)
        return file

    def test_analyses_and_verifications_have_attributes_too(self):
        self.assertTrue(mechwright.verify(self.result).passed)
        analysis = mechwright.analyse(self.result)
        np.testing.assert_array_equal(analysis.motion.crank_angle, analysis["motion"]["crank-angle"])


if __name__ == "__main__":
    unittest.main()

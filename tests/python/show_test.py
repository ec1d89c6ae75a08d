"""draw(), export(), report() and explain() against the program, and results in notebooks."""

import json
import os
import tempfile
import unittest
import warnings
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from unittest import mock

import mechwright
import numpy as np
from common import PROBLEMS, Folder, crank_rocker, given_linkage, run

FILE = PROBLEMS / "four-bar/crank-rocker.toml"
GIVEN = PROBLEMS / "quick-return/drag-link-given.toml"


class OfResults(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.result = mechwright.solve(FILE)
        cls.file = Path(folder.name) / "result.json"
        cls.result.save(cls.file)
        cls.none = mechwright.Result({**cls.result, "design": {}})

    def test_pictures_are_those_of_the_program(self):
        for options, words in (({}, ()), ({"animate": True}, ("--animate",)), ({"width": 300}, ("--width", 300)),
                               ({"animate": True, "seconds": 2.5}, ("--animate", "--seconds", 2.5))):
            with self.subTest(options):
                drawn = run("draw", self.file, *words)[1]
                self.assertEqual(mechwright.draw(self.file, **options), drawn)
                self.assertEqual(self.result.draw(**options), drawn)
                self.assertEqual(mechwright.draw(self.result, **options)._repr_html_(), drawn)

    def test_pictures_of_problems(self):
        self.assertEqual(mechwright.draw(GIVEN), run("draw", GIVEN)[1])
        self.assertEqual(mechwright.draw(mechwright.Problem(GIVEN)), run("draw", GIVEN)[1])
        self.assertIn("<svg", mechwright.draw(given_linkage(), plots=True))

    def test_pictures_in_files(self):
        folder = Folder(self).path
        for name, begin in {"a.svg": b"<svg", "a.png": b"\x89PNG", "a.pdf": b"%PDF"}.items():
            picture = self.result.draw(folder / name)
            self.assertTrue((folder / name).read_bytes().startswith(begin), name)
            self.assertTrue(picture.startswith("<svg"))
        mechwright.draw(self.result, str(folder / "b.svg"), animate=True)
        self.assertIn("animateTransform", (folder / "b.svg").read_text())
        mechwright.draw(self.result, folder / "b.gif", animate=True, seconds=0.3, width=200)
        self.assertTrue((folder / "b.gif").read_bytes().startswith(b"GIF89a"))

    def test_figures(self):
        for source in ("four-bar", FILE, PROBLEMS / "linkage/scotch-yoke.toml"):
            with self.subTest(source):
                self.assertEqual(mechwright.draw(source, figure=True), run("draw", source, "--figure")[1])
        self.assertIn("Dimensions: <dict>", mechwright.draw(given_linkage(), figure=True).replace("&lt;", "<").replace(
            "&gt;", ">"))
        file = Folder(self).path / "four-bar.png"
        mechwright.draw("four-bar", file, figure=True, width=300)
        self.assertTrue(file.read_bytes().startswith(b"\x89PNG"))
        with self.assertRaisesRegex(ValueError, "'fourbar' is neither a mechanism nor a file; did you mean 'four-bar'"):
            mechwright.draw("fourbar", figure=True)

    def test_assemblies_and_skeletons(self):
        file = PROBLEMS / "linkage/peaucellier.toml"
        drawn = run("draw", file, "--assemblies", "--at", 20)[1]
        self.assertEqual(mechwright.draw(file, assemblies=True, at=20), drawn)
        self.assertEqual(mechwright.draw(mechwright.Problem(file), assemblies=True, at=20), drawn)
        self.assertEqual(mechwright.draw(file, assemblies=True), run("draw", file, "--assemblies")[1])
        drawn = run("draw", file, "--skeleton")[1]
        self.assertEqual(mechwright.draw(file, skeleton=True), drawn)
        self.assertEqual(mechwright.draw(dict(mechwright.Problem(file)), skeleton=True), drawn)
        with self.assertRaisesRegex(mechwright.ProblemError, "does not close at this input; skeleton=True"):
            mechwright.draw(file, assemblies=True, at=180)

    def test_skeletons_of_what_is_wrong_are_drawn_with_a_warning(self):
        file = Folder(self).path / "wrong.toml"
        text = (PROBLEMS / "linkage/peaucellier.toml").read_text()
        file.write_text(text + '\n[[require]]\nquantity = "nothing"\nmin = 1\n')
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            picture = mechwright.draw(file, skeleton=True)
        self.assertEqual(picture, run("draw", file, "--skeleton")[1])
        with self.assertRaises(mechwright.ProblemError):
            mechwright.draw(self.result, skeleton=True)

    def test_kinds_of_drawings_do_not_go_together(self):
        for options in ({"figure": True, "skeleton": True}, {"figure": True, "animate": True}, {"at": 3},
                        {"skeleton": True, "alternative": 1}, {"figure": True, "width": 1}):
            with self.subTest(options), self.assertRaises(ValueError):
                mechwright.draw(FILE, **options)
        with self.assertRaisesRegex(ValueError, "out: it must end in .svg, .png or .pdf, not in '.gif'"):
            mechwright.draw("four-bar", "a.gif", figure=True)

    def test_alternatives(self):
        result = mechwright.solve(PROBLEMS / "exact/three-poses-four-points.toml")
        file = Folder(self).path / "result.json"
        result.save(file)
        self.assertEqual(result.draw(alternative=1), run("draw", file, "--alternative", 1)[1])
        self.assertEqual(result.export(format="csv", alternative=1),
                         run("export", file, "--format", "csv", "--alternative", 1)[1])
        for number in (0, 1000):
            with self.assertRaisesRegex(ValueError, "alternative"):
                result.draw(alternative=number)
        with self.assertRaisesRegex(ValueError, "alternative"):
            mechwright.draw(GIVEN, alternative=1)

    def test_what_cannot_be_drawn(self):
        with self.assertRaises(mechwright.ProblemError) as caught:
            mechwright.draw(FILE)
        self.assertIn(f"{FILE}: ", str(caught.exception))
        self.assertIn("still open: crank", str(caught.exception))
        with self.assertRaisesRegex(ValueError, "design"):
            self.none.draw()
        for out, options, what in (("a.jpg", {}, "out"), ("a.gif", {}, "out"), ("a.png", {"animate": True}, "out"),
                                   (None, {"width": 5}, "width"), (None, {"animate": True, "seconds": 0}, "seconds"),
                                   (None, {"animate": True, "plots": True}, "plots")):
            with self.assertRaisesRegex(ValueError, what):
                self.result.draw(out, **options)
        with self.assertRaises(OSError):
            self.result.draw("/nowhere/a.svg")

    def test_exports_are_those_of_the_program(self):
        for name in ("dxf", "slvs", "csv", "json"):
            with self.subTest(name):
                folder = Folder(self).path
                run("export", self.file, "--out", folder / f"program.{name}")
                written = (folder / f"program.{name}").read_bytes()
                text = self.result.export(folder / f"python.{name}")
                self.assertEqual((folder / f"python.{name}").read_bytes(), written)
                self.assertEqual(text.encode(errors="surrogateescape"), written)
                self.assertEqual(mechwright.export(self.result, format=name), text)
        self.assertEqual(self.result.export(format="dxf", at=90, fineness=1e-3),
                         run("export", self.file, "--format", "dxf", "--at", 90, "--fineness", 1e-3)[1])
        self.assertEqual(mechwright.export(GIVEN, format="csv", steps=7).count("\n"), 9)

    def test_what_cannot_be_exported(self):
        with self.assertRaisesRegex(ValueError, "out must say.*'dxf', 'slvs'"):
            self.result.export()
        with self.assertRaisesRegex(ValueError, "did you mean 'dxf'"):
            self.result.export(format="dxff")
        with self.assertRaisesRegex(ValueError, "steps"):
            self.result.export(format="csv", steps=0)
        stuck = given_linkage()
        stuck["dimensions"]["crank"] = 90.0
        with self.assertRaisesRegex(ValueError, "at: 180.*does from"):
            mechwright.export(stuck, format="dxf", at=180)

    def test_a_page_is_that_of_the_program(self):
        out = self.file.with_name("page.html")
        run("report", self.file, "--out", out)
        page = mechwright.report(self.file)
        # The program knows where the page lies, and names files as they lie beside it.
        self.assertEqual(page.replace(str(self.file), self.file.name), out.read_text())
        self.assertIn("<iframe", page._repr_html_())
        again = self.file.with_name("again.html")
        self.assertIn(self.result.problem.title, mechwright.report([self.result, self.file], again))
        self.assertTrue(again.read_text().startswith("<!DOCTYPE html>"))
        folder = Folder(self)
        self.result.save(folder.path / "one.json")
        self.assertIn(self.result.problem.title, mechwright.report(folder.path))

    def test_a_page_where_gnuplot_is_missing_lacks_its_plots_and_says_so(self):
        whole = mechwright.report(self.file)
        with mock.patch.dict(os.environ, {"PATH": str(Folder(self).path)}):
            with self.assertWarnsRegex(RuntimeWarning, "no gnuplot: install it .*no plots for browsers without"):
                page = mechwright.report(self.file)
            with warnings.catch_warnings(), self.assertRaisesRegex(RuntimeWarning, "no gnuplot"):
                warnings.simplefilter("error")
                mechwright.report(self.file)
        self.assertIn(self.result.problem.title, page)
        self.assertLess(len(page), len(whole))

    def test_what_cannot_be_reported(self):
        with self.assertRaisesRegex(ValueError, "no result"):
            mechwright.report(Folder(self).path)
        with self.assertRaisesRegex(ValueError, "not a result document"):
            mechwright.report(given_linkage())
        with self.assertRaises(OSError):
            mechwright.report("/nowhere/a.json")
        with self.assertRaisesRegex(TypeError, "a result is a dict, or a path"):
            mechwright.report(3)

    def test_a_notebook_shows_it_move_beside_its_numbers(self):
        html = self.result._repr_html_()
        self.assertIn("<animateTransform", html)
        tree = ElementTree.fromstring(html)
        self.assertEqual([child.tag.split("}")[-1] for child in tree], ["div", "svg"])
        self.assertNotIn("<svg", self.none._repr_html_())


class Documents(unittest.TestCase):
    """Results as JSON."""

    def test_those_of_results(self):
        result = mechwright.solve(PROBLEMS / "exact/three-poses-four-points.toml")
        document = json.loads(json.dumps(result.document, allow_nan=False))
        self.assertEqual(document, result.to_dict())
        self.assertEqual(json.loads(result.to_json()), document)
        file = Folder(self).path / "result.json"
        result.save(file)
        self.assertEqual(json.loads(file.read_text()), document)

    def test_those_of_analyses(self):
        analysis = mechwright.analyse(given_linkage(), crank_angles=[0.0, np.nan])
        motion = json.loads(analysis.to_json())["motion"]
        self.assertEqual(motion["crank-angle"], [0, None])


class ResultsForProblems(unittest.TestCase):
    def test_one_line_says_what_would_be_right(self):
        result = mechwright.solve(crank_rocker())
        file = Folder(self).path / "result.json"
        result.save(file)
        for given, name in ((result, "<dict>"), (dict(result), "<dict>"), (file, str(file)),
                            (mechwright.Problem(result), "<dict>")):
            for function in (mechwright.solve, mechwright.check, mechwright.study):
                with self.assertRaises(mechwright.ProblemError) as caught:
                    function(given)
                line = str(caught.exception)
                self.assertEqual(len(line.splitlines()), 1)
                self.assertTrue(line.startswith(f"{name}: a result, where a problem is wanted"), line)
                self.assertIn("Problem.from_toml(result.problem.text)", line)

    def test_the_other_way_round(self):
        with self.assertRaisesRegex(ValueError, "it is a problem; give what solve returns for it"):
            mechwright.verify(mechwright.Problem(FILE))

    def test_what_it_names_works(self):
        result = mechwright.solve(FILE)
        again = mechwright.Problem.from_toml(result.problem.text).solve()
        self.assertEqual(again.design, result.design)


class Check(unittest.TestCase):
    def test_it_says_what_the_program_says(self):
        self.assertIsNone(mechwright.check(FILE))
        self.assertIsNone(mechwright.check(crank_rocker()))
        text = FILE.read_text() + '\n[solver]\nmethod = "least-squares"\n'
        bad = Folder(self).write("bad.toml", text)
        with self.assertRaises(mechwright.ProblemError) as caught:
            mechwright.check(bad)
        self.assertEqual(f"{caught.exception}\n", run("check", bad)[2])
        with self.assertRaises(mechwright.ProblemError):
            mechwright.Problem(bad).check()
        with self.assertRaisesRegex(OSError, "nowhere"):
            mechwright.check("/nowhere/a.toml")

    def test_warnings(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            mechwright.check(GIVEN)


class Explain(unittest.TestCase):
    def test_it_says_what_the_program_says(self):
        for words in (["swing"], ["crank"], ["four-bar"], ["path"], ["swing", "four-bar"]):
            text = mechwright.explain(*words)
            self.assertEqual(text, run("explain", *words)[1])
            self.assertEqual(repr(text), str(text))

    def test_what_is_not_known(self):
        for words in (["swign"], ["swing", "four-barr"], ["stroke", "four-bar"]):
            with self.assertRaises(ValueError) as caught:
                mechwright.explain(*words)
            self.assertEqual(f"mechwright: {caught.exception}\n", run("explain", *words)[2])


if __name__ == "__main__":
    unittest.main()

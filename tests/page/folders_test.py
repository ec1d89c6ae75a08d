"""Pages of whole folders."""

import json
import shutil
import unittest

from common import PROBLEMS, Results, complaints_of, run, succeed
from screen import driver, open_page
from selenium.webdriver.common.by import By


class Folders(unittest.TestCase):
    def test_of_damaged_partial_and_foreign_files_show_what_they_can(self):
        mixed = Results("four-bar/crank-rocker.toml")
        whole = mixed.result("crank-rocker").read_text()
        (mixed.folder / "cut.json").write_text(whole[:len(whole) // 2])
        (mixed.folder / "foreign.json").write_text('{"name": "something else"}')
        (mixed.folder / "empty.json").write_text("")
        (mixed.folder / "binary.json").write_bytes(bytes(range(256)))
        (mixed.folder / "no-design.json").write_text(json.dumps(
            {"schema": 1, "problem": {"title": "t", "mechanism": "four-bar"}, "status": "infeasible"}))
        (mixed.folder / "notes.txt").write_text("not looked at")
        (mixed.folder / "folder.json").mkdir()
        code, _, err = run("report", mixed.folder)
        self.assertEqual(code, 3)
        for name in ("cut", "foreign", "empty", "binary"):
            self.assertIn(f"{name}.json: ", err)
        self.assertNotIn("notes.txt", err)
        open_page(mixed.folder / "report.html")
        text = driver.find_element(By.TAG_NAME, "body").text
        for name in ("crank-rocker.json", "cut.json", "foreign.json", "no-design.json"):
            self.assertIn(name, text)
        self.assertEqual(complaints_of(driver), [])

    def test_of_nothing_say_so(self):
        empty = Results()
        code, _, err = run("report", empty.folder)
        self.assertEqual((code, "holds no result" in err), (3, True))
        code, _, err = run("report", empty.folder / "nowhere")
        self.assertEqual((code, "there is no such file or folder" in err), (6, True))
        self.assertFalse((empty.folder / "report.html").exists())

    def test_are_written_by_solve_too(self):
        out = Results()
        succeed("solve", PROBLEMS / "four-bar/crank-rocker.toml", PROBLEMS / "cam/roller-offset.toml", "--report",
                "--out", out.folder, "--quiet")
        open_page(out.folder / "report.html")
        self.assertEqual(len(driver.find_elements(By.CSS_SELECTOR, ".choice")), 2)
        (out.folder / "notes.json").write_text("{}")
        for _ in range(2):  # a second time it takes the place of the first
            succeed("solve", PROBLEMS / "cam/flat-harmonic.toml", "--report", "--out", out.folder, "--quiet")
            open_page(out.folder / "report.html")
            titles = [heading.text for heading in driver.find_elements(By.CSS_SELECTOR, "#designs h3")]
            self.assertEqual(len(titles), 3)
            self.assertEqual(titles[0].split(" solved")[0],
                             json.loads((out.folder / "flat-harmonic.json").read_text())["problem"]["title"])

    def test_name_files_as_they_lie_beside_the_page(self):
        out = Results("four-bar/crank-rocker.toml")
        problem = out.folder / "mine" / "rocker.toml"
        problem.parent.mkdir()
        shutil.copy(PROBLEMS / "four-bar/crank-rocker.toml", problem)
        succeed("solve", problem, "--report", "--out", out.folder / "designs", "--quiet")
        open_page(out.folder / "designs/report.html")
        self.assertEqual(driver.find_element(By.CSS_SELECTOR, "header .file").text, "../mine/rocker.toml")
        open_page(out.page("crank-rocker"))
        self.assertEqual(driver.find_element(By.CSS_SELECTOR, "header .file").text, "crank-rocker.json")


class TenThousandResults(unittest.TestCase):
    def test_make_one_page(self):
        many = Results("four-bar/crank-rocker.toml")
        text = many.result("crank-rocker").read_text()
        for i in range(9999):
            (many.folder / f"r{i:04}.json").write_text(text)
        succeed("report", many.folder, "--quiet")
        page = many.folder / "report.html"
        self.assertLess(page.stat().st_size, 20_000_000)
        open_page(page)
        self.assertEqual(len(driver.find_elements(By.CSS_SELECTOR, ".choice")), 100)
        self.assertIn("and 8900 more", driver.find_element(By.ID, "others").text)
        self.assertEqual(complaints_of(driver), [])


if __name__ == "__main__":
    unittest.main(warnings="ignore")

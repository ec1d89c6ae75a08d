"""Pages of studies, and pictures that look as they did."""

import io
import json
import shutil
import unittest
from pathlib import Path

from common import PROBLEMS, Results, complaints_of, succeed
from screen import driver, open_page, results, scrub
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys


class Study(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.results = Results()
        text = (PROBLEMS / "studies/transmission-chart.toml").read_text()
        file = cls.results.folder / "chart.toml"
        file.write_text(text.replace("count = 80", "count = 5").replace("count = 125", "count = 7"))
        cls.folder = cls.results.folder / "study"
        succeed("study", file, "--out", cls.folder, "--quiet")
        succeed("report", cls.folder, "--quiet")
        cls.rows = json.loads(succeed("study", "export", cls.folder, "--json"))

    def tearDown(self):
        self.assertEqual(complaints_of(driver), [])

    def shown(self):
        return driver.find_element(By.ID, "point").text, driver.find_element(By.ID, "numbers").text

    def test_opens_the_design_of_the_cell_that_is_clicked(self):
        open_page(self.folder / "report.html")
        chart = driver.find_element(By.CSS_SELECTOR, ".chart svg")
        box = chart.rect
        swings = sorted({row["require.swing.equal"] for row in self.rows})
        ratios = sorted({row["require.time-ratio.equal"] for row in self.rows})
        for i, j in ((0, 0), (4, 6), (2, 3)):
            row = next(r for r in self.rows if r["require.swing.equal"] == swings[i * (len(swings) - 1) // 4]
                       and r["require.time-ratio.equal"] == ratios[j * (len(ratios) - 1) // 6])
            # Where gnuplot has put the axes: see the margins of the chart.
            x = 0.12 + 0.72 * (row["require.swing.equal"] - swings[0]) / (swings[-1] - swings[0])
            y = 0.10 + 0.76 * (ratios[-1] - row["require.time-ratio.equal"]) / (ratios[-1] - ratios[0])
            driver.execute_script(
                "document.querySelector('.chart').dispatchEvent(new MouseEvent('click', {bubbles: true,"
                "clientX: arguments[0], clientY: arguments[1]}))",
                *driver.execute_script(
                    "const b = document.querySelector('.chart svg').getBoundingClientRect();"
                    "return [b.x + arguments[0] * b.width, b.y + arguments[1] * b.height]", x, y))
            point, numbers = self.shown()
            self.assertIn(f"point {row['point']}\n", point)
            self.assertIn(f"crank {row['design.crank']:.7g}"[:12], numbers.replace("\n", " "))
        self.assertGreater(box["width"], 300)

    def test_puts_axes_where_the_picture_has_them(self):
        """The ends of the axes lie where the page takes them to be: seen by the frame that gnuplot draws."""
        open_page(self.folder / "report.html")
        lines = driver.execute_script(
            "const svg = document.querySelector('.chart svg'), box = svg.getBoundingClientRect();"
            "return Array.from(svg.querySelectorAll('path')).map((p) => p.getBoundingClientRect()).map((b) =>"
            "[(b.left - box.left) / box.width, (b.right - box.left) / box.width,"
            " (b.top - box.top) / box.height, (b.bottom - box.top) / box.height])")
        self.assertTrue(any(abs(left - 0.12) < 0.004 and abs(right - 0.84) < 0.004 and abs(top - 0.1) < 0.004
                            and abs(bottom - 0.86) < 0.004 for left, right, top, bottom in lines))

    def test_takes_the_files_along_that_the_problem_names(self):
        folder = self.results.folder / "sizes"
        shutil.copytree(PROBLEMS / "path", self.results.folder / "path")
        file = self.results.folder / "studies" / "sizes.toml"
        file.parent.mkdir()
        text = (PROBLEMS / "studies/path-error-over-size.toml").read_text()
        file.write_text(text.replace("count = 49", "count = 12"))
        succeed("study", file, "--out", folder, "--quiet")
        succeed("report", folder, "--designs", 3, "--quiet")
        open_page(folder / "report.html")
        designs = driver.execute_script(
            "return JSON.parse(document.getElementById('data').textContent).designs.length")
        self.assertEqual(designs, 3)
        driver.find_element(By.CSS_SELECTOR, ".chart").send_keys(Keys.ARROW_LEFT)
        self.assertIn("solved", self.shown()[0])

    def test_of_tolerances_shows_their_tables_and_the_nominal_design(self):
        text = (PROBLEMS / "studies/crank-rocker-tolerances.toml").read_text().replace("20000", "200")
        file = self.results.folder / "tolerances.toml"
        file.write_text(text)
        folder = self.results.folder / "tolerances"
        succeed("study", file, "--out", folder, "--quiet")
        succeed("report", folder, "--quiet")
        open_page(folder / "report.html")
        self.assertIn("Part of the variance that comes from each dimension",
                      driver.find_element(By.ID, "study").text)
        self.assertIn("34.099741", driver.find_element(By.ID, "numbers").text)

    def test_goes_from_point_to_point_by_keys(self):
        open_page(self.folder / "report.html")
        chart = driver.find_element(By.CSS_SELECTOR, ".chart")
        seen = []
        for key in (Keys.ARROW_RIGHT, Keys.ARROW_RIGHT, Keys.ARROW_UP):
            chart.send_keys(key)
            seen.append(self.shown()[0])
        self.assertEqual(len(set(seen)), 3)


class Shots(unittest.TestCase):
    """Pictures of drawings and curves, which hold no letters, against those that were looked at."""

    def compare(self, name, selector):
        # pylint: disable=import-outside-toplevel
        from PIL import Image, ImageChops

        open_page(results.page(name))
        scrub(40)
        # Of a size that does not depend on the letters around it.
        driver.execute_script(
            "document.querySelector(arguments[0]).style.cssText ="
            "'position: fixed; left: 0; top: 0; width: 640px; border: 0; border-radius: 0'", selector)
        shot = Image.open(io.BytesIO(driver.find_element(By.CSS_SELECTOR, selector).screenshot_as_png)).convert("L")
        file = Path(__file__).parent / "references" / f"{name}.png"
        if not file.exists():
            file.parent.mkdir(exist_ok=True)
            shot.save(file, optimize=True)
            self.fail(f"there was no reference: {file} is written; look at it")
        reference = Image.open(file)
        self.assertEqual(shot.size, reference.size)
        different = sum(ImageChops.difference(shot, reference).histogram()[64:])
        self.assertLess(different, 0.002 * shot.size[0] * shot.size[1])

    def test_look_as_they_did(self):
        for name in ("crank-rocker", "problem-3", "roller-offset", "uniform-speed-drag-link",
                     "uniform-speed-crank-shaper", "oscillating-flat"):
            with self.subTest(name):
                self.compare(name, "#drawing")


if __name__ == "__main__":
    unittest.main(warnings="ignore")

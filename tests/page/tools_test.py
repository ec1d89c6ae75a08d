"""Zoom, pace, and what is saved from a page."""

import csv
import io
import math
import tempfile
import time
import unittest
from pathlib import Path
from xml.etree import ElementTree

from common import complaints_of, succeed
from screen import Fit, PIN_CENTRES, driver, open_page, results, scrub
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait


def misfit(places, shown):
    """How far places on one screen are from those on another, of another scale."""
    return Fit([[[(x, -y) for x, y in body] for body in places]], [shown]).worst()


class PageTools(unittest.TestCase):
    """Zoom, pace, and what is saved from the page."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.saved = Path(folder.name)
        driver.execute_cdp_cmd("Browser.setDownloadBehavior", {"behavior": "allow", "downloadPath": folder.name})

    def tearDown(self):
        self.assertEqual(complaints_of(driver), [])

    def save(self, ending, name="crank-rocker"):
        """What a button saves."""
        file = self.saved / f"{name}.{ending}"
        driver.find_element(By.ID, f"save-{ending}").click()
        WebDriverWait(driver, 60).until(lambda _: file.exists())
        return file

    def view(self):
        return [float(part) for part in
                driver.execute_script("return document.getElementById('drawing').getAttribute('viewBox')").split()]

    def test_zooms_about_what_is_pointed_at_and_back(self):
        open_page(results.page("crank-rocker"))
        whole = self.view()
        driver.find_element(By.ID, "nearer").click()
        x, y, width, height = self.view()
        self.assertAlmostEqual(width, whole[2] / 1.5, delta=1e-6)
        self.assertAlmostEqual(x + width / 2, whole[0] + whole[2] / 2, delta=1e-6)
        self.assertAlmostEqual(y + height / 2, whole[1] + whole[3] / 2, delta=1e-6)
        turn = ("const d = document.getElementById('drawing'), b = d.querySelector('.own .pin').getBoundingClientRect();"
                "const at = [b.x + b.width / 2, b.y + b.height / 2];"
                "if (arguments[0]) d.dispatchEvent(new WheelEvent('wheel', {deltaY: -200, ctrlKey: arguments[1],"
                "clientX: at[0], clientY: at[1], bubbles: true, cancelable: true})); return at;")
        before = driver.execute_script(turn, True, True)
        after = driver.execute_script(turn, False, False)
        self.assertLess(self.view()[2], width)
        self.assertLess(math.dist(before, after), 1)  # what is pointed at is a whole pixel
        seen = self.view()
        driver.execute_script(turn, True, False)  # moves the page, not the drawing
        self.assertEqual(self.view(), seen)
        driver.find_element(By.ID, "whole").click()
        self.assertEqual(self.view(), whole)
        driver.find_element(By.ID, "farther").click()
        self.assertEqual(self.view(), whole)

    def test_fills_the_screen(self):
        open_page(results.page("crank-rocker"))
        button = driver.find_element(By.ID, "full")
        button.click()
        WebDriverWait(driver, 20).until(lambda _: button.text == "Leave full screen")
        button.click()
        WebDriverWait(driver, 20).until(lambda _: button.text == "Full screen")

    def test_turns_as_often_as_asked_for(self):
        open_page(results.page("crank-rocker"))
        speed = driver.find_element(By.ID, "speed")
        self.assertIn("turns per minute", speed.accessible_name)
        speed.clear()
        speed.send_keys("6")
        begin = driver.execute_script(
            "document.getElementById('play').click();"
            "return [performance.now(), Number(document.getElementById('angle').value)]")
        time.sleep(1.5)
        end = driver.execute_script("return [performance.now(), Number(document.getElementById('angle').value)]")
        driver.find_element(By.ID, "play").click()
        # 36 degrees in a second; what a busy machine leaves out is not made up for.
        self.assertLess((end[1] - begin[1]) % 360, 36 * (end[0] - begin[0]) / 1000 + 4)
        self.assertGreater((end[1] - begin[1]) % 360, 4)
        open_page(results.page("slider-crank-compact"))
        self.assertIn("turns per minute", driver.find_element(By.ID, "speed").accessible_name)

    def test_saves_the_drawing_as_it_shows(self):
        open_page(results.page("crank-rocker"))
        scrub(77)
        svg = self.save("svg")
        root = ElementTree.parse(svg).getroot()
        name = "{http://www.w3.org/2000/svg}"
        self.assertEqual(root.tag, f"{name}svg")
        width = float(root.get("width"))
        shown = driver.execute_script(PIN_CENTRES, ".own")
        driver.get(f"file://{svg}")
        self.assertEqual(len(driver.find_elements(By.CSS_SELECTOR, "script, style")), 0)
        places = driver.execute_script(
            "return Array.from(document.querySelectorAll('.own > .body')).map((body) =>"
            "Array.from(body.querySelectorAll('.pin, .point')).map((circle) => {"
            "const b = circle.getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]; }))")
        self.assertLess(misfit(places, shown), 0.5)
        self.assertGreater(width, 300)
        self.assertTrue(all(element.get("stroke") for element in root.iter(f"{name}path")))

    def test_saves_the_file_that_export_writes_for_cad(self):
        for name in ("crank-rocker", "roller-offset"):
            open_page(results.page(name))
            self.assertEqual(self.save("dxf", name).read_text(),
                             succeed("export", results.result(name), "--format", "dxf"))

    def test_saves_the_motion_as_a_table(self):
        open_page(results.page("crank-rocker"))
        table = list(csv.reader(io.StringIO(self.save("csv").read_text())))
        exported = list(csv.reader(io.StringIO(succeed("export", results.result("crank-rocker"), "--format", "csv"))))
        self.assertEqual(len(table), 362)
        self.assertEqual(table[0][0], "crank-angle (deg)")
        plain = [head.split(" ")[0] for head in exported[0]]
        shared = [(i, plain.index(head.split(" ")[0])) for i, head in enumerate(table[0])
                  if head.split(" ")[0] in plain]
        self.assertGreater(len(shared), 1)
        for row in (1, 100, 361):
            for i, j in shared:
                self.assertAlmostEqual(float(table[row][i]), float(exported[row][j]),
                                       delta=1e-5 * max(1, abs(float(exported[row][j]))))

    def test_saves_the_motion_as_a_moving_picture(self):
        # pylint: disable=import-outside-toplevel
        from PIL import Image, ImageChops

        open_page(results.page("crank-rocker"))
        self.assertEqual(driver.find_element(By.ID, "play").text, "Play")
        picture = Image.open(self.save("gif"))
        self.assertEqual(picture.n_frames, 45)
        self.assertEqual(picture.info["duration"], 90)  # milliseconds: 4 seconds for a turn
        frames = []
        for i in range(picture.n_frames):
            picture.seek(i)
            frames.append(picture.convert("RGB"))
        self.assertTrue(all(ImageChops.difference(a, b).getbbox() for a, b in zip(frames, frames[1:])))
        self.assertGreater(len(frames[0].getcolors(1 << 16)), 5)


if __name__ == "__main__":
    unittest.main(warnings="ignore")

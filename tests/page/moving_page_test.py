"""Pages with a mechanism that moves: its plots, switching, keyboard, browsers without scripts."""

import base64
import csv
import io
import json
import subprocess
import tempfile
import time
import unittest

from common import browser, complaints_of, requests_of, succeed
from screen import Fit, PIN_CENTRES, driver, motion_of, open_page, results, scrub
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys


class Page(unittest.TestCase):
    def tearDown(self):
        self.assertEqual(complaints_of(driver), [])

    def test_asks_for_nothing_but_itself(self):
        page = results.page("crank-rocker")
        requests_of(driver)
        open_page(page)
        self.assertEqual(requests_of(driver), [f"file://{page}"])
        self.assertLess(page.stat().st_size, 400_000)
        self.assertNotIn("http:", page.read_text().replace("http://www.w3.org", ""))

    def test_shows_the_other_assembly(self):
        name = "crank-rocker"
        open_page(results.page(name))
        driver.find_element(By.ID, "other").click()
        design = results.document(name)["design"]
        other = results.folder / "crossed.toml"
        other.write_text("schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nassembly = \"crossed\"\n" + "".join(
            f"{link} = {design[link]!r}\n" for link in ("ground", "crank", "coupler", "rocker")))
        _, own = motion_of(results.result(name))
        _, crossed = motion_of(other)
        for step in (0, 45, 123, 300):
            scrub(step)
            fit = Fit([own[step]], [driver.execute_script(PIN_CENTRES, ".own")])
            both = Fit([own[step]] + [crossed[step]], [driver.execute_script(PIN_CENTRES, ".own"),
                                                       driver.execute_script(PIN_CENTRES, ".other")])
            self.assertLess(fit.worst(), 0.25)
            self.assertLess(both.worst(), 0.25)

    def test_plays_and_stops(self):
        open_page(results.page("crank-rocker"))
        play, slider = driver.find_element(By.ID, "play"), driver.find_element(By.ID, "angle")
        before = driver.execute_script(PIN_CENTRES, ".own")
        play.click()
        time.sleep(0.6)
        self.assertEqual(play.text, "Pause")
        self.assertNotEqual(driver.execute_script(PIN_CENTRES, ".own"), before)
        play.click()
        time.sleep(0.1)
        angle = slider.get_attribute("value")
        time.sleep(0.3)
        self.assertEqual(slider.get_attribute("value"), angle)

    def test_plays_to_and_fro_where_the_crank_does_not_turn(self):
        open_page(results.page("tangent"))
        driver.execute_script("document.getElementById('speed').value = '60'")
        driver.find_element(By.ID, "play").click()
        seen = []
        for _ in range(40):
            seen.append(int(driver.find_element(By.ID, "angle").get_attribute("value")))
            time.sleep(0.02)
        driver.find_element(By.ID, "play").click()
        steps = [b - a for a, b in zip(seen, seen[1:]) if a != b]
        self.assertTrue(any(step > 0 for step in steps) and any(step < 0 for step in steps), seen)

    def test_obeys_the_keyboard(self):
        open_page(results.page("crank-rocker"))
        slider = driver.find_element(By.ID, "angle")
        before = int(slider.get_attribute("value"))
        slider.send_keys(Keys.ARROW_RIGHT)
        self.assertEqual(int(slider.get_attribute("value")), before + 1)
        self.assertEqual(slider.get_attribute("aria-valuetext"), f"{before + 1}.0 deg")
        driver.find_element(By.TAG_NAME, "body").send_keys(" ")
        self.assertEqual(driver.find_element(By.ID, "play").text, "Pause")
        driver.find_element(By.TAG_NAME, "body").send_keys(" ")


class PageReadings(unittest.TestCase):
    def tearDown(self):
        self.assertEqual(complaints_of(driver), [])

    def test_names_everything_for_screen_readers(self):
        open_page(results.page("problem-3"))
        for element in driver.find_elements(By.CSS_SELECTOR, "button, input, select, svg[role], [role=img]"):
            if element.is_displayed():
                self.assertTrue(element.accessible_name, element.get_attribute("outerHTML")[:200])
        self.assertEqual(driver.find_element(By.TAG_NAME, "html").get_attribute("lang"), "en")

    def test_reads_the_plots_at_the_angle_that_shows(self):
        name = "uniform-speed-crank-shaper"
        open_page(results.page(name))
        table = list(csv.reader(io.StringIO(succeed("export", results.result(name), "--format", "csv"))))
        column = [head.split(" ")[0] for head in table[0]].index("ram-velocity")
        # Velocities of a drive are those for unit crank speed: lengths per radian, as in the table.
        for step in (10, 200, 359):
            scrub(step)
            legends = driver.execute_script(
                "return Array.from(document.querySelectorAll('.legend')).map((l) => l.textContent)")
            reading = next(text for text in legends if "ram-velocity" in text).split("ram-velocity ")[1]
            self.assertAlmostEqual(float(reading), float(table[1 + step][column]),
                                   delta=1e-4 * abs(float(table[1 + step][column])))

    def test_keeps_the_cursors_of_all_plots_at_the_angle(self):
        open_page(results.page("roller-offset"))
        scrub(90)
        places = driver.execute_script(
            "return Array.from(document.querySelectorAll('.curves')).map((area) => {"
            "const cursor = area.querySelector('.cursor').getBoundingClientRect();"
            "const labels = Array.from(area.querySelectorAll('.dygraph-axis-label-x')).filter("
            "(l) => ['60', '120'].includes(l.textContent)).map((l) => {"
            "const b = l.getBoundingClientRect(); return b.x + b.width / 2; });"
            "return [cursor.x, ...labels]; })")
        self.assertEqual(len(places), 6)
        for cursor, sixty, hundred_and_twenty in places:
            self.assertAlmostEqual(cursor, (sixty + hundred_and_twenty) / 2, delta=2)

    def test_switches_designs(self):
        name = "problem-3"
        open_page(results.page(name))
        document = results.document(name)
        choices = driver.find_elements(By.CSS_SELECTOR, ".choice")
        self.assertEqual(len(choices), 1 + len(document["alternatives"]))
        choices[1].click()
        self.assertEqual([c.get_attribute("aria-pressed") for c in choices], ["false", "true"])
        numbers = driver.find_element(By.ID, "numbers").text
        self.assertIn(f"{document['alternatives'][0]['design']['crank']:.6g}"[:7], numbers)
        _, poses = motion_of(results.result(name), "--alternative", 1)
        scrub(77)
        self.assertLess(Fit([poses[77]], [driver.execute_script(PIN_CENTRES, ".own")]).worst(), 0.25)


class StillPage(unittest.TestCase):
    """Without scripts, in the dark, on paper, and with markup that must not become a script."""

    def tearDown(self):
        self.assertEqual(complaints_of(driver), [])

    def test_works_without_scripts(self):
        page = results.page("crank-rocker")
        still = browser(scripts=False)
        try:
            still.get(f"file://{page}")
            self.assertTrue(still.find_element(By.ID, "drawing").is_displayed())
            self.assertTrue(still.find_element(By.CSS_SELECTOR, "#still-plots svg").is_displayed())
            self.assertFalse(still.find_element(By.ID, "play").is_displayed())
            self.assertIn("34.099741", still.find_element(By.ID, "numbers").text)
        finally:
            still.quit()

    def test_is_dark_where_that_is_wanted(self):
        open_page(results.page("crank-rocker"))

        def brightness(scheme):
            driver.execute_cdp_cmd("Emulation.setEmulatedMedia",
                                   {"features": [{"name": "prefers-color-scheme", "value": scheme}]})
            colour = driver.execute_script("return getComputedStyle(document.body).backgroundColor")
            return sum(int(part) for part in colour.strip("rgba()").split(",")[:3])

        self.assertGreater(brightness("light"), 700)
        self.assertLess(brightness("dark"), 150)
        driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})

    def test_prints_on_one_page(self):
        for name in ("crank-rocker", "roller-offset", "problem-3", "uniform-speed-drag-link"):
            with self.subTest(name), tempfile.NamedTemporaryFile(suffix=".pdf") as file:
                open_page(results.page(name))
                file.write(base64.b64decode(driver.print_page()))
                file.flush()
                info = subprocess.run(["pdfinfo", file.name], capture_output=True, text=True, check=True).stdout
                self.assertIn("Pages:           1\n", info)
                text = subprocess.run(["pdftotext", file.name, "-"], capture_output=True, text=True, check=True).stdout
                self.assertIn("Dimensions", text)
                self.assertIn("velocity", text)

    def test_takes_no_markup_from_files(self):
        evil = "<script>window.taken = 1</script><img src=x onerror='window.taken = 1'>&amp;\"'"
        for place in ("title", "note", "check", "status", "defect"):
            with self.subTest(place):
                document = results.document("problem-3")
                if place == "title":
                    document["problem"]["title"] = evil
                elif place == "note":
                    document["status"], document["note"] = "limit", evil
                elif place == "check":
                    document["verification"]["checks"][0]["detail"] = evil
                elif place == "status":
                    document["status"] = evil
                else:
                    document["alternatives"][0]["defect"] = evil
                file = results.folder / "evil.json"
                file.write_text(json.dumps(document))
                open_page(results.page("evil"))
                self.assertIsNone(driver.execute_script("return window.taken ?? null"))
                self.assertIn("onerror", driver.find_element(By.TAG_NAME, "html").get_attribute("textContent"))
                self.assertEqual(driver.find_elements(By.CSS_SELECTOR, "img"), [])


if __name__ == "__main__":
    unittest.main(warnings="ignore")

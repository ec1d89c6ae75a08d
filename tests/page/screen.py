"""A browser that the tests of a file share, and what is on its screen."""

import atexit
import json
import math

from common import Results, browser, succeed
from selenium.webdriver.support.ui import WebDriverWait

SOLVED = ["four-bar/crank-rocker.toml", "exact/problem-3.toml", "cam/roller-offset.toml",
          "quick-return/uniform-speed-drag-link.toml", "quick-return/uniform-speed-crank-shaper.toml",
          "quick-return/uniform-speed-whitworth.toml", "quick-return/slider-crank-compact.toml",
          "cam/oscillating-flat.toml", "function/tangent.toml", "poses/tipper.toml"]

PIN_CENTRES = """
return Array.from(document.querySelectorAll("#drawing > " + arguments[0] + " > .body")).map((body) =>
  Array.from(body.querySelectorAll(".pin, .point")).map((circle) => {
    const box = circle.getBoundingClientRect();
    return [box.x + box.width / 2, box.y + box.height / 2];
  }));
"""


class SharedBrowser:
    """Begun where it is first asked for, ended with the program."""

    _driver = None

    def __getattr__(self, name):
        if self._driver is None:
            self._driver = browser()
            atexit.register(self._driver.quit)
        return getattr(self._driver, name)


driver = SharedBrowser()
results = Results(*SOLVED)


def open_page(page):
    """The page, once its script has run: `get` has come back before that, on a busy machine."""
    driver.get(f"file://{page}")
    WebDriverWait(driver, 60).until(lambda d: d.execute_script("return document.readyState") == "complete")
    return driver


def scrub(step):
    driver.execute_script(
        "const a = document.getElementById('angle'); a.value = arguments[0];"
        "a.dispatchEvent(new Event('input', {bubbles: true}));", step)


def motion_of(*arguments):
    """What `export` says of the motion: pins and points of every body in the drawing, at each angle."""
    motion = json.loads(succeed("export", *arguments, "--format", "json"))
    poses = []
    for places in motion["motion"]["places"]:
        bodies = []
        for body, (x, y, angle) in zip(motion["bodies"], places):
            unit = math.pi / 180 if motion["units"]["angle"] == "deg" else 1
            c, s = math.cos(angle * unit), math.sin(angle * unit)
            bodies.append([(x + c * u - s * v, y + s * u + c * v) for u, v in body["pins"] + body["points"]])
        poses.append(bodies)
    return motion, poses


class Fit:
    """The scale and place of the drawing on the screen, from the two points that are farthest apart."""

    def __init__(self, drawn, shown):
        pairs = [(p, q) for pose, screen in zip(drawn, shown) for body, circles in zip(pose, screen)
                 for p, q in zip(body, circles)]
        first = pairs[0]
        other = max(pairs, key=lambda pair: abs(pair[0][0] - first[0][0]))
        self.scale = (other[1][0] - first[1][0]) / (other[0][0] - first[0][0])
        self.x = first[1][0] - self.scale * first[0][0]
        self.y = first[1][1] + self.scale * first[0][1]
        self.pairs = pairs

    def worst(self):
        return max(math.hypot(self.x + self.scale * p[0] - q[0], self.y - self.scale * p[1] - q[1])
                   for p, q in self.pairs)

"""The examples run, and print what is known from elsewhere; so does the Python of its manual."""

import re
import subprocess
import sys
import unittest

import numpy as np
from common import SOURCE

EXAMPLES = SOURCE / "synthesis" / "python" / "examples"


def output_of(code):
    done = subprocess.run([sys.executable, "-B", "-W", "error", "-"], input=code, capture_output=True, text=True,
                          check=False, cwd=SOURCE)
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    return done.stdout


def numbers_of(text):
    return [float(number) for number in re.findall(r"-?\d+\.?\d*(?:e[-+]\d+)?", text)]


class Examples(unittest.TestCase):
    def test_each_has_its_test(self):
        tested = {name.removeprefix("test_") for name in dir(self) if name.startswith("test_")}
        self.assertLessEqual({file.stem for file in EXAMPLES.glob("*.py")}, tested)

    def test_crank_rocker(self):
        output = output_of((EXAMPLES / "crank_rocker.py").read_text())
        self.assertIn("solved True", output)
        # The optimum that the manual gives.
        self.assertEqual(numbers_of(output), [34.099741, 93.003750, 69.847371, 45.008219])

    def test_sweep(self):
        output = output_of((EXAMPLES / "sweep.py").read_text())
        worst, swing, length, slope = numbers_of(output)

        # The least angle between coupler and rocker is at one of the two alignments of crank and ground.
        def transmission(diagonal):
            return np.degrees(np.arccos((93**2 + 70**2 - diagonal**2) / (2 * 93 * 70)))

        at = {0: transmission(66), 180: 180 - transmission(134)}
        self.assertEqual(worst, min(at, key=at.get))

        # The ends of the stroke are triangles of ground, rocker and coupler +- crank.
        def rocker(side):
            return np.degrees(np.arccos((100**2 + 70**2 - side**2) / (2 * 100 * 70)))

        cranks = np.linspace(30, 36, 7)
        known = np.polyfit(cranks - 33, rocker(93 + cranks) - rocker(93 - cranks), 1)
        self.assertEqual(length, 33)
        np.testing.assert_allclose([slope, swing], known, atol=0.0051)

    def test_ellipse(self):
        output = output_of((EXAMPLES / "ellipse.py").read_text())
        self.assertIn("solved", output)
        rms, greatest = numbers_of(output)
        self.assertLess(rms, 0.2)
        self.assertLessEqual(rms, greatest)

    def test_manual(self):
        manual = (SOURCE / "synthesis/python/README.md").read_text()
        blocks = re.findall(r"```python\n(.*?)```\n\n```\n(.*?)```", manual, re.DOTALL)
        self.assertGreater(len(blocks), 0)
        for code, output in blocks:
            self.assertEqual(output_of(code), output)


if __name__ == "__main__":
    unittest.main()

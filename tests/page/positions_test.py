"""Where mechanisms are on the screen."""

import unittest
from pathlib import Path

from screen import Fit, PIN_CENTRES, SOLVED, driver, motion_of, open_page, results, scrub


def compare_positions(test, problems):
    """The pins and points on the screen with those of the analysis, to the pixel."""
    for name in [Path(problem).stem for problem in problems]:
        with test.subTest(name):
            open_page(results.page(name))
            _, poses = motion_of(results.result(name))
            steps = range(0, len(poses), 15)
            shown = []
            for step in steps:
                scrub(step)
                shown.append(driver.execute_script(PIN_CENTRES, ".own"))
            # A cam has its pin in its centre, which does not move; its follower has one that does.
            fit = Fit([poses[step] for step in steps], shown)
            test.assertGreater(fit.scale, 0)
            test.assertLess(fit.worst(), 0.25)


class PositionsOfDrives(unittest.TestCase):
    def test_are_those_of_the_analysis_to_the_pixel(self):
        compare_positions(self, [problem for problem in SOLVED if problem.startswith("quick-return/")])


class PositionsOfOthers(unittest.TestCase):
    def test_are_those_of_the_analysis_to_the_pixel(self):
        compare_positions(self, [problem for problem in SOLVED if not problem.startswith("quick-return/")])


if __name__ == "__main__":
    unittest.main(warnings="ignore")

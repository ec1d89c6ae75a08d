"""Several threads solve at once, Python goes on meanwhile, and Ctrl-C ends a search."""

import os
import signal
import subprocess
import sys
import threading
import time
import unittest
from concurrent.futures import ThreadPoolExecutor

import mechwright
from common import POINTS, PROBLEMS, long_search, path_search, plain, without_file

PROMPT = 10  # seconds; far less than any of these searches takes, far more than stopping does


class Threads(unittest.TestCase):
    def test_they_find_what_one_alone_finds(self):
        # Ipopt's linear solver has global state: the library lets one at a time have it.
        problems = [path_search(POINTS, starts=1, method=method) for method in ("ipopt", "slsqp", "ipopt", "auto")]
        problems += [PROBLEMS / "four-bar/crank-rocker.toml", PROBLEMS / "exact/five-timed-points.toml"]
        alone = [without_file(plain(mechwright.solve(problem))) for problem in problems]
        with ThreadPoolExecutor(len(problems)) as pool:
            together = list(pool.map(mechwright.solve, problems))
        self.assertEqual([without_file(plain(one)) for one in together], alone)

    def test_python_goes_on_while_one_solves(self):
        done = threading.Event()

        def search():
            mechwright.solve(long_search(), time_limit=1.5)
            done.set()

        thread = threading.Thread(target=search)
        thread.start()
        turns = 0
        while not done.is_set():
            time.sleep(0.01)
            turns += 1
        thread.join()
        self.assertGreater(turns, 20)

    def test_analysis_and_verification_in_threads(self):
        result = mechwright.solve(PROBLEMS / "four-bar/crank-rocker.toml")
        again = mechwright.verify(result)
        self.assertTrue(again["passed"])
        with ThreadPoolExecutor(4) as pool:
            for one in pool.map(mechwright.verify, [result] * 8):
                self.assertEqual(one, again)
            for one in pool.map(mechwright.analyse, [result] * 8):
                self.assertEqual(one["quantities"], result["quantities"])


class Interrupt(unittest.TestCase):
    def interrupted(self, problem, **options):
        """The seconds after the signal at which the search has ended."""
        sent = []

        def send():
            sent.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)

        timer = threading.Timer(0.7, send)
        timer.start()
        self.addCleanup(timer.cancel)
        with self.assertRaises(KeyboardInterrupt):
            mechwright.solve(problem, **options)
        return time.monotonic() - sent[0]

    def test_a_search(self):
        self.assertLess(self.interrupted(long_search()), PROMPT)
        self.assertLess(self.interrupted(long_search(), method="ipopt"), PROMPT)

    def test_a_proof(self):
        self.assertLess(self.interrupted(PROBLEMS / "path/case-2.toml", method="branch-and-bound", time_limit=600),
                        PROMPT)

    def test_all_is_well_afterwards(self):
        self.interrupted(long_search())
        self.assertEqual(mechwright.solve(PROBLEMS / "four-bar/crank-rocker.toml")["status"], "solved")

    def test_any_handler_may_end_a_search(self):
        class Enough(Exception):
            pass

        def on_alarm(number, frame):
            raise Enough

        before = signal.signal(signal.SIGALRM, on_alarm)
        self.addCleanup(signal.signal, signal.SIGALRM, before)
        signal.setitimer(signal.ITIMER_REAL, 0.5)
        begin = time.monotonic()
        with self.assertRaises(Enough):
            mechwright.solve(long_search())
        self.assertLess(time.monotonic() - begin, PROMPT)

    def test_a_handler_that_does_not_raise_lets_it_go_on(self):
        seen = []
        before = signal.signal(signal.SIGALRM, lambda number, frame: seen.append(number))
        self.addCleanup(signal.signal, signal.SIGALRM, before)
        signal.setitimer(signal.ITIMER_REAL, 0.3)
        self.assertEqual(mechwright.solve(long_search(), time_limit=1)["status"], "limit")
        self.assertEqual(seen, [signal.SIGALRM])

    def test_a_program_ends(self):
        code = "import common, mechwright\nprint('ready', flush=True)\nmechwright.solve(common.long_search())"
        process = subprocess.Popen([sys.executable, "-B", "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   text=True, cwd=os.path.dirname(__file__))
        process.stdout.readline()
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=PROMPT)
        self.assertIn("KeyboardInterrupt", errors)
        self.assertEqual(process.returncode, -signal.SIGINT)


if __name__ == "__main__":
    unittest.main()

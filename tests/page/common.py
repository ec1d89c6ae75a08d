"""What the tests of pages and drawings share: the program, problems, and a browser without a network."""

import json
import os
import subprocess
import tempfile
from pathlib import Path

SOURCE = Path(os.environ["MECHWRIGHT_SOURCE_DIR"])
PROGRAM = os.environ["MECHWRIGHT_PROGRAM"]
PROBLEMS = SOURCE / "problems"


def cases_to_try(few, every):
    """As many cases as a test has in the form that is run, as tests/long_form.h has it."""
    return every if "MECHWRIGHT_LONG_TESTS" in os.environ else few


def run(*arguments):
    """The command line program: exit code, standard output, standard error."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout, done.stderr


def succeed(*arguments):
    code, out, err = run(*arguments)
    if code != 0:
        raise AssertionError(f"{arguments}: exit code {code}\n{err}")
    return out


class Results:
    """A folder with the results of problems, each solved when it is asked for, gone at the end."""

    def __init__(self, *problems):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = Path(self._folder.name)
        self._problems = {Path(problem).stem: PROBLEMS / problem for problem in problems}

    def result(self, name):
        file = self.folder / f"{name}.json"
        if name in self._problems:
            succeed("solve", self._problems.pop(name), "--out", self.folder, "--quiet")
        return file

    def documents(self):
        """The results of all problems."""
        return [self.document(name) for name in sorted(self._problems)]

    def page(self, name):
        """The page on one result."""
        page = self.folder / f"{name}.html"
        succeed("report", self.result(name), "--out", page, "--quiet")
        return page

    def document(self, name):
        return json.loads(self.result(name).read_text())


def browser(scripts=True, width=1280, height=1500):
    """Chromium that knows no network, and keeps what pages say on their console and what they ask for."""
    # pylint: disable=import-outside-toplevel
    from selenium import webdriver
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service

    options = Options()
    options.binary_location = "/usr/bin/chromium"
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                     "--force-device-scale-factor=1", "--hide-scrollbars", f"--window-size={width},{height}"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    if not scripts:
        options.add_experimental_option("prefs", {"profile.managed_default_content_settings.javascript": 2})
    driver = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
    driver.execute_cdp_cmd("Network.enable", {})
    driver.execute_cdp_cmd("Network.emulateNetworkConditions",
                           {"offline": True, "latency": 0, "downloadThroughput": 0, "uploadThroughput": 0})
    return driver


def requests_of(driver):
    """The addresses that pages have asked for since the last call."""
    addresses = []
    for entry in driver.get_log("performance"):
        message = json.loads(entry["message"])["message"]
        if message["method"] == "Network.requestWillBeSent":
            addresses.append(message["params"]["request"]["url"])
    return addresses


def complaints_of(driver):
    """What the console has said since the last call."""
    return [entry["message"] for entry in driver.get_log("browser")]

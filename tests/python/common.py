"""What the tests of the Python module share: the program that it is compared with, problems, plain values."""

import json
import os
import subprocess
import tempfile
import tomllib
from pathlib import Path

import numpy as np

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


def solved_by_program(file, *options):
    return json.loads(run("solve", file, "--json", "--quiet", *options)[1])


def plain(value):
    """A result as the JSON document has it: lists for arrays, None for NaN."""
    if isinstance(value, dict):
        return {key: plain(one) for key, one in value.items()}
    if isinstance(value, list):
        return [plain(one) for one in value]
    if isinstance(value, np.ndarray):
        return plain(value.tolist())
    if isinstance(value, float) and np.isnan(value):
        return None
    return value


def but_for_time(document):
    """A document without the one number that is never the same twice."""
    return {**document, "search": {**document["search"], "seconds": None}}


def without_file(document):
    """A document without what differs between a problem in a file and the same in a dict."""
    problem = {**document["problem"], "file": None, "sha256": None, "text": None}
    return {**but_for_time(document), "problem": problem}


def table_of(file):
    with open(file, "rb") as stream:
        return tomllib.load(stream)


class Folder:
    """A folder for the files of a test."""

    def __init__(self, test):
        folder = tempfile.TemporaryDirectory()
        test.addCleanup(folder.cleanup)
        self.path = Path(folder.name)

    def write(self, name, text):
        file = self.path / name
        file.write_bytes(text if isinstance(text, bytes) else text.encode())
        return file


def crank_rocker():
    return {
        "schema": 1,
        "mechanism": "four-bar",
        "dimensions": {
            "ground": 100.0,
            "crank": {"min": 5, "max": 60},
            "coupler": {"min": 20, "max": 300},
            "rocker": {"min": 20, "max": 300},
        },
        "require": [
            {"quantity": "swing", "equal": 60},
            {"quantity": "time-ratio", "equal": 1.1176470588235294},
        ],
        "objective": {"maximize": "transmission-angle-worst"},
    }


def given_linkage():
    return {
        "schema": 1,
        "mechanism": "four-bar",
        "dimensions": {"ground": 100.0, "crank": 34.0, "coupler": 93.0, "rocker": 70.0},
    }


# No four-bar meets them exactly: such searches end soon, others go on among all that do.
POINTS = [[20, 20], [22, 25], [20, 30], [17, 35], [20, 40], [26, 43], [32, 40], [35, 33], [33, 26]]


def path_search(points, **solver):
    free = {"min": -100, "max": 100}
    length = {"min": 5, "max": 200}
    return {
        "schema": 1,
        "mechanism": "four-bar",
        "dimensions": {
            "ground": length, "crank": length, "coupler": length, "rocker": length,
            "point-along": free, "point-across": free, "origin-x": free, "origin-y": free,
            "tilt": {"min": 0, "max": 360},
        },
        "path": {"points": points},
        "objective": {"minimize": "path-rms"},
        "solver": solver,
    }


def long_search():
    """Takes as long as it is allowed to."""
    points = [[20, 20], [20, 25], [20, 30], [20, 35], [20, 40], [20, 45], [25, 47], [30, 44], [31, 38], [28, 30]]
    return path_search(points, starts=100000, time_limit=600)

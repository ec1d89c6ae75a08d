"""The schema of problem files: it takes what the program takes, and refuses what is misspelt or of a wrong kind."""

import copy
import itertools
import tempfile
import tomllib
import unittest
from pathlib import Path

from common import PROBLEMS, SOURCE, cases_to_try, faults, run, schema_of, table_of, tables_in, validator_of

SCHEMA = schema_of("problem")
VALIDATOR = validator_of(SCHEMA)
OWN_KEYS_OF_STUDY = set(SCHEMA["properties"]["study"]["properties"])

BASE = """schema = 1
mechanism = "four-bar"
[dimensions]
ground = 100
crank = { min = 5, max = 60 }
coupler = { min = 20, max = 300 }
rocker = { min = 20, max = 300 }
[[objective]]
maximize = "transmission-angle-worst"
[[objective]]
minimize = "total-length"
"""


def written(value):
    """A value as TOML."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f'"{key}" = {written(below)}' for key, below in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(written, value)) + "]"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'
    return repr(value)


def names_freely(place, own_names):
    """Whether a table's keys are names of values or variables: those of a study that it does not say of itself, and what
    a linkage's file names: `place` is in such a file if `own_names`."""
    if place == ("dimensions",) and own_names:
        return True
    if place[:1] in (("links",), ("assembly",), ("signals",)) and len(place) < 3:
        return not (len(place) == 2 and place[0] in ("assembly", "signals"))
    if place == ("sketch", "points") or place == ("signals", "sum"):
        return True
    return place[:1] == ("study",) and len(place) > 1 and (place[1] not in OWN_KEYS_OF_STUDY or place[1] == "case")


class Agreement(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def accepted(self, text):
        """Whether the program takes a text as a problem."""
        file = self.folder / "problem.toml"
        file.write_text(text, encoding="utf-8")
        return run("check", "--quiet", file)[0] == 0

    def test_every_problem_is_valid(self):
        self.assertGreater(len(PROBLEMS), 90)
        for file in PROBLEMS:
            with self.subTest(file=file.name):
                self.assertEqual(faults(VALIDATOR, table_of(file)), [])

    def test_what_the_program_takes_is_valid(self):
        taken = 0
        corpus = SOURCE / "tests/fuzz/corpus/problem"
        for file in sorted(corpus.iterdir()):
            if run("check", "--quiet", file)[0] != 0:
                continue
            taken += 1
            with self.subTest(file=file.name):
                self.assertEqual(faults(VALIDATOR, table_of(file)), [])
        self.assertGreater(taken, 20)

    def test_targets_of_a_built_in_kind_are_not_several(self):
        path = "[[path]]\npoints = [[0, 0], [1, 1]]\n"
        for text, good in ((BASE + path, True), (BASE + path + path, False), (BASE + path + "name = 'foot'\n", False)):
            with self.subTest(text=text):
                self.assertEqual(faults(VALIDATOR, tomllib.loads(text)) == [], good)
                self.assertEqual(self.accepted(text), good)

    def test_what_new_writes_is_valid(self):
        pairs = [line.split()[:2] for line in run("new", "--list")[1].splitlines() if ":" in line and not line.startswith(" ")]
        self.assertGreater(len(pairs), 12)
        for mechanism, task in ((mechanism, task.rstrip(":")) for mechanism, task in pairs):
            file = self.folder / f"{mechanism}-{task}.toml"
            with self.subTest(file=file.name):
                self.assertEqual(run("new", file, "--mechanism", mechanism, "--task", task)[0], 0)
                self.assertEqual(faults(VALIDATOR, table_of(file)), [])

    def mutants(self, mutate):
        """Every problem changed in one place, each kind of place once: (file, place, problem)."""
        seen = set()
        for file in PROBLEMS:
            whole = table_of(file)
            for place, table in tables_in(whole):
                if names_freely(place, whole["mechanism"] == "linkage"):
                    continue
                for key in list(table):
                    mark = (whole["mechanism"], place, key)
                    if mark in seen or (place == ("study",) and key not in OWN_KEYS_OF_STUDY):
                        continue
                    changed = mutate(table, key)
                    if changed is None:
                        continue
                    seen.add(mark)
                    before = dict(table)
                    table.clear()
                    table.update(changed)
                    yield file, (*place, key), copy.deepcopy(whole)
                    table.clear()
                    table.update(before)

    def refused_by_both(self, mutate):
        asked, count = set(), 0
        for file, place, problem in itertools.islice(self.mutants(mutate), 0, None, cases_to_try(4, 1)):
            count += 1
            with self.subTest(file=file.name, place=".".join(place)):
                self.assertNotEqual(faults(VALIDATOR, problem), [])
                # A file that is named would not be found where the changed problem is written.
                if place not in asked and "points_file" not in str(problem):
                    asked.add(place)
                    text = "\n".join(f'"{key}" = {written(value)}' for key, value in problem.items())
                    self.assertFalse(self.accepted(text))
        self.assertGreater(count, cases_to_try(40, 150))

    def test_a_misspelt_key_is_refused(self):
        self.refused_by_both(lambda table, key: {(name + "s" if name == key else name): value
                                                 for name, value in table.items()})

    def test_a_value_of_a_wrong_kind_is_refused(self):
        def wrong(table, key):
            value = table[key]
            if isinstance(value, (dict, list)):
                return None
            return {**table, key: 7 if isinstance(value, bool) else True}

        self.refused_by_both(wrong)

    def test_a_word_that_there_is_not_is_refused(self):
        # A start may be a sum of dimensions.
        free = {"title", "length", "points_file", "expression", "name", "x", "y", "value", "family", "each", "where",
                "start"}

        def misspelt(table, key):
            return {**table, key: table[key] + "q"} if isinstance(table[key], str) and key not in free else None

        for file, place, problem in self.mutants(misspelt):
            is_of_linkage = problem.get("mechanism") == "linkage"
            if (is_of_linkage and place != ("mechanism",)) or place[0] in ("signals", "room", "region"):
                continue  # it names things itself; these are of points and links, which the schema does not know
            with self.subTest(file=file.name, place=".".join(place)):
                self.assertNotEqual(faults(VALIDATOR, problem), [])

    def test_limits_are_those_of_the_program(self):
        limits = 0
        for key, schema in SCHEMA["properties"]["solver"]["properties"].items():
            whole = schema.get("type") == "integer"
            for bound, sign in (("minimum", -1), ("exclusiveMinimum", -1), ("maximum", 1)):
                if bound not in schema:
                    continue
                limits += 1
                at = int(schema[bound]) if whole else float(schema[bound])
                beyond = at + sign * (1 if whole else max(abs(at), 1) * 0.1)
                for value, good in ((at, bound != "exclusiveMinimum"), (beyond, False)):
                    with self.subTest(key=key, value=value):
                        text = BASE + f"[solver]\n{key} = {value!r}\n"
                        self.assertEqual(faults(VALIDATOR, tomllib.loads(text)) == [], good)
                        self.assertEqual(self.accepted(text), good)
        self.assertGreaterEqual(limits, 8)

    def test_every_method_and_no_other(self):
        for method in SCHEMA["properties"]["solver"]["properties"]["method"]["enum"]:
            self.assertIn(method, run("methods")[1])

    def test_everything_is_told_to_editors(self):
        for place, table in tables_in(SCHEMA["properties"]):
            if place and place[-1] == "properties":
                for key, schema in table.items():
                    with self.subTest(place=place, key=key):
                        self.assertTrue(schema is False or "description" in schema or key in ("name",))


if __name__ == "__main__":
    unittest.main()

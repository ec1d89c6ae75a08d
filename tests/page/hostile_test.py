"""Result documents of which a part is something else than it should be: no page, picture or drawing may fail on them."""

import copy
import json
import random
import unittest

from common import Results, cases_to_try, run

STRANGE = [None, True, 0, -1, 1e308, 1e-320, -1e300, 10**18, "", "x" * 1000, "</script>", "\u0000", [], [[]], {}, {"a": 1},
           [1, 2], [None] * 3, [[1, 2], [3]], "four-bar", "cam"]


def places_in(json_value, path=()):
    """Every place of a document."""
    yield path
    if isinstance(json_value, dict):
        for key, one in json_value.items():
            yield from places_in(one, path + (key,))
    elif isinstance(json_value, list):
        for i, one in enumerate(json_value):
            yield from places_in(one, path + (i,))


def changed(document, path, value):
    document = copy.deepcopy(document)
    part = document
    for key in path[:-1]:
        part = part[key]
    part[path[-1]] = value
    return document


def setUpModule():  # pylint: disable=invalid-name
    global results, documents  # pylint: disable=global-variable-undefined
    results = Results("exact/problem-3.toml", "cam/roller-offset.toml", "trade-off/case-4-margin.toml",
                      "function/power.toml", "quick-return/uniform-speed-drag-link.toml")
    documents = results.documents()


class Hostile:
    """Documents to be changed, the same ones in every run."""

    @classmethod
    def setUpClass(cls):
        cls.random = random.Random(20261122)

    def mutated(self):
        document = self.random.choice(documents)
        for _ in range(self.random.choice((1, 1, 2, 3))):
            path = self.random.choice([p for p in places_in(document) if p])
            document = changed(document, path, self.random.choice(STRANGE))
        return document


class HostilePages(Hostile, unittest.TestCase):
    def test_are_made_or_refused(self):
        for batch in range(cases_to_try(2, 6)):
            folder = results.folder / f"batch{batch}"
            folder.mkdir()
            for i in range(80):
                (folder / f"{i:03}.json").write_text(json.dumps(self.mutated()))
            code, _, err = run("report", folder)
            self.assertIn(code, (0, 3), err)
            self.assertTrue((folder / "report.html").exists())


class HostileDrawings(Hostile, unittest.TestCase):
    def test_are_made_or_refused(self):
        for i in range(cases_to_try(40, 120)):
            file = results.folder / "mutated.json"
            file.write_text(json.dumps(self.mutated()))
            command = self.random.choice((["draw"], ["export", "--format", "dxf"], ["export", "--out", results.folder / "x.slvs"],
                                          ["export", "--format", "json", "--steps", "12"], ["profile", "--dxf"],
                                          ["export", "--format", "csv", "--steps", "12"]))
            code, _, err = run(command[0], file, *command[1:])
            self.assertIn(code, (0, 2, 3, 4), f"{i} {command}: {err}\n{file.read_text()[:3000]}")


if __name__ == "__main__":
    unittest.main(warnings="ignore")

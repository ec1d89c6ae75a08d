"""Every message of the program reaches Python, and nothing that a dict can hold does any harm."""

import decimal
import os
import random
import threading
import tomllib
import unittest
import warnings

import mechwright
import numpy as np
from common import PROBLEMS, Folder, crank_rocker, given_linkage, path_search, run

HEAD = 'schema = 1\nmechanism = "four-bar"\n'
LINKS = "[dimensions]\nground = 100\ncrank = {min = 5, max = 60}\ncoupler = {min = 20, max = 300}\nrocker = 80\n"

BAD_TEXTS = [
    "",
    "schema = 1",
    "schema = 2\n" + LINKS,
    'schema = 1\nmechanism = "five-bar"\n' + LINKS,
    HEAD + LINKS.replace("crank", "krank"),
    HEAD + LINKS.replace("min = 5", "min = 70"),
    HEAD + LINKS.replace("ground = 100", "ground = -1\ncolour = true"),
    HEAD + LINKS.replace("ground = 100", "ground = nan"),
    HEAD + LINKS.replace("ground = 100", "ground = inf"),
    HEAD + LINKS.replace("ground = 100", 'ground = "long"'),
    HEAD + LINKS.replace("ground = 100", "ground = [1, 2]"),
    HEAD + LINKS + '[[require]]\nquantity = "swign"\nequal = 60\n[[require]]\nquantity = "swing"\nmin = 3\nmax = 2\n',
    HEAD + LINKS + '[[require]]\nquantity = "swing"\n',
    HEAD + LINKS + '[objective]\nmaximise = "swing"\n',
    HEAD + LINKS + '[path]\npoints = []\n[objective]\nminimize = "path-rms"\n',
    HEAD + LINKS + '[path]\npoints = [[1, 2], [1, 2], [3, "x"], [nan, 3], [1, 2, 3]]\n',
    HEAD + LINKS + '[path]\npoints_file = "bad.csv"\n',
    HEAD + LINKS + '[function]\nexpression = "x^"\nx = [1, 4]\n',
    HEAD + LINKS + "[solver]\nstarts = 1.5\nseed = -1\ntime_limit = 0\ntolerance = 7\n",
    HEAD + LINKS + '[solver]\nmethod = "best"\n',
    HEAD + LINKS + '[solver]\nmethod = "exact"\n',
    HEAD + LINKS + '[units]\nangle = "gon"\n"größe" = "\\u007f"\n',
    HEAD + "".join(f"k{i} = {i}\n" for i in range(300)),
    'schema = 1\nmechanism = "cam"\n[cam]\nfollower = "ball"\nmotion = "translating"\n[[segment]]\nkind = "rise"\n',
    # no TOML
    "schema = = 1",
    HEAD + LINKS + "[dimensions]\n",
    b"schema = 1\n\xff\xfe",
    b"schema = 1\0",
    "a" + ".a" * 20 + " = 1\n",
    "[" * 500,
]


def error_of(function, *arguments, **options):
    try:
        function(*arguments, **options)
    except (TypeError, ValueError, OSError) as error:
        return error
    return None


class BadFiles(unittest.TestCase):
    def setUp(self):
        self.folder = Folder(self)
        self.folder.write("bad.csv", "x,y\n1,2\n1,z\n")

    def test_all_messages_are_those_of_check(self):
        for text in BAD_TEXTS:
            with self.subTest(text):
                file = self.folder.write("bad.toml", text)
                error = error_of(mechwright.solve, file)
                self.assertIsInstance(error, mechwright.ProblemError)
                self.assertEqual(f"{error}\n", run("check", file)[2])
                self.assertEqual("\n".join(self.as_line(message) for message in error.messages), str(error))

    @staticmethod
    def as_line(message):
        place = f":{message['line']}:{message['column']}" if message["line"] is not None else ""
        return f"{message['file']}{place}: {'warning: ' if message['warning'] else ''}{message['text']}"

    def test_a_dict_has_the_messages_of_the_file(self):
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.folder.path)
        compared = 0
        for text in BAD_TEXTS:
            try:
                table = tomllib.loads(text if isinstance(text, str) else text.decode())
            except (tomllib.TOMLDecodeError, UnicodeDecodeError, RecursionError):
                continue
            if ".a.a" in text:  # its fault is the way in which it is written
                continue
            with self.subTest(text):
                of_file = error_of(mechwright.solve, self.folder.write("bad.toml", text))
                of_dict = error_of(mechwright.solve, table)
                self.assertIsInstance(of_dict, mechwright.ProblemError)
                # Keys have places of their own in a file; in a dict the message may come with those of the value.
                self.assertEqual(sorted(one["text"] for one in of_dict.messages),
                                 sorted(one["text"] for one in of_file.messages))
                compared += 1
        self.assertGreater(compared, 20)

    def test_files_that_cannot_be_read(self):
        named = self.folder.write("named.toml", HEAD + LINKS + '[path]\npoints_file = "none.csv"\n')
        for file in ("/nowhere/at/all.toml", self.folder.path, named, ""):
            with self.subTest(file):
                error = error_of(mechwright.solve, file)
                self.assertIsInstance(error, OSError)
                self.assertEqual(f"{error}\n", run("check", file)[2])

    def test_a_name_with_nul(self):
        self.assertIsInstance(error_of(mechwright.solve, "a\0b"), ValueError)


class Methods(unittest.TestCase):
    file = PROBLEMS / "four-bar/crank-rocker.toml"

    def test_an_unknown_one(self):
        error = error_of(mechwright.solve, self.file, method="best")
        self.assertIsInstance(error, mechwright.ProblemError)
        self.assertEqual(f"mechwright: --method: {error.messages[0]['text']}\n",
                         run("solve", self.file, "--method", "best")[2])

    def test_one_that_does_not_apply(self):
        error = error_of(mechwright.solve, self.file, method="least-squares")
        self.assertIsInstance(error, mechwright.ProblemError)
        self.assertEqual(f"mechwright: --method: {error}\n", run("solve", self.file, "--method", "least-squares")[2])

    def test_options_out_of_range(self):
        for options in ({"seed": -1}, {"jobs": 0}, {"jobs": 1025}, {"time_limit": 0}, {"time_limit": float("nan")},
                        {"time_limit": float("inf")}):
            with self.assertRaisesRegex(ValueError, next(iter(options))):
                mechwright.solve(self.file, **options)
        for options in ({"seed": "1"}, {"jobs": 1.5}, {"time_limit": "long"}, {"method": 3}, {"speed": 1}):
            with self.assertRaises(TypeError):
                mechwright.solve(self.file, **options)


class Places(unittest.TestCase):
    """Messages about a dict name what they are about."""

    def test_of_messages(self):
        problem = crank_rocker()
        problem["require"][0]["quantity"] = "swign"
        problem["dimensions"]["crank"]["min"] = 70
        problem["dimensions"]["coupler"]["max"] = float("nan")
        problem["colour"] = "red"
        error = error_of(mechwright.solve, problem)
        names = [message["name"] for message in error.messages]
        self.assertEqual(names, ["dimensions.crank.min", "dimensions.coupler.max", "require[0].quantity", "colour"])
        self.assertEqual({message["file"] for message in error.messages}, {"<dict>"})
        self.assertEqual([line.split(": ")[0] for line in str(error).splitlines()], names)

    def test_of_what_is_missing(self):
        error = error_of(mechwright.solve, {"schema": 1})
        self.assertEqual({message["name"] for message in error.messages}, {None})
        self.assertTrue(all(line.startswith("<dict>: ") for line in str(error).splitlines()))

    def test_of_another_requirement(self):
        problem = crank_rocker()
        problem["require"].append({"quantity": "swing", "max": 50})
        error = error_of(mechwright.solve, problem)
        self.assertEqual(str(error), "require[2]: no value of 'swing' can meet both this and the requirement "
                                     "require[0]")

    def test_beyond_ascii(self):
        problem = {"größe": "ü" * 50, "schema": 1, "mechanism": "four-bar", "dimensions": {"ground": "x"}}
        names = [message["name"] for message in error_of(mechwright.solve, problem).messages]
        self.assertIn("größe", names)
        self.assertIn("dimensions.ground", names)


class BadDicts(unittest.TestCase):
    def test_bad_types_name_their_place(self):
        for value, kind in ((None, "NoneType"), ({1, 2}, "set"), (object(), "object"), (b"x", "bytes"),
                            (1j, "complex"), (decimal.Decimal(1), "Decimal"), (np.complex128(1), "complex128"),
                            (np.datetime64("2020"), "datetime64"), (lambda: 1, "function"), (len, "builtin")):
            problem = crank_rocker()
            problem["require"][0]["min"] = value
            error = error_of(mechwright.solve, problem)
            self.assertIsInstance(error, TypeError, kind)
            self.assertRegex(str(error), rf"^require\[0\]\.min: .*{kind}")

    def test_arrays_of_bad_types(self):
        for value in (np.array([[1j, 2]]), np.array([[None, 2]], dtype=object), np.array(["2020"], dtype="M8[D]"),
                      np.array([b"x"]), np.zeros(2, dtype=[("a", float)])):
            problem = path_search(value)
            error = error_of(mechwright.solve, problem)
            self.assertIsInstance(error, (TypeError, ValueError), value.dtype)

    def test_keys_that_are_no_strings(self):
        for key in (1, None, b"x", ("a",)):
            problem = crank_rocker()
            problem["dimensions"][key] = 1
            self.assertRegex(str(error_of(mechwright.solve, problem)), r"^dimensions: the key .* is not a string")

    def test_what_is_neither_dict_nor_path(self):
        for problem in (None, 3, [], [crank_rocker()], b"problem.toml", np.zeros(3)):
            for function in (mechwright.solve, mechwright.analyse, mechwright.verify):
                self.assertIsInstance(error_of(function, problem), TypeError)

    def test_numbers_too_large(self):
        for value in (2**63, -2**64, 10**400):
            problem = crank_rocker()
            problem["require"][0]["equal"] = value
            error = error_of(mechwright.solve, problem)
            self.assertIsInstance(error, ValueError)
            self.assertTrue(str(error).startswith("require[0].equal: "))

    def test_numbers_that_are_none(self):
        for value in (float("nan"), float("inf"), -np.inf, np.float32("nan")):
            problem = crank_rocker()
            problem["require"][0]["equal"] = value
            error = error_of(mechwright.solve, problem)
            self.assertIsInstance(error, mechwright.ProblemError)
            self.assertTrue(str(error).startswith("require[0].equal: "), str(error))

    def test_no_text(self):
        for change in ({"title": "\ud800"}, {"\udfff": 1}):
            self.assertIsInstance(error_of(mechwright.solve, {**crank_rocker(), **change}), ValueError)

    def test_titles_of_every_character(self):
        for title in ("", "\0", "\x7f\x1b\r\n\t\b\f", "\"'\\", "ü\u2028😀", '"""', "#", "a\\u0041"):
            problem = {**crank_rocker(), "title": title}
            error = error_of(mechwright.solve, problem)
            if error is None:
                self.assertEqual(mechwright.solve(problem)["problem"]["title"], title)
            else:
                self.assertIsInstance(error, mechwright.ProblemError)

    def test_deep_and_endless_nesting(self):
        deep = {}
        for _ in range(100000):
            deep = {"a": deep}
        self.assertRegex(str(error_of(mechwright.solve, deep)), "deep$")
        flat = []
        flat.append(flat)
        for endless in ({"dimensions": flat}, {"dimensions": {"ground": flat}}):
            endless["schema"] = endless
            for function in (mechwright.solve, mechwright.analyse, mechwright.verify):
                self.assertRegex(str(error_of(function, endless)), "deep$")
        while deep:  # Python itself frees deep nests by recursion
            deep = deep["a"]

    def test_keys_that_look_like_toml(self):
        for key in ("a.b", "[x]", '"', "", "#", "=", "\n", "schema ", "a" * 100000):
            error = error_of(mechwright.solve, {**crank_rocker(), key: 1})
            self.assertIsInstance(error, mechwright.ProblemError)
            self.assertEqual(len(error.messages), 1)
            self.assertEqual(len(str(error).splitlines()), 1)

    def test_numbers_of_ones_own(self):
        class Index:
            def __index__(self):
                return 60

        class Failing:
            def __index__(self):
                raise RuntimeError("no number today")

        problem = crank_rocker()
        problem["require"][0]["equal"] = Index()
        self.assertEqual(mechwright.solve(problem)["status"], "solved")
        problem["require"][0]["equal"] = Failing()
        self.assertEqual(str(error_of(mechwright.solve, problem)), "require[0].equal: no number today")

    def test_large_arrays(self):
        error = error_of(mechwright.solve, path_search(np.random.default_rng(1).random((300000, 2))))
        self.assertIsInstance(error, mechwright.ProblemError)
        self.assertIn("path.points: 300000 points are too many", str(error))

    def test_anything_at_all(self):
        dice = random.Random(5)
        leaves = [None, True, 0, -1, 1.5, float("nan"), "", "four-bar", "swing", [], {}, (), np.arange(3), 2**70,
                  np.float32(2), "min", object(), [[1, 2], [3, 4]], b""]
        keys = ["schema", "mechanism", "dimensions", "require", "quantity", "min", "max", "path", "points", "equal",
                "ground", "segment", "cam", "units", "solver", "study", "function", "poses", "objective", "problem",
                "design", "crank", "status", "x", 3]

        def anything(depth):
            kind = dice.randrange(4) if depth < 5 else 0
            if kind < 2:
                return dice.choice(leaves)
            if kind == 2:
                return [anything(depth + 1) for _ in range(dice.randrange(4))]
            return {dice.choice(keys): anything(depth + 1) for _ in range(dice.randrange(6))}

        for _ in range(3000):
            problem = crank_rocker() if dice.random() < 0.5 else given_linkage()
            for _ in range(dice.randrange(1, 4)):
                problem[dice.choice(keys)] = anything(0)
            problem["solver"] = problem.get("solver", {"time_limit": 1, "starts": 1})
            for function in (mechwright.verify, mechwright.analyse):
                error_of(function, problem)


class Warnings(unittest.TestCase):
    problem = {
        "schema": 1,
        "mechanism": "four-bar",
        "dimensions": {"ground": 100, "crank": 34, "coupler": 93, "rocker": 70},
        "require": [{"quantity": "swing", "equal": 60}],
    }

    def test_they_are_pythons(self):
        with self.assertWarns(mechwright.ProblemWarning) as caught:
            mechwright.solve(self.problem)
        self.assertEqual(caught.filename, __file__)
        self.assertIn("warning: ", str(caught.warning))

    def test_they_can_be_made_errors(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error", mechwright.ProblemWarning)
            with self.assertRaises(mechwright.ProblemWarning):
                mechwright.solve(self.problem)

    def test_they_come_with_the_errors(self):
        problem = {**self.problem, "colour": 1}
        messages = error_of(mechwright.solve, problem).messages
        self.assertEqual(sorted(message["warning"] for message in messages), [False, True])

    def test_errors_are_raised_in_any_thread(self):
        seen = []
        thread = threading.Thread(target=lambda: seen.append(error_of(mechwright.solve, {"schema": 3})))
        thread.start()
        thread.join()
        self.assertIsInstance(seen[0], mechwright.ProblemError)


if __name__ == "__main__":
    unittest.main()

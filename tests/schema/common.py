"""What the tests of the schemas share: the program, its schemas with their validator, and places in documents."""

import json
import os
import subprocess
import tomllib
from pathlib import Path

from jsonschema import Draft7Validator

SOURCE = Path(os.environ["MECHWRIGHT_SOURCE_DIR"])
PROGRAM = os.environ["MECHWRIGHT_PROGRAM"]
PROBLEMS = sorted((SOURCE / "problems").rglob("*.toml"))


def cases_to_try(few, every):
    """As many cases as a test has in the form that is run, as tests/long_form.h has it."""
    return every if "MECHWRIGHT_LONG_TESTS" in os.environ else few


def run(*arguments):
    """The program: exit code, standard output, standard error."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, check=False)
    return done.returncode, done.stdout.decode(), done.stderr.decode(errors="replace")


def schema_of(document):
    code, text, _ = run("schema", document)
    assert code == 0
    return json.loads(text)


def validator_of(schema):
    Draft7Validator.check_schema(schema)
    return Draft7Validator(schema)


def faults(validator, document):
    """The innermost errors, each with its place."""
    def innermost(error):
        return [one for below in error.context for one in innermost(below)] if error.context else [error]

    return ["/".join(map(str, one.absolute_path)) + ": " + one.message[:200]
            for error in validator.iter_errors(document) for one in innermost(error)]


def table_of(file):
    return tomllib.loads(file.read_text(encoding="utf-8-sig"))


def tables_in(value, place=()):
    """Every table with its place: the keys that lead to it, without numbers of entries."""
    if isinstance(value, dict):
        yield place, value
        for key, below in value.items():
            yield from tables_in(below, (*place, key))
    elif isinstance(value, list):
        for below in value:
            yield from tables_in(below, place)

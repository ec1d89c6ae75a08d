"""The functions of the package."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Dict, Iterable, Optional

from . import _program
from .comparison import Comparison
from .record import Record
from .result import Result
from .source import Source, given
from .texts import Text

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


def solve(
    problem: Source,
    *,
    method: Optional[str] = None,
    seed: Optional[int] = None,
    jobs: Optional[int] = None,
    time_limit: Optional[float] = None,
    all: bool = False,
) -> Result:
    """Designs the mechanism that a problem asks for, and verifies it.

    problem     a Problem; a dict with the keys and values of a problem file (dicts, lists, tuples, numbers, strings,
                NumPy arrays and scalars), in which names of files are relative to the current folder; or the path of a
                problem file
    method      takes the place of the problem's; so do seed (from 0 on) and time_limit (seconds)
    jobs        threads, 1 to 1024; by default all processors. The numbers do not depend on it.
    all         keeps the designs with defects that an exact method finds

    Lists of numbers in the Result are arrays of float64, points of shape (n, 2), NaN where there is no number. That
    nothing was found is no exception: see its status.

    Raises ProblemError for a problem that is not valid, a result in its place, or a method that does not apply; OSError
    for a file that cannot be read; TypeError and ValueError for a dict of what no file can hold; KeyboardInterrupt on
    Ctrl-C, which ends the search. Warns with ProblemWarning. Other threads of Python run on meanwhile, and may solve too.
    """
    return Result(_program.solve(given(problem), method, seed, jobs, time_limit, all))


def analyse(problem: Source, *, crank_angles: Optional[ArrayLike] = None, steps: int = 360) -> Record:
    """Evaluates one mechanism.

    problem       a problem that leaves no dimension open (Problem, dict or path), or a result of solve (Result, dict, or
                  the path of a file that ends in .json)
    crank_angles  an array of any shape, in the angle unit of the problem, counted from the ground link; by default the
                  ends of the motion and steps - 1 angles between them at which the mechanism assembles
    steps         1 to 1000000

    Returns units, design, quantities, requirements and what else the result document says of a design, and 'motion', a
    dict of arrays of float64 by the names of the columns ('rocker-angle'), of the shape of crank_angles and in the
    problem's units. Where the mechanism does not assemble at a given crank angle they are NaN; where it assembles at
    none, the arrays are empty.

    Raises ProblemError, OSError, TypeError and ValueError as solve does; ValueError for what is not a result.
    """
    return Record(_program.analyse(given(problem), crank_angles, steps))


def verify(result: Source) -> Record:
    """Checks a result (Result, dict, or path of a file) again from the document alone, independently of the optimiser, in
    fifty digits.

    Returns {'passed': bool, 'checks': [{'name', 'passed', 'detail'}, ...]}. Raises ValueError for what is not a result
    document, OSError for a file that cannot be read.
    """
    return Record(_program.verify(result))


def check(problem: Source) -> None:
    """Checks a problem (Problem, dict or path) and does not solve it: says nothing if all is well.

    Raises ProblemError with all that is wrong, each message with file and line, or the name of the value, and with what
    would be right; OSError, TypeError and ValueError as solve does. Warns with ProblemWarning of what is odd.
    """
    _program.check(given(problem))


def compare(
    problems: Iterable[Source],
    *,
    method: Optional[str] = None,
    seed: Optional[int] = None,
    jobs: Optional[int] = None,
    time_limit: Optional[float] = None,
) -> Comparison:
    """Solves one task on several mechanisms.

    problems  two or more (Problems, dicts or paths); the rest is as for solve, with time_limit for each of them

    Returns a Comparison: Records, of designs that were found first, and if all problems have the same objective, of the
    better ones first. Values are in the units of each problem.

    Raises ValueError for fewer than two problems; else as solve does, before the first is solved.
    """
    if isinstance(problems, (dict, str, os.PathLike)):
        raise ValueError("compare needs two problems or more, in a list")
    return Comparison(_program.compare([given(problem) for problem in problems], method, seed, jobs, time_limit))


def explain(name: str, mechanism: Optional[str] = None) -> Text:
    """What a name means: a quantity, a dimension, a setting, a mechanism, a signal, or a section or key of a problem
    file ('swing', 'crank', 'four-bar', 'path', 'solver.method').

    mechanism  only as this mechanism has it

    Returns a str that shows its lines. Raises ValueError for a name or a mechanism that is not known, with the nearest
    that is.
    """
    return Text(_program.explain(name, mechanism or ""))


def quantities(mechanism: str) -> Dict[str, Dict[str, str]]:
    """What can be required or optimised of a mechanism ('four-bar'): name -> {'unit', 'meaning'}. The unit is 'number',
    'length', 'area', 'angle', 'force' or 'torque'. Raises ValueError for an unknown mechanism.
    """
    return _program.quantities(mechanism)

"""Studies: a problem solved for many values of what it says."""

from __future__ import annotations

import os
import shutil
import tempfile
import weakref
from typing import Any, Dict, List, Optional, Union

import numpy as np

from . import _program
from .record import Record
from .source import Path, Source, given
from .tables import table
from .texts import Page, Picture, Text


def is_study(folder: Path) -> bool:
    """Whether a folder holds the data of a study."""
    return os.path.isfile(os.path.join(os.fspath(folder), "study.sqlite"))


class Study(Record):
    """What a study has come to, a dict whose members are attributes: `title`, `points` that there are to be, `done` of
    them, `complete`, and `statuses`, the number of points by status. The data are in `folder`. In notebooks it is a
    table, with the charts.
    """

    title: str
    points: int
    done: int
    complete: bool
    statuses: Record

    def __init__(self, folder: Path) -> None:
        """The study whose data are in a folder. Raises OSError where there are none."""
        super().__init__(_program.study_standing(os.fsencode(folder)))
        self._folder = os.fspath(folder)
        self._tolerances = ""

    @property
    def folder(self) -> str:
        """The folder of the data."""
        return self._folder

    @property
    def tolerances(self) -> Text:
        """What the tolerances do, as tables; empty for a study of something else, or one read from its folder."""
        return Text(self._tolerances)

    def data(self, sql: Optional[str] = None, *, time_limit: float = 60) -> Record:
        """The points in order, or what an SQL SELECT on the table `points` gives, as columns by their names: arrays of
        float64 for numbers, NaN where there is none, and lists for all else.

        Lengths and angles are in the problem's units; time_limit is the query's, in seconds. Raises ValueError for SQL
        that is not understood, changes something or takes too long.
        """
        return Record(_columns(_program.study_data(os.fsencode(self.folder), sql or "", time_limit)))

    def charts(self) -> Dict[str, Picture]:
        """The charts that the study asks for, else one of the objective, if there is one, by their names. Raises OSError
        without gnuplot, and where there is nothing to be drawn.
        """
        return {name: Picture(svg) for name, svg in _program.study_charts(os.fsencode(self.folder)).items()}

    def report(self, out: Optional[Path] = None, **options: Any) -> Page:
        """`mechwright.report` on this study, with its options."""
        from .showing import report

        return report(self, out, **options)

    def __repr__(self) -> str:
        statuses = ", ".join(f"{count} {status}" for status, count in self.statuses.items())
        return f"<Study: {self.done} of {self.points} points: {statuses}>"

    def _repr_html_(self) -> str:
        rows = [("points", self.points), ("done", self.done), *self.statuses.items()]
        try:
            charts = "".join(self.charts().values())
        except OSError:
            charts = ""
        return f"<div>{table(self.title or 'Study', rows)}{charts}</div>"


def study(
    problem: Source,
    folder: Optional[Path] = None,
    *,
    jobs: Optional[int] = None,
    time_limit: Optional[float] = None,
) -> Study:
    """Solves a problem for all the values that its [study] gives.

    problem     with a [study]: a Problem, a dict, or the path of a problem file
    folder      keeps the data: a new one, or that of a study to go on with; by default one that goes with the Study
    jobs        threads, 1 to 1024; by default all processors. The data do not depend on it.
    time_limit  seconds after which no other point is begun

    Returns a Study, also where points are left: see its `complete`.

    Raises ProblemError for a problem that is not valid or has no [study]; OSError for files and folders that cannot be
    used, and a design whose tolerances are asked for and that is not found; KeyboardInterrupt on Ctrl-C, after which the
    same call goes on in the same folder. Warns with ProblemWarning.
    """
    if folder is not None:
        return _run(problem, folder, jobs, time_limit)
    passing = tempfile.mkdtemp(prefix="mechwright-study-")
    try:
        made = _run(problem, passing, jobs, time_limit)
    except BaseException:
        shutil.rmtree(passing, True)
        raise
    weakref.finalize(made, shutil.rmtree, passing, True)
    return made


def _run(problem: Source, folder: Path, jobs: Optional[int], time_limit: Optional[float]) -> Study:
    tolerances = _program.study(given(problem), os.fsencode(folder), jobs, time_limit)
    made = Study(folder)
    made._tolerances = tolerances
    return made


def _columns(rows: List[Dict[str, Any]]) -> Dict[str, Any]:
    names = list(dict.fromkeys(name for row in rows for name in row))
    return {name: _column([row.get(name) for row in rows]) for name in names}


def _column(values: List[Any]) -> Union[List[Any], np.ndarray]:
    if all(value is None or isinstance(value, (int, float)) for value in values):
        return np.array([np.nan if value is None else value for value in values], dtype=float)
    return values

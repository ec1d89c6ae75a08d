"""Synthesis of planar mechanisms: linkages, quick-return drives and cams.

Problems are `Problem`s, dicts with the structure of a problem file, or paths of such files. Angles are degrees unless the
problem's [units] say radians; lengths are never converted. Lists of numbers in results are NumPy arrays.
"""

from ._program import ProblemError, ProblemWarning, __version__
from .calls import analyse, check, compare, explain, quantities, solve, verify
from .comparison import Comparison
from .problem import Problem
from .record import Record
from .result import Result
from .showing import draw, export, report
from .studies import Study, study
from .texts import Page, Picture, Text

__all__ = [
    "Comparison",
    "Page",
    "Picture",
    "Problem",
    "ProblemError",
    "ProblemWarning",
    "Record",
    "Result",
    "Study",
    "Text",
    "analyse",
    "check",
    "compare",
    "draw",
    "explain",
    "export",
    "quantities",
    "report",
    "solve",
    "study",
    "verify",
]

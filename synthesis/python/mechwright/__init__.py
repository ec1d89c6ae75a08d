"""Synthesis of planar mechanisms: linkages, quick-return drives and cams.

Problems are `Problem`s, dicts with the structure of a problem file, or paths of such files. Angles are degrees unless the
problem's [units] say radians; lengths are never converted. Lists of numbers in results are NumPy arrays.
"""

from ._program import ProblemError, ProblemWarning, __version__
from .calls import analyse, quantities, solve, verify
from .problem import Problem
from .record import Record
from .result import Result

__all__ = ["Problem", "ProblemError", "ProblemWarning", "Record", "Result", "analyse", "quantities", "solve", "verify"]

from os import PathLike
from typing import Any, Dict, List, Optional, Union

from numpy.typing import ArrayLike

__version__: str

Document = Dict[str, Any]
Source = Union[Document, str, "PathLike[str]"]

class ProblemError(ValueError):
    messages: List[Dict[str, Any]]

class ProblemWarning(UserWarning): ...

def solve(
    problem: Source,
    *,
    method: Optional[str] = None,
    seed: Optional[int] = None,
    jobs: Optional[int] = None,
    time_limit: Optional[float] = None,
    all: bool = False,
) -> Document: ...
def analyse(problem: Source, *, crank_angles: Optional[ArrayLike] = None, steps: int = 360) -> Document: ...
def verify(result: Source) -> Document: ...
def quantities(mechanism: str) -> Dict[str, Dict[str, str]]: ...

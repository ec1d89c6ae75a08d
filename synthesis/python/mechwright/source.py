"""What functions take: problems and results, as values or as paths."""

from __future__ import annotations

import os
from typing import Any, Dict, Union

Path = Union[str, "os.PathLike[str]"]
Source = Union[Dict[str, Any], Path]


def given(source: Source) -> Any:
    """What the program is given: a Problem as what it was read from, all else as it is."""
    from .problem import Problem

    return source._given() if isinstance(source, Problem) else source


def write(path: Path, content: Union[str, bytes]) -> None:
    """Writes a file, texts as UTF-8."""
    with open(path, "wb") as file:
        file.write(content.encode() if isinstance(content, str) else content)


def ending(path: Path) -> str:
    """What a file's name ends in, without the dot: 'svg'."""
    return os.path.splitext(os.fspath(path))[1].removeprefix(".").lower()

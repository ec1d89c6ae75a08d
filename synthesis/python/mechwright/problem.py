"""Problems as values."""

from __future__ import annotations

import os
import tomllib
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Tuple, Union

from . import _program
from .record import Record

if TYPE_CHECKING:
    from .result import Result


class Problem(Record):
    """What a mechanism is to do: a dict with the structure of a problem file, whose sections are attributes, None where
    the problem says nothing of them.

    `Problem(dict)` copies a dict (arrays become lists), `Problem(path)` reads a file, `Problem.from_toml(text)` a text,
    and keywords give sections, or others in the place of those: `Problem(mechanism="four-bar", dimensions={...})`.
    `schema = 1` goes without saying. Lengths are in one unit of the caller's choice; angles in degrees unless `units`
    says radians.

    Raises TypeError and ValueError, with the key, for a value that no file can hold; for a file or a text also
    ProblemError, with the line, and OSError. What else is wrong is said by `check` and `solve`.
    """

    _read: Optional[Tuple[str, str, Dict[str, Any]]] = None  # text, name and content of the file that it was read from

    def __init__(self, source: Union[None, Dict[str, Any], str, os.PathLike[str]] = None, /, **parts: Any) -> None:
        if source is not None and not isinstance(source, dict):
            _program.read(source)
            with open(source, "rb") as file:
                self._read = _read(file.read().decode(), os.fspath(source))
            source = self._read[2]
        elif isinstance(source, Problem):
            self._read = source._read
        named = {name.replace("_", "-"): part for name, part in parts.items()}
        super().__init__(_program.plain({"schema": 1, **(source or {}), **named}, False))

    @classmethod
    def from_toml(cls, text: str, name: str = "<text>") -> Problem:
        """The problem of a TOML text; `name` is what messages call it, and files that it names are relative to that."""
        _program.read((text, name))
        read = _read(text, name)
        problem = cls(read[2])
        problem._read = read
        return problem

    def to_toml(self) -> str:
        """The text of a problem file: the one that it was read from where nothing has changed since."""
        return self._read[0] if self._unchanged() else _program.problem_text(self)

    def save(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes a problem file. Raises OSError where it cannot."""
        with open(path, "wb") as file:
            file.write(self.to_toml().encode())

    def check(self) -> None:
        """Raises ProblemError with all that is wrong; warns of what is odd."""
        _program.check(self._given())

    def solve(self, **options: Any) -> Result:
        """`mechwright.solve` of this problem, with its options."""
        from .calls import solve

        return solve(self, **options)

    def _unchanged(self) -> bool:
        return self._read is not None and dict.__eq__(self, self._read[2])

    def _given(self) -> Any:
        """What the program is given: the text that was read, whose lines messages can name, or else the values."""
        if self._read is None:
            return self
        text, name, _ = self._read
        return (text, name) if self._unchanged() else (self, os.path.join(os.path.dirname(name), "<dict>"))

    def _keys(self) -> List[str]:
        return list(dict.fromkeys([*self, *_program.problem_keys()]))

    def __repr__(self) -> str:
        return f"Problem({super().__repr__()})"


def _read(text: str, name: str) -> Tuple[str, str, Dict[str, Any]]:
    return text, name, tomllib.loads(text.removeprefix("\ufeff"))

"""Results as values."""

from __future__ import annotations

import os
from typing import Any, Dict, Iterable, List, Optional, Tuple, Union

from . import _program
from .record import Record
from .tables import table
from .texts import Page, Picture

_MEMBERS = _program.result_members()
_SIDE_BY_SIDE = "display:flex;flex-wrap:wrap;align-items:flex-start;gap:1em"


class Result(Record):
    """What was found: the result document as a dict, whose members are attributes: None where the document does not have
    them, and an empty list where they are lists. `design` has the dimensions by their names, `quantities` the
    quantities. In notebooks it is tables beside the mechanism as it moves.
    """

    status: str
    note: Optional[str]
    design: Optional[Record]
    objective: Optional[Record]
    quantities: Optional[Record]
    requirements: List[Record]
    warnings: List[Record]
    verification: Optional[Record]
    alternatives: List[Record]
    front: Any
    search: Optional[Record]

    @classmethod
    def load(cls, path: Union[str, os.PathLike[str]]) -> Result:
        """A result from a file. Raises ValueError for what is not a result document, OSError where it cannot be read."""
        return cls(_program.read_result(path))

    def save(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes the document, as `mechwright solve --json` prints it. Raises OSError where it cannot."""
        with open(path, "wb") as file:
            file.write(_program.result_text(self).encode())

    def verify(self) -> Record:
        """`mechwright.verify` of this result: {'passed': bool, 'checks': [...]}."""
        return Record(_program.verify(self))

    def draw(self, out: Union[None, str, os.PathLike[str]] = None, **options: Any) -> Picture:
        """`mechwright.draw` of this result, with its options."""
        from .showing import draw

        return draw(self, out, **options)

    def export(self, out: Union[None, str, os.PathLike[str]] = None, **options: Any) -> str:
        """`mechwright.export` of this result, with its options."""
        from .showing import export

        return export(self, out, **options)

    def report(self, out: Union[None, str, os.PathLike[str]] = None) -> Page:
        """`mechwright.report` on this result."""
        from .showing import report

        return report(self, out)

    def svg(self) -> str:
        """A picture of the design, with its curves. Raises ValueError where there is no design that can be shown."""
        return str(self.draw())

    def items(self) -> Any:
        """Pairs of what JSON can hold, lists for arrays, so that `json.dumps(result)` works, which asks for them."""
        return self.document.items()

    def __reduce__(self) -> Tuple[type, Tuple[Dict[str, Any]]]:
        return type(self), (dict(self),)  # copies keep arrays

    def _keys(self) -> List[str]:
        return list(dict.fromkeys([*self, *_MEMBERS]))

    def __getattr__(self, name: str) -> Any:
        value = super().__getattr__(name)
        return [] if value is None and _MEMBERS.get(name) else value

    def __repr__(self) -> str:
        return f"<Result: {', '.join(f'{name} {value}' for name, value in self._summary())}>"

    def _repr_svg_(self) -> Optional[str]:
        try:
            return self.svg()
        except ValueError:
            return None

    def _repr_html_(self) -> str:
        title = (self.problem or {}).get("title") or "Result"
        tables = [table(title, self._summary()), table("Quantities", (self.quantities or {}).items())]
        if self.requirements:
            tables.insert(1, table("Requirements", map(_requirement, self.requirements)))
        return f'<div style="{_SIDE_BY_SIDE}"><div>{"".join(tables)}</div>{self._moving()}</div>'

    def _moving(self) -> str:
        try:
            return str(self.draw(animate=True))
        except ValueError:  # there is no design that can be shown
            return ""

    def _summary(self) -> Iterable[Tuple[str, Any]]:
        yield "status", self.status
        if self.note:
            yield "note", self.note
        if self.objective and "value" in self.objective:
            yield self.objective.get("quantity", "objective"), self.objective["value"]
        yield from (self.design or {}).items()


def _requirement(one: Dict[str, Any]) -> Tuple[str, Any]:
    limits = ", ".join(f"{word} {one[word]:.9g}" for word in ("equal", "min", "max") if word in one)
    return f"{one.get('quantity')} ({limits})", one.get("value")

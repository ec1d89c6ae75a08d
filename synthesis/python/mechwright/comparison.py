"""Designs for one task, side by side."""

from __future__ import annotations

from typing import Any, Dict, List

from .record import Record, plain_of
from .result import Result
from .tables import table
from .texts import Text


class Comparison(list):
    """Records, one for each design, the best first: `file`, `mechanism`, `status`, `objective`, quantities as far as the
    mechanism has them, and its `result`, a Result. `table` and `csv` are the same as texts, `differences` says what the
    problems ask for differently. Shown by itself, and in notebooks, it is a table.
    """

    def __init__(self, made: Dict[str, Any]) -> None:
        super().__init__(Record({**row, "result": Result(row["result"])}) for row in made["rows"])
        self.table = Text(made["table"])
        self.csv = Text(made["csv"])
        self.differences = Text(made["differences"])

    @property
    def document(self) -> List[Dict[str, Any]]:
        """The rows as dicts, lists, numbers and strings: what JSON can hold."""
        return [plain_of(row) for row in self]

    def __repr__(self) -> str:
        return str(self.table)

    def _repr_html_(self) -> str:
        names = list(dict.fromkeys(name for row in self for name in row if name != "result"))
        return table("Comparison", [names, *([row.get(name, "") for name in names] for row in self)])

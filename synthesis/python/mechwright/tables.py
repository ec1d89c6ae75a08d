"""Tables for notebooks."""

from __future__ import annotations

from html import escape
from typing import Any, Iterable, Sequence


def _cell(value: Any) -> str:
    return f"<td>{escape(f'{value:.9g}' if isinstance(value, float) else str(value))}</td>"


def table(title: str, rows: Iterable[Sequence[Any]]) -> str:
    """An HTML table under a title."""
    lines = "".join(f"<tr>{''.join(map(_cell, row))}</tr>" for row in rows)
    return f"<table><caption>{escape(title)}</caption>{lines}</table>"

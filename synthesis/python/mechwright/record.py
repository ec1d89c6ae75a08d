"""Dicts whose members are attributes as well."""

from __future__ import annotations

import json
from difflib import get_close_matches
from typing import Any, Dict, List, Optional

from . import _program


def recorded(value: Any) -> Any:
    """The same with a Record for every dict, in lists too."""
    if isinstance(value, dict) and not isinstance(value, Record):
        return Record(value)
    if isinstance(value, list):
        return [recorded(one) for one in value]
    return value


def plain_of(members: Dict[str, Any]) -> Dict[str, Any]:
    """A copy of dicts, lists, numbers and strings, with None for NaN: what JSON can hold."""
    return _program.plain(members, True)


class Record(dict):
    """A dict whose members are attributes as well: `design.crank` is `design["crank"]`, and `design.point_along` is
    `design["point-along"]`. Assignment sets or adds a member. Names that dicts have already ("items") are keys alone.
    Records are equal if all they hold is, arrays by their numbers; NaN is equal to None.
    """

    def __init__(self, *members: Any, **named: Any) -> None:
        super().__init__((name, recorded(value)) for name, value in dict(*members, **named).items())

    def to_dict(self) -> Dict[str, Any]:
        """A copy of dicts, lists, numbers and strings, with None for NaN: what JSON can hold."""
        return plain_of(self)

    @property
    def document(self) -> Dict[str, Any]:
        """`to_dict()`, for `json.dumps(result.document)`."""
        return plain_of(self)

    def to_json(self, *, indent: Optional[int] = None) -> str:
        """The JSON text of it; arrays are lists, NaN is null."""
        return json.dumps(self.document, indent=indent, ensure_ascii=False, allow_nan=False)

    def _key(self, name: str) -> Optional[str]:
        """The known key that an attribute stands for."""
        return next((key for key in (name, name.replace("_", "-")) if key in self._keys()), None)

    def _unknown(self, name: str) -> AttributeError:
        known = self._keys()
        close = get_close_matches(name.replace("_", "-"), known, 1)
        remedy = f"did you mean '{close[0]}'?" if close else "known are " + ", ".join(known)
        return AttributeError(f"'{name}' is not known here; {remedy}")

    def _keys(self) -> List[str]:
        return list(self)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        key = self._key(name)
        if key is None:
            raise self._unknown(name)
        if isinstance(self.get(key), (dict, list)):
            self[key] = recorded(self[key])
        return self.get(key)

    def __setattr__(self, name: str, value: Any) -> None:
        if name.startswith("_"):
            super().__setattr__(name, value)
        else:
            self[self._key(name) or name] = recorded(value)

    def __dir__(self) -> List[str]:
        names = (key.replace("-", "_") for key in self._keys())
        return [*super().__dir__(), *filter(str.isidentifier, names)]

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, dict):
            return NotImplemented
        try:
            return _program.plain(self, True) == _program.plain(other, True)
        except (TypeError, ValueError):  # what neither a problem nor a result can hold
            return False

    def __ne__(self, other: object) -> bool:
        return not self == other

    __hash__ = None  # type: ignore[assignment]

"""Texts that show themselves: pictures, pages and tables."""

from __future__ import annotations

from html import escape


class Text(str):
    """A str for people, with its lines where it is shown by itself."""

    def __repr__(self) -> str:
        return str(self)


class Picture(str):
    """An SVG picture as a str; notebooks show it, moving if it does."""

    def _repr_html_(self) -> str:
        return str(self)

    def __repr__(self) -> str:
        return f"<Picture: {len(self)} characters of SVG>"


class Page(str):
    """A page of HTML as a str; notebooks show it in a frame."""

    def _repr_html_(self) -> str:
        return f'<iframe srcdoc="{escape(self)}" width="100%" height="720" style="border:0"></iframe>'

    def __repr__(self) -> str:
        return f"<Page: {len(self)} characters of HTML>"

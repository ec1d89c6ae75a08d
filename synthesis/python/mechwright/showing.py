"""Designs drawn, handed to other programs, and put on pages."""

from __future__ import annotations

import glob
import os
from collections.abc import Iterable
from typing import Any, List, Optional, Union

from . import _program
from .source import Path, Source, ending, given, write
from .studies import Study, is_study
from .texts import Page, Picture


def draw(
    source: Source,
    out: Optional[Path] = None,
    *,
    animate: bool = False,
    seconds: float = 4,
    plots: bool = False,
    alternative: Optional[int] = None,
    figure: bool = False,
    assemblies: bool = False,
    skeleton: bool = False,
    at: Optional[float] = None,
    width: Optional[int] = None,
) -> Picture:
    """Draws a design with its curves, or what a problem describes before it is a design.

    source       a result (Result, dict or the path of a .json file), or a problem that leaves no dimension open (Problem,
                 dict or path); of a figure a problem, or the name of a mechanism ('four-bar'); of assemblies and a
                 skeleton a problem with links and joints of its own
    out          a file to write as well: .svg, .png, .pdf, or .gif with animate
    animate      moving for ever, one round in so many seconds
    plots        the curves of the motion below a picture that stands still (with gnuplot)
    alternative  of a result: this one of its alternatives, from 1 on
    figure       where each dimension of a mechanism is
    assemblies   all sides on which a linkage closes at an input, with what [assembly] says of them
    skeleton     the links of a linkage apart, even where it does not close; what is wrong with it is warned of
    at           of assemblies: the crank angle or displacement, in the problem's unit
    width        pixels, 100 to 10000; 640, of figures 860

    Returns the SVG, a str that notebooks show.

    Raises ProblemError and ValueError for what has no design that can be shown, ValueError for options out of range,
    OSError for a file that cannot be written or a program (rsvg-convert, gnuplot) that is missing.
    """
    sheets = [name for name, wanted in (("figure", figure), ("assemblies", assemblies), ("skeleton", skeleton)) if wanted]
    if len(sheets) > 1 or sheets and (animate or plots or alternative is not None):
        raise ValueError(f"{sheets[0]}: leave the other kinds of drawings and alternative out")
    if at is not None and not assemblies:
        raise ValueError("at: it is for assemblies")

    def drawn(format: str) -> bytes:
        if sheets:
            sheet = getattr(_program, "draw_" + sheets[0])
            return sheet(given(source), format, at, width or (860 if figure else 640))
        return _program.draw(
            given(source), format, seconds if animate else None, plots, _alternative(alternative), width or 640
        )

    content = b"" if out is None else drawn(ending(out))
    picture = Picture(drawn("svg").decode())
    if out is not None:
        write(out, content)
    return picture


def export(
    source: Source,
    out: Optional[Path] = None,
    *,
    format: Optional[str] = None,
    at: Optional[float] = None,
    fineness: Optional[float] = None,
    alternative: Optional[int] = None,
    steps: int = 360,
) -> str:
    """Hands a design to CAD, spreadsheets or scripts.

    source       a result or a problem that leaves no dimension open, as for draw
    out          a file to write as well; its ending says the format, unless that is given
    format       'dxf', 'slvs' (SolveSpace), 'csv' (the motion as a table) or 'json' (bodies and motion)
    at           of a drawing: the crank angle or displacement, in the problem's unit; by default the start of the motion
    fineness     of a drawing: how far curves may be off, as a part of its size; by default 1e-6, for 'slvs' 1e-3
    alternative  of a result: this one of its alternatives, from 1 on
    steps        of 'csv' and 'json': over the motion, 1 to 1000000

    Returns the text, in which lengths are in the problem's unit. That for SolveSpace has bytes that are no text, as
    surrogate escapes.

    Raises ValueError for a format that is not known and an angle at which the mechanism does not assemble; else as draw.
    """
    if format is None and out is None:
        raise ValueError("format or out must say what to export to: 'dxf', 'slvs', 'csv' or 'json'")
    name = ending(out) if format is None and out is not None else format
    content: bytes = _program.export_design(given(source), name, at, fineness, _alternative(alternative), steps)
    if out is not None:
        write(out, content)
    return content.decode(errors="surrogateescape")  # SolveSpace's first line is not UTF-8


def report(results: Union[Source, Study, Iterable[Source]], out: Optional[Path] = None, *, designs: int = 400) -> Page:
    """Makes one page on results, or on a study, for a browser; it needs no network.

    results  a result (Result, dict, or the path of a .json file), several of them, the path of a folder of results, a
             Study or the path of its folder
    out      a file to write as well
    designs  of a study: so many at most are in the page, 1 to 100000

    Returns the HTML, a str that notebooks show.

    Raises ValueError for what is not a result, OSError for what cannot be read or written. Warns with RuntimeWarning if
    plots are missing for browsers without scripts, because there is no gnuplot.
    """
    folder = results.folder if isinstance(results, Study) else results
    if isinstance(folder, (str, os.PathLike)) and is_study(folder):
        page = Page(_program.report_study(os.fsencode(folder), designs))
    else:
        page = Page(_program.report_results(_results(results)))
    if out is not None:
        write(out, page)
    return page


def _results(results: Any) -> List[Any]:
    if isinstance(results, (str, os.PathLike)) and os.path.isdir(results):
        return sorted(glob.glob(os.path.join(glob.escape(os.fspath(results)), "*.json")))
    several = isinstance(results, Iterable) and not isinstance(results, (dict, str, os.PathLike))
    return list(results) if several else [results]


def _alternative(number: Optional[int]) -> int:
    if number is not None and number < 1:
        raise ValueError(f"alternative: {number} is not from 1 on")
    return number or 0

#!/usr/bin/env python3
"""Checks that no room of the house includes one above it: rooms stand in the order of the list below, and a file may
include its own room and those before it. Tests may include everything. What belongs to one kind of target or mechanism
stands in a folder of its own, `synthesis/target/KIND` or `synthesis/mechanism/KIND`; what a file of it is for, by the
beginning of its name or its folder, says in which room it is.

    tests/rooms.py    names each #include that climbs, and fails if any does
"""
import pathlib
import re
import sys

ROOMS = [
    # Formulas alone.
    "analysis/geometry", "analysis/numbers", "analysis/four_bar", "analysis/slider_crank", "analysis/quick_return",
    "analysis/cam",
    # Linkages: what they are made of, placed, groups without a closed form, moved, measured.
    "analysis/linkage/structure", "analysis/linkage/placing", "analysis/linkage/groups", "analysis/linkage/motion",
    "analysis/linkage/measuring",
    # What a mechanism is, what is asked of it, and that as a nonlinear program.
    "synthesis/mechanism", "synthesis/problem", "synthesis/program",
    # Methods.
    "synthesis/local", "synthesis/search", "synthesis/proof", "synthesis/exact",
    # Results: written and read, checked, and how they come about.
    "synthesis/document", "synthesis/verify", "synthesis/solve",
    # What people and programs are given, and who asks.
    "synthesis/report", "synthesis/study", "synthesis/python", "synthesis/command_line", "synthesis/bench",
]  # fmt: skip

# The others are formulas, and the numbers and quantities that a target brings to a mechanism.
BY_NAME = {
    "read": "synthesis/problem", "rows": "synthesis/program", "fit": "synthesis/search", "document": "synthesis/document",
    "verify": "synthesis/verify", "text": "synthesis/report", "draw": "synthesis/report",
}  # fmt: skip

source = pathlib.Path(__file__).resolve().parent.parent


def room_of(path):
    """The room of a file or of what an #include names; a header beside the rooms of `analysis` is the front of one."""
    parts = pathlib.PurePosixPath(path).parts
    if parts[:2] in (("synthesis", "target"), ("synthesis", "mechanism")):
        is_for = re.match("[a-z]*", parts[3])[0] if len(parts) > 3 else ""
        return BY_NAME.get(is_for, "synthesis/mechanism")
    depth = 3 if parts[:2] == ("analysis", "linkage") else 2
    return "/".join(parts[:depth]).removesuffix(".h") if parts[0] in ("analysis", "synthesis") else None


def faults_of(path):
    room = room_of(path)
    if room not in ROOMS:
        yield f"{path}:1: '{room}' is no room of tests/rooms.py"
        return
    for number, line in enumerate((source / path).read_text(encoding="utf-8").splitlines(), 1):
        include = re.match(r'\s*#\s*include\s*"([^"]+)"', line)
        if not include:
            continue
        other = room_of(include[1])
        if other is None:  # made by the build, or beside the file
            if not include[1].endswith(".inc"):
                yield f"{path}:{number}: \"{include[1]}\" is not named by its path from the top of the source tree"
        elif other not in ROOMS:
            yield f"{path}:{number}: '{other}' is no room of tests/rooms.py"
        elif ROOMS.index(other) > ROOMS.index(room):
            yield f"{path}:{number}: {room} includes {other}, which stands above it: \"{include[1]}\""


files = [f.relative_to(source).as_posix() for top in ("analysis", "synthesis") for f in sorted((source / top).rglob("*.*"))
         if f.suffix in (".h", ".cpp")]  # fmt: skip
faults = [fault for path in files for fault in faults_of(path)]
print(*faults, sep="\n", file=sys.stderr, end="\n" if faults else "")
sys.exit(1 if faults or not files else 0)

#!/usr/bin/env python3
"""Checks that each kind of mechanism is known by name to its own places alone, so that a new one needs no others: its
folders in `analysis` and `synthesis/mechanism`, the list of all kinds, and what is known of that kind in closed form,
with the checks of such proofs.

    tests/kinds.py    names each line elsewhere that knows a kind, and fails if any does
"""
import pathlib
import re
import sys

KINDS = ["four_bar", "slider_crank", "crank_shaper", "whitworth", "drag_link", "cam"]
THE_LIST = "synthesis/mechanism/mechanism.cpp"
# Of kinds of which files and documents say more than dimensions: who reads and writes that, and the names of sections.
LISTS_OF_SECTIONS = [
    "synthesis/problem/sections/kinds_with_sections.cpp", "synthesis/document/kinds_in_documents.cpp",
    "synthesis/problem/schema/keys.h", "synthesis/document/fields.h",
]  # fmt: skip
WITH_SECTIONS = {"cam"}
OWN = [
    # Formulas.
    "analysis/",
    # Every solution, the best one or a limit in closed form, and the checks of these proofs.
    "synthesis/exact/", "synthesis/proof/", "synthesis/verify/proofs/",
    # What is measured against a stated baseline.
    "synthesis/bench/",
]  # fmt: skip

# What mechanisms are made of: every one that drives a ram ends in a slider-crank, and a four-bar may turn its arm; they
# share its crank angles.
MADE_OF_PARTS = ["quick_return", "slider_crank", "crank_shaper", "whitworth", "drag_link"]
PARTS = {
    "slider_crank": [f"synthesis/mechanism/{folder}/" for folder in MADE_OF_PARTS],
    # A point of a linkage is guided as the coupler point of a four-bar among its links is.
    "four_bar": [f"synthesis/mechanism/{folder}/" for folder in MADE_OF_PARTS] +
                ["synthesis/mechanism/linkage/targets/guiding_part.cpp"],
    # The drives of a linkage can move as the follower of a cam does; a cam is a part that is drawn; cam-size is a quantity.
    "cam": ["synthesis/problem/linkage/", "synthesis/problem/schema/linkage", "synthesis/report/structure/",
            "synthesis/mechanism/drawing/body.h", "synthesis/report/drawing/",
            "synthesis/mechanism/possible_values.cpp", "synthesis/report/text/comparison.cpp"],
}


def is_own(file, kind):
    """Whether a file is one of those that may know a kind."""
    sections = LISTS_OF_SECTIONS if kind in WITH_SECTIONS else []
    return file.startswith(tuple(OWN + PARTS.get(kind, []) + sections + [f"synthesis/mechanism/{kind}/"]))


source = pathlib.Path(__file__).resolve().parent.parent


def code_of(line):
    """A line without its comment, and without sentences: words of a kind in texts for people are no knowledge of it."""
    line = re.sub(r"//.*", "", line)
    return re.sub(r'"(?:[^"\\]|\\.)*"', lambda text: '""' if " " in text[0] else text[0], line)


faults, listed = [], {kind: 0 for kind in KINDS}
for path in sorted(p for top in ("analysis", "synthesis") for p in (source / top).rglob("*.*") if p.suffix in (".h", ".cpp")):
    file = path.relative_to(source).as_posix()
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        for kind in KINDS:
            if is_own(file, kind):
                continue
            if not re.search(rf"(?<![a-z]){kind.replace('_', '[-_]')}(?![a-z])", code_of(line)):
                continue
            if file != THE_LIST:
                faults.append(f"{file}:{number}: knows the kind '{kind}': {line.strip()}")
            elif not line.startswith("#include"):
                listed[kind] += 1
faults += [f"{THE_LIST}: lists the kind '{kind}' {count} times" for kind, count in listed.items() if count != 1]
print(*faults, sep="\n", file=sys.stderr, end="\n" if faults else "")
sys.exit(1 if faults else 0)

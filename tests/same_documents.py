#!/usr/bin/env python3
"""Compares the documents of two builds of the program, for changes that must not change any answer.

    tests/same_documents.py OLD NEW [FILE...]    solves and analyses the files (every shipped problem unless given)

Times, the program's versions and the place of the file are passed over. Every other difference is named by its place
in the document; the number of them is the exit code, 100 at most.
"""
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys

source = pathlib.Path(__file__).resolve().parent.parent
passed_over = {"seconds", "program", "file"}


def differences(old, new, place=""):
    if isinstance(old, dict) and isinstance(new, dict):
        for key in list(old) + [key for key in new if key not in old]:
            if key in passed_over:
                continue
            if key not in old or key not in new:
                yield f"{place}.{key}: only in the {'old' if key in old else 'new'} document"
            else:
                yield from differences(old[key], new[key], f"{place}.{key}")
    elif isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
        for i, (a, b) in enumerate(zip(old, new)):
            yield from differences(a, b, f"{place}[{i}]")
    elif old != new:
        yield f"{place}: {json.dumps(old)[:60]} -> {json.dumps(new)[:60]}"


def answer(program, command, file):
    done = subprocess.run([program, command, "--json", "--quiet", file] if command == "solve"
                          else [program, command, "--json", file],
                          capture_output=True, text=True, cwd=source)  # fmt: skip
    try:
        return done.returncode, json.loads(done.stdout)
    except json.JSONDecodeError:
        return done.returncode, (done.stdout + done.stderr).splitlines()[:3]


def compared(old, new, file):
    found = []
    for command in ("solve", "analyse"):
        a, b = answer(old, command, file), answer(new, command, file)
        if a[0] != b[0]:
            found.append(f"{command}: exit code {a[0]} -> {b[0]}")
        found += [f"{command}{difference}" for difference in differences(a[1], b[1])]
    return file, found


if len(sys.argv) < 3:
    sys.exit(__doc__)
old, new = (os.path.abspath(program) for program in sys.argv[1:3])
files = sys.argv[3:] or sorted(f.relative_to(source).as_posix() for f in (source / "problems").rglob("*.toml")
                               if f.parent.name != "linkage")
count = 0
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    for file, found in pool.map(lambda file: compared(old, new, file), files):
        count += len(found)
        print(f"{file}: {'the same' if not found else len(found)}", *found[:12], sep="\n  ", flush=True)
print(f"{len(files)} files, {count} differences")
sys.exit(min(count, 100))

"""Line and branch coverage by folder, and what is not covered with the reason why, from gcovr's JSON.

    coverage_table.py COVERAGE.json REASONS.txt COMMIT LastTestsFailed.log REPORT.md

Exit code 1 where a function is never called and no reason is given."""

import collections
import fnmatch
import json
import pathlib
import re
import sys


def reasons_of(text):
    """(file pattern, function pattern or None, reason) for each line."""
    reasons = []
    for line in text.splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        what, _, reason = line.partition(" = ")
        file, _, function = what.strip().partition(":")
        reasons.append((file, function or None, reason.strip()))
    return reasons


def reason_for(reasons, file, function=None):
    for file_pattern, function_pattern, reason in reasons:
        if (function is None) != (function_pattern is None) or not fnmatch.fnmatch(file, file_pattern):
            continue
        if function is None or fnmatch.fnmatchcase(function, function_pattern):
            return reason
    return None


def folder_of(file):
    parts = pathlib.PurePath(file).parts
    return "/".join(parts[:2]) if parts[0] == "synthesis" else parts[0]


def code_lines(file):
    return [line for line in file["lines"] if not line["gcovr/noncode"] and not line["gcovr/excluded"]]


def count(files):
    """(lines run, lines, branches taken, branches)."""
    lines = [line for file in files for line in code_lines(file)]
    branches = [branch for line in lines for branch in line["branches"]]
    return (sum(line["count"] > 0 for line in lines), len(lines),
            sum(branch["count"] > 0 for branch in branches), len(branches))


def percent(part, whole):
    return f"{100 * part / whole:.1f} %" if whole else "-"


def table(files):
    by_folder = collections.defaultdict(list)
    for file in files:
        by_folder[folder_of(file["file"])].append(file)
    rows = sorted(by_folder.items()) + [("total", files)]
    text = ["| folder | lines | run | branches | taken |", "| --- | ---: | ---: | ---: | ---: |"]
    for name, of_folder in rows:
        run, lines, taken, branches = count(of_folder)
        text.append(f"| {name} | {lines} | {percent(run, lines)} | {branches} | {percent(taken, branches)} |")
    return text


def indentation(text):
    return len(text) - len(text.lstrip())


def is_run(source, counts, line, is_lambda):
    """Whether the lines of a function are run, though its own count is 0: wherever it is called, it is compiled as a part
    of its caller. `counts`: of the lines with code, by their numbers."""
    first = source[line - 1]
    if "{" in first and first.count("{") <= first.count("}"):
        # The line of a lambda is also one of the function around it.
        before = max((number for number in counts if number < line), default=None)
        return counts.get(line, 0) > (counts[before] if is_lambda and before else 0)
    for number in range(line + 1, len(source) + 1):
        text = source[number - 1]
        if text.strip() and indentation(text) <= indentation(first):
            return False
        if counts.get(number, 0) > 0:
            return True
    return False


def uncalled(file):
    """Functions, by the place where they stand, none of whose instances is called."""
    source = pathlib.Path(file["file"]).read_text().splitlines()
    counts = {line["line_number"]: line["count"] for line in code_lines(file)}
    by_line = collections.defaultdict(list)
    for function in file["functions"]:
        by_line[function["lineno"]].append(function)
    for line, instances in sorted(by_line.items()):
        name = min((function["name"] for function in instances), key=len)
        if all(function["execution_count"] == 0 for function in instances) and \
                not is_run(source, counts, line, "{lambda" in name):
            yield line, name


def by_reason(entries):
    """Lists under their reasons. `entries`: (reason, line of the list)."""
    groups = collections.defaultdict(list)
    for reason, entry in entries:
        groups[reason].append(entry)
    text = []
    for reason, of_group in sorted(groups.items()):
        text += [f"{reason}:", ""] + [f"* {entry}" for entry in of_group] + [""]
    return text


def short_name(name):
    """A function without its arguments, and without those of templates."""
    name = name.replace("(anonymous namespace)::", "").replace("mechwright::", "")
    while (bare := re.sub(r"<[^<>]*>|\([^()]*\)|\{lambda#\d+\}::", "", name)) != name:
        name = bare
    return name.split(" const")[0].split(" ")[-1]


def uncalled_functions(files, reasons):
    """(reason, entry): a line for each, or for each file that has more of them than can be read."""
    most_by_name = 5
    for file in files:
        by_reason_here = collections.defaultdict(list)
        for line, name in uncalled(file):
            by_reason_here[reason_for(reasons, file["file"], name)].append((line, short_name(name)))
        for reason, entries in by_reason_here.items():
            if reason and len(entries) > most_by_name:
                yield reason, f"`{file['file']}`: {len(entries)} functions"
            else:
                for line, name in entries:
                    yield reason, f"`{file['file']}:{line}` `{name}`"


def uncovered_lines(files, reasons):
    for file in files:
        missed = sum(line["count"] == 0 for line in code_lines(file))
        if missed:
            reason = reason_for(reasons, file["file"]) or "No reason written down"
            yield reason, f"`{file['file']}`: {missed} of {len(code_lines(file))}"


def failed_tests(log):
    """What ctest wrote of tests that failed: a number and a name in each line."""
    names = [line.partition(":")[2] for line in log.splitlines() if ":" in line]
    if not names:
        return ["All tests passed while lines were counted.", ""]
    return ["These tests failed while lines were counted, which takes time, memory and room on the disk; `./bootstrap test`",
            "judges them:", "", *(f"* `{name}`" for name in names), ""]


def main(coverage, reasons, commit, failed, report):
    files = [file for file in json.loads(pathlib.Path(coverage).read_text())["files"] if file["lines"]]
    reasons = reasons_of(pathlib.Path(reasons).read_text())
    functions = list(uncalled_functions(files, reasons))
    text = ["# What the tests run", "",
            f"Made by `tests/coverage.sh` of commit {commit}: the lines that all tests and `mechwright bench` together run,",
            "and the branches that they take, but for those that the compiler adds for exceptions.", "",
            *failed_tests(pathlib.Path(failed).read_text()), *table(files), "",
            "## Functions that no test calls", "",
            *by_reason((reason or "No reason written down", entry) for reason, entry in functions),
            "## Lines that no test runs", "", *by_reason(uncovered_lines(files, reasons))]
    pathlib.Path(report).write_text("\n".join(text).rstrip() + "\n")
    unexplained = [entry for reason, entry in functions if reason is None]
    for entry in unexplained:
        print(f"no test calls {entry}, and no reason is given", file=sys.stderr)
    return 1 if unexplained else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

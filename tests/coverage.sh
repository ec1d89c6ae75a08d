#!/bin/sh
# Runs all tests with a build that counts the lines they run, and writes results/coverage.md. Fails where a function is
# never called and tests/coverage_reasons.txt does not say why. Needs gcovr (Debian: gcovr).
set -eu
cd "$(dirname "$0")/.."
cmake --preset coverage >/dev/null
cmake --build --preset coverage
find build/coverage -name '*.gcda' -delete
# Tests with limits on time, memory and disk can fail here, where counting takes all three: the preset test judges them.
ctest --preset coverage -j "$(nproc)" || true
# Threads count without locks: a count that came out negative is left out.
gcovr --root . --filter analysis/ --filter synthesis/ --exclude-throw-branches --exclude-unreachable-branches \
    --gcov-ignore-parse-errors --json build/coverage/coverage.json build/coverage
python3 tests/coverage_table.py build/coverage/coverage.json tests/coverage_reasons.txt \
    "$(git rev-parse --short HEAD)" results/coverage.md

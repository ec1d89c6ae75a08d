#!/bin/sh
# Runs all tests with a build that counts the lines they run, and writes results/coverage.md. Fails where a function is
# never called and tests/coverage_reasons.txt does not say why. Needs gcovr (Debian: gcovr).
set -eu
cd "$(dirname "$0")/.."
cmake --preset coverage >/dev/null
cmake --build --preset coverage
find build/coverage -name '*.gcda' -delete
# Tests with limits on time, memory and disk can fail here, where counting takes all three: the preset test judges them,
# and the report names them.
failed=build/coverage/Testing/Temporary/LastTestsFailed.log
rm -f "$failed"
ctest --preset coverage -j "$(nproc)" || true
# Benchmarks take too long for a test.
build/coverage/mechwright bench --quiet --anew --out build/coverage/bench
# Threads count without locks: a count that came out negative is left out.
gcovr --root . --filter analysis/ --filter synthesis/ --exclude-throw-branches --exclude-unreachable-branches \
    --gcov-ignore-parse-errors --json build/coverage/coverage.json build/coverage
touch "$failed"
python3 tests/coverage_table.py build/coverage/coverage.json tests/coverage_reasons.txt \
    "$(git rev-parse --short HEAD)" "$failed" results/coverage.md

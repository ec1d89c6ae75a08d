#!/bin/sh
# Checks that every source is laid out as .clang-format says.
#
#   tests/style.sh        names what differs, and fails if anything does
#   tests/style.sh fix    rewrites the sources
set -eu
cd "$(dirname "$0")/.."

case ${1:-check} in
    check) mode="--dry-run --Werror" ;;
    fix) mode=-i ;;
    *) sed -n '2,5s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac

command -v clang-format >/dev/null || { echo "style.sh: clang-format 14 is needed (Debian: clang-format)" >&2; exit 1; }
# shellcheck disable=SC2086  # two options, or one
find analysis synthesis tests \( -name '*.h' -o -name '*.cpp' \) -print0 |
    xargs -0 -n 50 -P "$(nproc)" clang-format --style=file $mode

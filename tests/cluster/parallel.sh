#!/bin/bash
# Runs a planned study with GNU parallel, by the line that `study status` prints, and compares: chunks of any number, in any
# order, run twice, with a worker killed on the way, must come to the same bytes as a plain run.
#
#   tests/cluster/parallel.sh PROGRAM
set -euo pipefail
program=$(realpath "$1")
study=$(realpath "$(dirname "$0")/study.toml")
command -v parallel >/dev/null || { echo "there is no GNU parallel (Debian: parallel)"; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin"
ln -s "$program" "$work/bin/mechwright"
export PATH="$work/bin:$PATH" HOME="$work"

mechwright study "$study" --out "$work/whole" --quiet
mechwright study export "$work/whole" --csv > "$work/whole.csv"

for chunks in 1 7 12; do
    cut=$work/cut-$chunks
    mechwright study plan "$study" --out "$cut" --chunks $chunks --quiet
    if [ $chunks = 7 ]; then
        # A worker is killed in the middle of its chunk, and its chunk is run again with the others; one is run twice.
        mechwright study run "$cut" --chunk 3 --jobs 1 --quiet & worker=$!
        sleep 0.02
        kill -KILL $worker 2>/dev/null || true
        wait $worker 2>/dev/null || true
        mechwright study run "$cut" --chunk 5 --quiet
        mechwright study run "$cut" --chunk 5 --quiet
    fi
    line=$(mechwright study status "$cut" | grep -o 'parallel mechwright .*')
    [ $chunks = 12 ] && line=${line/parallel/parallel --shuf}
    echo "$line"
    bash -c "$line"
    mechwright study merge "$cut" --quiet
    mechwright study export "$cut" --csv | cmp - "$work/whole.csv"
    cmp "$cut/study.sqlite" "$work/cut-1/study.sqlite"
done
echo "the merged data are those of a plain run, for 1, 7 and 12 chunks"

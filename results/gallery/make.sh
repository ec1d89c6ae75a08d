#!/bin/sh
# Solves every problem that comes with mechwright, draws what came of it, and lists the pictures in README.md here; and
# draws where the dimensions of each mechanism are.
#
#   results/gallery/make.sh [PROGRAM]      PROGRAM: build/release/mechwright, unless another is named
set -eu
cd "$(dirname "$0")/../.."
program=${1:-build/release/mechwright}
gallery=results/gallery
solved=$(mktemp -d)
trap 'rm -rf "$solved"' EXIT

columns=4
{
    echo "# Gallery"
    echo
    echo "What \`mechwright draw\` makes of every problem in [problems](../../problems), by \`results/gallery/make.sh\`."
} >"$gallery/README.md"

for folder in problems/*/; do
    kind=$(basename "$folder")
    [ "$kind" = studies ] && continue
    rm -f "$gallery/$kind"-*.svg # what else is in the folder was not made here
    printf '\n## %s\n\n|%s\n|%s\n' "$kind" "$(printf ' |%.0s' $(seq $columns))" "$(printf ' --- |%.0s' $(seq $columns))" \
        >>"$gallery/README.md"
    column=0
    for problem in "$folder"*.toml; do
        name=$(basename "$problem" .toml)
        # A problem without a solution still has a design that misses least.
        "$program" solve "$problem" --out "$solved" --quiet >"$solved/log" || [ $? = 4 ]
        "$program" draw "$solved/$name.json" --width 320 --out "$gallery/$kind-$name.svg"
        printf '| [![%s](%s)](../../%s) ' "$name" "$kind-$name.svg" "$problem" >>"$gallery/README.md"
        column=$((column + 1))
        [ $((column % columns)) = 0 ] && echo '|' >>"$gallery/README.md"
    done
    [ $((column % columns)) = 0 ] || echo '|' >>"$gallery/README.md"
done

mkdir -p results/figures
for mechanism in four-bar slider-crank crank-shaper whitworth drag-link cam; do
    "$program" draw --figure "$mechanism" --out "results/figures/$mechanism.svg"
done

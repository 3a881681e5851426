#!/bin/sh
# Measures what docs/general-form.md shows, and draws its pictures: sh docs/general-form.sh HVI-GEN
# SPDX-License-Identifier: GPL-2.0-or-later
set -eu
cd "$(dirname "$0")/.."
hvi_gen=$(realpath "${1:-build/dev/generator/hvi-gen}")
data=$PWD/build/general-form
mkdir -p "$data"

# S functions, R nodes: the largest error of the energy, and evaluations of dH/dq in a step.
run() {
    functions=$1 nodes=$2
    shift 2
    "$hvi_gen" run "$@" --basis "monomials:$functions" --nodes "gauss:$nodes" --only summary \
            -o "$data/run" 2>"$data/errors" |
        awk -F '[ ,]+' '/^evaluations/ { count = $2 } /^energy/ { print $5, count }'
}

# A block for each rule.
for rule in "2 2" "2 4" "3 3" "3 6" "4 4" "4 8" "6 6"; do
    set -- $rule
    for n in 1 2 4 8 16; do
        echo "1/$n $(run "$1" "$2" examples/general_form/rough.toml --step "1/$n")"
    done | awk -v s="$1" -v r="$2" '{ split($1, h, "/"); print 1 / h[2], $2, $3, s, r }'
    printf '\n\n'
done >"$data/rough.dat"

for s in 2 4 6 8 10 12 14 16 18 20 22 24; do
    for r in $s $((3 * s / 2)); do
        echo "$s $r $(run $s $r pendulum --step 3 --until 600)"
    done
done >"$data/large_steps.dat"

gnuplot docs/general-form.gp

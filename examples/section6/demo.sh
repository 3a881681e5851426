#!/usr/bin/env bash
# The main job, as a user would do it: tableaux, headers, and the paper's experiments.
# SPDX-License-Identifier: MIT
#
# usage: demo.sh BUILD_DIRECTORY OUTPUT_DIRECTORY
set -euo pipefail

build=$1
output=$2
hvi_gen=$build/generator/hvi-gen

# The methods of Examples 4.4 (i)-(iii), 4.5, 4.6 and 4.7 (i)-(iii).
methods=(symplectic-euler midpoint adjoint-symplectic-euler stormer-verlet trig3
    chebyshev:1 chebyshev:2 chebyshev:3)

mkdir -p "$output"
for method in "${methods[@]}"; do
    header=$output/$(tr ':-' '__' <<<"$method").hpp
    printf '\n'
    "$hvi_gen" tableau --method "$method"
    "$hvi_gen" stepper --method "$method" -o "$header"
done

printf '\n'
"$build/examples/section6/section6" "$output"
gnuplot -c "$(dirname "${BASH_SOURCE[0]}")/figures.gp" "$output"

printf '\nHeaders of the methods above, and Figures 2 to 7 as CSV and SVG, are in\n  %s\n' "$output"

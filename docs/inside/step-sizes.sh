#!/bin/sh
# Measures what docs/inside/scenes.md says of step sizes, and draws its picture: sh docs/inside/step-sizes.sh HVI-GEN
# Prints for each scene and method how much dearer a unit of time becomes with a larger step: the
# time over the least of all smaller steps, at its worst, and the same of iterations.
# SPDX-License-Identifier: GPL-2.0-or-later
set -eu
cd "$(dirname "$0")/../.."
hvi_gen=$(realpath "${1:-build/dev/generator/hvi-gen}")
data=$PWD/build/step-sizes
mkdir -p "$data"

# SCENE, and 40 step sizes from FROM to TO.
measure() {
    scene=$1 from=$2 to=$3
    for stages in 2 4 8 12 16; do
        "$hvi_gen" stepper --method "gauss:$stages" "$scene" --name Measured -o "$data/measured.hpp"
        ${CXX:-c++} -std=c++17 -O3 -march=native -I src -I "$data" -DHEADER='<measured.hpp>' \
            -DSTEPPER=Measured docs/inside/step-sizes.cpp -o "$data/measured"
        "$data/measured" "$from" "$to" 40 >"$data/$(basename "$scene" .toml)-$stages.dat"
        awk -v name="$scene gauss:$stages" '
            NR == 1 || $2 < iterations { iterations = $2 }
            NR == 1 || $3 < time { time = $3 }
            { h = $1; if ($2 / iterations > rise) rise = $2 / iterations
              if ($3 / time > dearer) { dearer = $3 / time; at = h } }
            END { printf "%-28s to h = %-8s time %5.2f at h = %-8s iterations %5.2f\n", name, h, \
                         dearer, at, rise }' "$data/$(basename "$scene" .toml)-$stages.dat"
    done
}

measure pendulum 0.02 2
measure henon-heiles 0.02 2
measure kepler 0.01 1
measure outer-solar-system 20 2000
measure nonseparable 0.01 1
measure double-pendulum 0.01 1
measure point-vortices 0.05 9
measure fpu 0.005 1
measure tests/runtime/lanes/masses.toml 0.005 1
gnuplot docs/inside/step-sizes.gp

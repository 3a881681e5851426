#!/bin/sh
# Computes what docs/large-scenes.md shows, and draws its pictures: sh docs/large-scenes.sh HVI-GEN
# SPDX-License-Identifier: GPL-2.0-or-later
set -eu
cd "$(dirname "$0")/.."
hvi_gen=$(realpath "${1:-build/dev/generator/hvi-gen}")
data=$PWD/build/large-scenes
mkdir -p "$data"

"$hvi_gen" stepper --method stormer-verlet fpu-chain --name FpuChain --energy -o "$data/fpu_chain.hpp"
${CXX:-c++} -std=c++17 -O3 -march=native -I src -I "$data" examples/fpu_recurrence/main.cpp \
    -o "$data/fpu_recurrence" -pthread
"$data/fpu_recurrence" "$data/fpu-31.csv"
"$data/fpu_recurrence" "$data/fpu-1023.csv" 1023 4 0.25 7600
"$data/fpu_recurrence" "$data/fpu-1024.csv" 1024 1 0.5 43000 0.25

"$hvi_gen" run sine-gordon --step 1/20 --until 100 -o "$data/line"
"$hvi_gen" run sine-gordon-plane --until 200 -o "$data/plane"
cp "$data/line/picture.svg" docs/pictures/breather.svg
cp "$data/plane/picture.svg" docs/pictures/breather-in-the-plane.svg

# The atoms within half a unit of the plane z = 0: x and y at the start, and a block for the end.
"$hvi_gen" run droplet --until 50 --columns "x, y, z" --only table -o "$data/droplet"
awk -F , 'NR > 1 { first = last; last = $0; if (NR == 2) print_atoms() }
          END { print_atoms() }
          function print_atoms(   cells, n, i) {
              n = (split(last, cells, ",") - 1) / 3
              for (i = 2; i <= n + 1; ++i)
                  if (cells[2 * n + i] ^ 2 < 1 / 4) print cells[i], cells[n + i]
              printf "\n\n"
          }' "$data/droplet/trajectory.csv" >"$data/droplet.dat"

gnuplot docs/large-scenes.gp

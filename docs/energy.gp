# Draws docs/energy.png, the picture of docs/methods.md, from the data that ./dev demo writes:
#     gnuplot docs/energy.gp
# SPDX-License-Identifier: MIT
set terminal pngcairo size 900,540 font "sans-serif,13"
set output "docs/energy.png"
set datafile separator ","
set multiplot layout 2,1 margins 0.16,0.97,0.12,0.95 spacing 0,0.10
set xrange [0:5000]
set grid
set key opaque top right
set format y "%.1t×10^{%T}"
set ylabel "energy error"
set format x ""
set ytics 2e-4
plot "build/demo/figure_7.csv" skip 1 using 1:2 with points pt 7 ps 0.2 lc rgb "#1f5fa8" \
     title "Cheby4, h = 0.5"
set format x "%g"
set xlabel "t"
set yrange [-2e-14:2e-14]
set ytics 1e-14
plot "build/demo/figure_7.csv" skip 1 using 1:3 with points pt 7 ps 0.2 lc rgb "#b5442c" \
     title "GauLe4, h = 0.5"

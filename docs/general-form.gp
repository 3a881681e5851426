# Draws the pictures of docs/general-form.md from the data of docs/general-form.sh, which calls it.
# SPDX-License-Identifier: GPL-2.0-or-later
set terminal svg size 760,420 dynamic font "sans-serif,13" background "white"
set grid linecolor rgb "#d8d8d8"
set border linecolor rgb "#505050"
set logscale y
set format y "10^{%L}"
set ytics 1e-15, 100
set mytics 1

set style line 2 linecolor rgb "#00508c" pointtype 7 pointsize 0.6 linewidth 1.5
set style line 3 linecolor rgb "#c83200" pointtype 5 pointsize 0.6 linewidth 1.5
set style line 4 linecolor rgb "#3c7828" pointtype 9 pointsize 0.6 linewidth 1.5
set style line 6 linecolor rgb "#784696" pointtype 13 pointsize 0.6 linewidth 1.5

set output "docs/pictures/rough-energy.svg"
rough = "build/general-form/rough.dat"
set multiplot layout 1,2 margins 0.12,0.77,0.15,0.96 spacing 0.06,0
set logscale x 2
set yrange [1e-15:100]
set ylabel "largest error of the energy"
set xlabel "step"
set xtics ("1/16" 1./16, "1/8" 1./8, "1/4" 1./4, "1/2" 1./2, "1" 1)
unset key
plot rough index 0 using 1:2 with linespoints linestyle 2, \
     "" index 1 using 1:2 with linespoints linestyle 2 dashtype "-", \
     "" index 2 using 1:2 with linespoints linestyle 3, \
     "" index 3 using 1:2 with linespoints linestyle 3 dashtype "-", \
     "" index 4 using 1:2 with linespoints linestyle 4, \
     "" index 5 using 1:2 with linespoints linestyle 4 dashtype "-", \
     "" index 6 using 1:2 with linespoints linestyle 6
unset ylabel
set format y ""
set xlabel "evaluations in a unit of time"
set xtics (32, 64, 128, 256, 512)
set key at screen 0.99,0.94 right top title "functions, nodes" Left reverse samplen 3
plot rough index 0 using ($3/$1):2 with linespoints linestyle 2 title "2, 2", \
     "" index 1 using ($3/$1):2 with linespoints linestyle 2 dashtype "-" title "2, 4", \
     "" index 2 using ($3/$1):2 with linespoints linestyle 3 title "3, 3", \
     "" index 3 using ($3/$1):2 with linespoints linestyle 3 dashtype "-" title "3, 6", \
     "" index 4 using ($3/$1):2 with linespoints linestyle 4 title "4, 4", \
     "" index 5 using ($3/$1):2 with linespoints linestyle 4 dashtype "-" title "4, 8", \
     "" index 6 using ($3/$1):2 with linespoints linestyle 6 title "6, 6"
unset multiplot

set output "docs/pictures/large-steps.svg"
steps = "build/general-form/large_steps.dat"
unset logscale x
set margins 10, 3, 4, 1
set yrange [1e-16:1]
set format y "10^{%L}"
set ylabel "largest error of the energy"
set xlabel "functions s"
set xtics 0, 4
set key default
set key top right Left reverse samplen 3
set ytics 1e-16, 100
plot steps every 2::0 using 1:3 with linespoints linestyle 2 title "s nodes: gauss:s", \
     "" every 2::1 using 1:3 with linespoints linestyle 3 dashtype "-" title "3s/2 nodes"

# Draws the pictures of docs/large-scenes.md from the data of docs/large-scenes.sh, which calls it.
# SPDX-License-Identifier: GPL-2.0-or-later
set terminal svg size 860,380 dynamic font "sans-serif,13" background "white"
set grid linecolor rgb "#d8d8d8"
set border linecolor rgb "#505050"
set style line 1 linecolor rgb "#00508c" linewidth 1.5
set style line 2 linecolor rgb "#c83200" linewidth 1.5 dashtype "-"
set style line 3 linecolor rgb "#3c7828" linewidth 1.5 dashtype ".-"
set style line 4 linecolor rgb "#784696" linewidth 1.5 dashtype "."
set style line 5 linecolor rgb "#646464" linewidth 1.5

set output "docs/pictures/fpu-recurrence.svg"
set datafile separator comma
set yrange [0:1]
set multiplot layout 1,3 margins 0.07,0.97,0.3,0.92 spacing 0.04,0
set xlabel "periods of mode 1"
set ylabel "part of the energy"
set xtics 40
set title "31 masses" offset 0,-0.6
set key below maxrows 3 Left reverse samplen 2
plot for [k=1:5] "build/large-scenes/fpu-31.csv" skip 1 every 4 using 1:k+1 with lines linestyle k \
    title sprintf("mode %d", k)
unset ylabel
set format y ""
set xlabel "periods of mode 4"
set xtics 2000
set title "1023 masses" offset 0,-0.6
plot for [k=1:5] "build/large-scenes/fpu-1023.csv" skip 1 every 4 using 1:k+1 with lines linestyle k \
    title sprintf("mode %d", 4*k)
set xlabel "periods of mode 1"
set xtics 20000
set title "1024 masses" offset 0,-0.6
plot for [k=1:5] "build/large-scenes/fpu-1024.csv" skip 1 every 4 using 1:k+1 with lines linestyle k \
    title sprintf("mode %d", k)
unset multiplot

set output "docs/pictures/droplet.svg"
set datafile separator whitespace
set terminal svg size 760,400 dynamic font "sans-serif,13" background "white"
set format y "%g"
set xtics autofreq
set xlabel "x" offset 0,0.6
set ylabel "y"
set size ratio -1
set xrange [-11:11]
set yrange [-11:11]
unset key
set multiplot layout 1,2
set title "t = 0"
plot "build/large-scenes/droplet.dat" index 0 with points pointtype 7 pointsize 0.5 linecolor rgb "#00508c"
set title "t = 50"
plot "build/large-scenes/droplet.dat" index 1 with points pointtype 7 pointsize 0.5 linecolor rgb "#00508c"
unset multiplot

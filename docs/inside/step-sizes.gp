# Draws the picture of step sizes in docs/inside/scenes.md from the data of docs/inside/step-sizes.sh, which calls it.
# SPDX-License-Identifier: GPL-2.0-or-later
set terminal svg size 860,820 dynamic font "sans-serif,13" background "white"
set grid linecolor rgb "#d8d8d8"
set border linecolor rgb "#505050"
set style line 1 linecolor rgb "#646464" linewidth 1.5
set style line 2 linecolor rgb "#3c7828" linewidth 1.5 dashtype ".-"
set style line 3 linecolor rgb "#c83200" linewidth 1.5 dashtype "-"
set style line 4 linecolor rgb "#00508c" linewidth 1.5
set style line 5 linecolor rgb "#784696" linewidth 1.5 dashtype "."
array stages[5] = [2, 4, 8, 12, 16]
set logscale xy
set format xy "10^{%L}"
set output "docs/pictures/step-sizes.svg"
set multiplot layout 3,3 margins 0.07,0.98,0.13,0.96 spacing 0.06,0.08
do for [scene in "pendulum henon-heiles kepler outer-solar-system nonseparable double-pendulum point-vortices fpu masses"] {
    set title scene offset 0,-0.7
    if (scene eq "outer-solar-system" || scene eq "pendulum" || scene eq "point-vortices") {
        set ylabel "us for a unit of time" offset 1.5,0
    } else {
        unset ylabel
    }
    if (scene eq "point-vortices" || scene eq "fpu" || scene eq "masses") {
        set xlabel "h" offset 0,0.6
    } else {
        unset xlabel
    }
    if (scene eq "fpu") { set key at screen 0.5,0.02 center bottom maxrows 1 samplen 2 } else { unset key }
    plot for [i=1:5] sprintf("build/step-sizes/%s-%d.dat", scene, stages[i]) using 1:3 \
        with lines linestyle i title sprintf("gauss:%d", stages[i])
}
unset multiplot

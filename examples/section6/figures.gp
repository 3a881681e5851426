# Draws Figures 2 to 7 of the paper from the data that section6 has written to a directory:
#     gnuplot -c examples/section6/figures.gp DIRECTORY
# SPDX-License-Identifier: MIT
set datafile separator comma
set terminal svg size 860,500 dynamic font "sans-serif,13" background "white"
set border linecolor rgb "#505050"
set grid linecolor rgb "#d8d8d8"
set style line 1 linecolor rgb "#1f5fa8" linewidth 1.5 pointtype 7 pointsize 0.4
set style line 2 linecolor rgb "#b5442c" linewidth 1.5 pointtype 5 pointsize 0.4
set style line 3 linecolor rgb "#646464" linewidth 1.5 dashtype "-"

data(n) = sprintf("%s/figure_%d.csv", ARG1, n)
picture(n) = sprintf("%s/figure_%d.svg", ARG1, n)

# Figures 2 and 5: errors at t = 3 over h, q left and p right, with a line of slope 4.
do for [figure in "2 5"] {
    n = int(figure)
    set output picture(n)
    set logscale xy
    set format y "10^{%T}"
    set xlabel "h"
    set key top left
    set multiplot layout 1,2 margins 0.09,0.98,0.13,0.92 spacing 0.09,0
    do for [k=0:1] {
        set title (k == 0 ? "error of q" : "error of p")
        # Below the smallest of the errors, those of Cheby4 at h = 3/160.
        stats data(n) skip 1 using 2+k name "smallest" nooutput
        plot data(n) skip 1 using 1:2+k with linespoints linestyle 1 title "Cheby4", \
             data(n) skip 1 using 1:4+k with linespoints linestyle 2 title "GauLe4", \
             smallest_min/4*(x*160/3)**4 with lines linestyle 3 title "slope 4"
    }
    unset multiplot
    unset logscale
}

# Figures 3 and 6: errors of q (top) and p, of Cheby4 left and of GauLe4 right, in one scale.
# NOTE: those of q in Figure 3 grow with exp(t), and are shown by their size.
set xlabel "t"
set format y "%g"
unset key
do for [figure in "3 6"] {
    n = int(figure)
    set output picture(n)
    set multiplot layout 2,2 margins 0.12,0.97,0.12,0.92 spacing 0.11,0.1
    do for [k=0:1] {
        if (n == 3 && k == 0) {
            set logscale y
            set format y "10^{%T}"
            set yrange [1e-5:1e6]
        } else {
            unset logscale
            set format y "%g"
            set yrange [*:*]
            stats data(n) skip 1 using 4+k name "of" nooutput
            largest = 1.1*(of_max > -of_min ? of_max : -of_min)
            set yrange [-largest:largest]
        }
        set ylabel (k == 0 ? "error of q" : "error of p")
        unset xlabel
        if (k == 1) { set xlabel "t" }
        do for [j=0:1] {
            unset title
            if (k == 0) { set title (j == 0 ? "(a) Cheby4" : "(b) GauLe4") }
            plot data(n) skip 1 using 1:(n == 3 && k == 0 ? abs(column(2+2*j+k)) : column(2+2*j+k)) \
                with linespoints linestyle 1+j title word("Cheby4 GauLe4", 1+j)
            unset ylabel
        }
    }
    unset multiplot
}
unset logscale
set yrange [*:*]

# Figures 4 and 7: energy errors, of Cheby4 on top.
set ylabel "energy error"
set format y "%g"
do for [figure in "4 7"] {
    n = int(figure)
    set output picture(n)
    set multiplot layout 2,1 margins 0.14,0.97,0.12,0.92 spacing 0,0.15
    do for [j=0:1] {
        unset xlabel
        if (j == 1) { set xlabel "t" }
        set title (j == 0 ? "(a) Cheby4" : "(b) GauLe4")
        plot data(n) skip 1 using 1:2+j with points linestyle 1+j \
            title word("Cheby4 GauLe4", 1+j)
    }
    unset multiplot
}

# Figures 2 to 7 of the paper
#
# The numerical experiments of Section 6 of Leok and Zhang, *Discrete Hamiltonian variational integrators*.
# Cheby4 is the method with nodes of Chebyshev's quadrature, here `chebyshev:3`; GauLe4 is `gauss:2`. Both
# have order 4. `./dev demo` repeats the experiments too, and [From the paper to the code](../inside/paper.md)
# compares what is seen with the paper's words.
#
# ![Errors of q and of p over h, logarithmic, with Cheby4 and with GauLe4](figure_2.svg)
#
# *Figure 2: errors at t = 3 on H = q p from (2, 2). Both methods have the slope 4; Cheby4 has a fourth of the
# error.*
#
# ![Errors of q, logarithmic, and of p over t, with Cheby4 and with GauLe4](figure_3.svg)
#
# *Figure 3: errors on H = q p, h = 0.4. Errors of q grow as t exp(t), from the first steps on: this is
# truncation, since rounding would begin at 1e-16.*
#
# ![Energy errors over t, with Cheby4 and with GauLe4](figure_4.svg)
#
# *Figure 4: energy errors on H = q p, h = 0.4. Both methods conserve q p. Rounding alone is seen: with
# Cheby4 it drifts, as in the paper.*
#
# ![Errors of q and of p over h, logarithmic, with Cheby4 and with GauLe4](figure_5.svg)
#
# *Figure 5: errors at t = 3 on the harmonic oscillator from (2, 1).*
#
# ![Errors of q and of p over t, with Cheby4 and with GauLe4](figure_6.svg)
#
# *Figure 6: errors on the oscillator, h = 0.5. The amplitude of both methods stays; what grows is the
# difference of their phases from that of the solution.*
#
# ![Energy errors over t, with Cheby4 and with GauLe4](figure_7.svg)
#
# *Figure 7: energy errors on the oscillator, h = 0.5. That of Cheby4 oscillates within a bound and does not
# drift; GauLe4 conserves quadratic energies, and rounding alone is seen.*
# SPDX-License-Identifier: MIT

checkout=$(dirname "$0")/../..
"${HVI_GEN:-hvi-gen}" stepper --method chebyshev:3 -o chebyshev_3.hpp
"${HVI_GEN:-hvi-gen}" stepper --method gauss:2 -o gauss_2.hpp
${CXX:-c++} -std=c++17 -O3 -I "$checkout/src" -I . "$checkout/examples/section6/main.cpp" -o section6
./section6 .
gnuplot -c "$checkout/examples/section6/figures.gp" .

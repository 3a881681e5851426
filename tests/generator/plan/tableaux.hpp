// Tableaux typed by hand.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/methods/tableau.hpp"

namespace tableaux {

using hvi::gen::Number;
using hvi::gen::NumberMatrix;
using hvi::gen::NumberVector;
using hvi::gen::Tableau;

inline Number ratio(long numerator, long denominator) {
    return Number(numerator) / Number(denominator);
}

/// Makes a tableau with a~_ij = b_j - b_j a_ji / b_i.
inline Tableau make(NumberVector c, NumberVector b, NumberMatrix A) {
    Tableau tableau;
    tableau.provenance = {"by-hand", "--method by-hand", {}};
    const std::size_t s = b.size();
    tableau.A_tilde.assign(s, NumberVector(s));
    tableau.c_tilde.assign(s, Number(0));
    for (std::size_t i = 0; i < s; ++i) {
        for (std::size_t j = 0; j < s; ++j) {
            tableau.A_tilde[i][j] = b[j] - b[j] * A[j][i] / b[i];
            tableau.c_tilde[i] = tableau.c_tilde[i] + tableau.A_tilde[i][j];
        }
    }
    tableau.c = std::move(c);
    tableau.b = std::move(b);
    tableau.A = std::move(A);
    return tableau;
}

inline Tableau symplectic_euler() { return make({0}, {1}, {{0}}); }

inline Tableau midpoint() { return make({ratio(1, 2)}, {1}, {{ratio(1, 2)}}); }

inline Tableau verlet() {
    const Number half = ratio(1, 2);
    return make({0, 1}, {half, half}, {{0, 0}, {half, half}});
}

/// Drift, kick, drift: Verlet with q and p exchanged.
inline Tableau position_verlet() {
    const Number half = ratio(1, 2);
    return make({half, half}, {half, half}, {{half, 0}, {half, 0}});
}

inline Tableau lobatto_3() {
    return make({0, ratio(1, 2), 1}, {ratio(1, 6), ratio(2, 3), ratio(1, 6)},
                {{0, 0, 0},
                 {ratio(5, 24), ratio(1, 3), ratio(-1, 24)},
                 {ratio(1, 6), ratio(2, 3), ratio(1, 6)}});
}

/// Two midpoint steps of half the size: the stages decouple.
inline Tableau two_midpoints() {
    const Number quarter = ratio(1, 4);
    const Number half = ratio(1, 2);
    return make({quarter, ratio(3, 4)}, {half, half}, {{quarter, 0}, {half, quarter}});
}

/// Open Newton-Cotes with three nodes, whose middle weight is negative.
inline Tableau negative_weight() {
    return make({ratio(1, 4), ratio(1, 2), ratio(3, 4)}, {ratio(2, 3), ratio(-1, 3), ratio(2, 3)},
                {{ratio(23, 48), ratio(-1, 3), ratio(5, 48)},
                 {ratio(7, 12), ratio(-1, 6), ratio(1, 12)},
                 {ratio(9, 16), 0, ratio(3, 16)}});
}

}  // namespace tableaux

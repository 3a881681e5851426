// Coefficients that are symplectic in doubles.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/plan/scheme.hpp"

namespace hvi::gen {

using DoubleMatrix = std::vector<std::vector<double>>;

/// m and mt in doubles, m[i][j] + mt[j][i] == 1 without rounding.
struct RoundedCoefficients {
    DoubleMatrix m;
    DoubleMatrix mt;
};

/// Rounds each m_ij to a multiple of ulp(max(|m_ij|, |1 - m_ij|)) and takes mt_ji = 1 - m_ij, which
/// is then a double. Where A == A~ only the entries with i > j are rounded, m_ji = 1 - m_ij, and
/// the diagonal is 1/2.
[[nodiscard]] RoundedCoefficients rounded(const Scheme& scheme);

}  // namespace hvi::gen

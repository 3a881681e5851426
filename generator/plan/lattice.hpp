// Coefficients in the formats of floating-point numbers, symplectic in each.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/step.hpp"

namespace hvi::gen {

/// Rounds each m_ij, for each format by itself, to a multiple of ulp(max(|m_ij|, |1 - m_ij|)) and
/// takes mt_ji = 1 - m_ij, which then is of that format. Where A == A~ only the entries with i > j
/// are rounded, m_ji = 1 - m_ij, and the diagonal is 1/2. Empty where 1 is no multiple of that ulp,
/// and where m_ij depends on a parameter.
[[nodiscard]] RoundedCoefficients rounded(const Step& step);

/// Rounds c and the n_ij with i >= j to multiples of one power of two. It is the least one for
/// which these, 1 - c_i and n_ji = n_ij - (c_i - c_j) are numbers of the format. A zero stays one.
[[nodiscard]] RoundedVelocityForm rounded(const VelocityForm& form);

/// Rounds B_j, A_ij and X_ij = b_i phi_ij to multiples of one power of two for each j. It is the
/// least one for which these, D_ij = B_j - A_ij and the sum of the |X_ij| are numbers of the
/// format. The difference between B_j and the sum of the X_ij goes to the largest X_ij, and to its
/// mirror image where the rule is symmetric, so that it stays so.
[[nodiscard]] RoundedGalerkinForm rounded(const GalerkinForm& form);

}  // namespace hvi::gen

// A rule and a span over Q, whatever the nodes are.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "generator/exact/algebra/polynomial.hpp"
#include "generator/exact/algebra/rational_matrix.hpp"

namespace hvi::gen {

/// The interpolatory rule at the roots c_1 .. c_r of P, and functions psi_1 .. psi_s that it
/// integrates exactly: sum_i b_i g(c_i) is the integral over [0,1] of g modulo P, and rational.
struct RationalRule {
    RationalPolynomial P;  ///< has no multiple root
    std::vector<RationalPolynomial> psi;
};

/// Returns H[m][n] = sum_i b_i c_i^(m+n) for m, n < size.
[[nodiscard]] RationalMatrix moments(const RationalPolynomial& P, std::size_t size);

}  // namespace hvi::gen

// Quadratic Hamiltonians.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/algebra/number_vector.hpp"

namespace hvi::gen {

/// The form H(x) = x^T S x / 2 + g^T x + constant with x = (q_1, ..., q_n, p_1, ..., p_n). S is
/// symmetric.
struct QuadraticForm {
    NumberMatrix S;  ///< 2n x 2n
    NumberVector g;  ///< 2n
    Number constant;

    [[nodiscard]] std::size_t degrees_of_freedom() const { return g.size() / 2; }
};

/// Returns E with H(x) = y^T E y / 2 for y = (x, 1): symmetric, (2n + 1) x (2n + 1).
[[nodiscard]] NumberMatrix bordered(const QuadraticForm& H);
[[nodiscard]] QuadraticForm without_border(const NumberMatrix& E);

/// The places in x of degrees of freedom that no entry of S couples with others: first those of
/// their q, then those of their p, ascending. Each place is in one part.
using UncoupledPart = std::vector<std::size_t>;
[[nodiscard]] std::vector<UncoupledPart> uncoupled_parts(const QuadraticForm& H);

/// Returns the terms of H in these variables, without the constant.
[[nodiscard]] QuadraticForm restricted(const QuadraticForm& H, const UncoupledPart& part);

}  // namespace hvi::gen

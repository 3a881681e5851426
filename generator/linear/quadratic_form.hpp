// Quadratic Hamiltonians.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/tableau.hpp"

namespace hvi::gen {

/// H(x) = x^T S x / 2 + g^T x + constant with x = (q_1, ..., q_n, p_1, ..., p_n). S is symmetric.
struct QuadraticForm {
    NumberMatrix S;  ///< 2n x 2n
    NumberVector g;  ///< 2n
    Number constant;

    [[nodiscard]] std::size_t degrees_of_freedom() const { return g.size() / 2; }
};

}  // namespace hvi::gen

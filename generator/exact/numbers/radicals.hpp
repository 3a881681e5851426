// Products of square roots in written form.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/exact/numbers/field.hpp"

namespace hvi::gen {

/// A rational factor and radicals, equal to a product of root generators.
struct Radicals {
    Rational factor = 1;
    std::vector<Expression> factors;
};

/// Returns the shorter of two ways to write a product of roots: the rational radicands under one
/// root and each nested one by itself, or all under one root. sqrt(2)*sqrt(3) is sqrt(6), and the
/// two conjugate radicals of gauss:4 multiply to 35*sqrt(105). Generators of other kinds are left
/// out.
[[nodiscard]] Radicals radicals(const Monomial& monomial, const Field* field);

}  // namespace hvi::gen

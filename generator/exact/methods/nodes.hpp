// Quadrature nodes c_1 .. c_s, from the user's list and from families.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/exact/algebra/polynomial.hpp"
#include "generator/read/parse.hpp"

namespace hvi::gen {

struct Nodes {
    NumberVector c;
    /// The monic polynomial over Q in tau whose roots are all the nodes, where that is known.
    std::optional<RationalPolynomial> polynomial;
};

/// Returns the monic polynomial over Q in tau whose roots are the nodes of a family in [0, 1].
/// Precondition: the family is one of node_families() and has this size.
[[nodiscard]] RationalPolynomial family_polynomial(const Family& family);

/// Returns the nodes of a list. Throws as evaluate_number does; MathError when `roots(...)` has no
/// real root.
[[nodiscard]] Nodes quadrature_nodes(const List& list, const Ground& ground);

}  // namespace hvi::gen

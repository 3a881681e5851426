// Checks that the words of a method stand where they may, before any mathematics is done.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/parse.hpp"

namespace hvi::gen {

/// Checks basis functions: families of functions, and expressions in `tau` without `roots`. Throws
/// InputError at the first item of another kind, at a reserved name, and at more than 64 functions.
void check_basis(const List& basis);

/// Checks nodes: families of nodes, `roots(P(tau))`, and expressions without `tau` and `bspline`.
/// Throws as `check_basis` does, and MathError for Chebyshev nodes that are not real.
void check_nodes(const List& nodes);

/// Checks weights: expressions without `tau`, `roots` and `bspline`. Throws as `check_basis` does.
void check_weights(const List& weights);

/// Checks a coefficient of a tableau: an expression without `tau`, `roots` and `bspline`. Throws as
/// `check_basis` does.
void check_coefficient(const Expression& value, const std::shared_ptr<const Source>& source);

/// Checks the value of a parameter: an expression without symbols other than `pi` and `e`, and
/// without `roots` and `bspline`. `place` holds its text.
void check_parameter_value(const Expression& value, const Place& place);

}  // namespace hvi::gen

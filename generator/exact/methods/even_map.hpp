// A method's map of the harmonic oscillator, by polynomials in t = z^2.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/algebra/polynomial_arithmetic.hpp"
#include "generator/exact/methods/number_stages.hpp"
#include "generator/exact/methods/rational_rule.hpp"

namespace hvi::gen {

/// A map of one step, which takes x = (omega q, p) to 1/D (m11 z*m12; z*m21 m22) x, where z = h
/// omega. The fractions need not be in lowest terms, and D(0) need not be 1.
struct EvenMap {
    NumberPolynomial m11, m12, m21, m22, D;
};

/// Returns the map of collocation at the roots of a polynomial over Q, see `node_polynomial`:
/// rational, whatever the roots are.
[[nodiscard]] EvenMap even_map(const RationalPolynomial& P);

/// Returns the map of the general Galerkin form: rational, whatever the nodes are.
[[nodiscard]] EvenMap even_map(const RationalRule& rule);

/// Returns the map of Algorithm 4.3 with exact coefficients and the weights b. NOTE: computed by
/// sums over products of the basis functions and of their integrals, which are short: the tableau's
/// coefficients, and powers of A~ A more so, have many more terms. Takes s 2^s products.
[[nodiscard]] EvenMap even_map_in_basis(const Galerkin& galerkin, const NumberVector& b);
/// Returns how many terms these sums have.
[[nodiscard]] std::size_t term_count_in_basis(const Galerkin& galerkin, const NumberVector& b);

/// Returns the map of any coefficients. Where products of exact ones would take minutes they are
/// enclosed, and `arithmetic` decides which of the results are zero.
[[nodiscard]] EvenMap even_map(const PartitionedMethod& method, PolynomialArithmetic& arithmetic);

}  // namespace hvi::gen

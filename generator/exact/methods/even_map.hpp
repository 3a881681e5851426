// A method's map of the harmonic oscillator, by polynomials in t = z^2.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/algebra/polynomial_arithmetic.hpp"
#include "generator/exact/methods/number_stages.hpp"
#include "generator/exact/methods/rational_rule.hpp"

namespace hvi::gen {

/// One step takes x = (omega q, p) to 1/D (m11 z*m12; z*m21 m22) x, where z = h omega. Neither in
/// lowest terms, nor is D(0) = 1.
struct EvenMap {
    NumberPolynomial m11, m12, m21, m22, D;
};

/// Of collocation at the roots of a polynomial over Q, see `node_polynomial`: rational, whatever
/// the roots are.
[[nodiscard]] EvenMap even_map(const RationalPolynomial& P);

/// Of the general Galerkin form, the same.
[[nodiscard]] EvenMap even_map(const RationalRule& rule);

/// Of Algorithm 4.3 with exact coefficients and the weights b. NOTE: by sums over products of the
/// basis functions and of their integrals, which are short: the tableau's coefficients, and powers
/// of A~ A more so, have many more terms. Takes s 2^s products.
[[nodiscard]] EvenMap even_map_in_basis(const Galerkin& galerkin, const NumberVector& b);
/// How many terms these sums have.
[[nodiscard]] std::size_t term_count_in_basis(const Galerkin& galerkin, const NumberVector& b);

/// Of any coefficients. Where products of exact ones would take minutes they are enclosed, and
/// `arithmetic` is asked which of the results are zero.
[[nodiscard]] EvenMap even_map(const PartitionedMethod& method, PolynomialArithmetic& arithmetic);

}  // namespace hvi::gen

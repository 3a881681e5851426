// Input of Algorithm 4.3 and the general Galerkin form (4.6): the basis and the nodes as exact
// functions and numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/exact/expressions/basis.hpp"
#include "generator/exact/methods/nodes.hpp"
#include "generator/exact/methods/tableau.hpp"
#include "generator/read/method.hpp"

namespace hvi::gen {

/// The exact meaning of a method's text.
struct Ingredients {
    Ground ground;
    std::vector<BasisFunction> psi;
    Nodes nodes;
};

/// Returns the ingredients of a method. Throws as quadrature_nodes() and basis_functions() do.
[[nodiscard]] Ingredients ingredients(const Method& method, Ground ground);

[[nodiscard]] Provenance provenance(const Method& method, const std::vector<BasisFunction>& psi);

/// Returns `node 2, c = 1/2`.
[[nodiscard]] std::string node_text(const NumberVector& nodes, std::size_t i);

/// Returns the numbers of `--weights`, one for each node; throws InputError for another count.
/// Precondition: weights are given.
[[nodiscard]] NumberVector given_weights(const Method& method, const Ingredients& given);

/// Returns the closed form, or 16 digits.
[[nodiscard]] std::string text_of(const Number& number);

/// Returns sum_i v_i psi_i, as text.
[[nodiscard]] std::string combination_text(const NumberVector& v,
                                           const std::vector<BasisFunction>& psi);

/// Throws MathError where this combination of the functions is 0 everywhere, not only at the nodes.
void check_dependence(const Method& method, NumberVector v, std::vector<BasisFunction> psi);

/// Throws MathError unless 1 is in the span of the basis, by which the method is consistent
/// (Section 4.4.3).
void check_constants(const Method& method, const std::vector<BasisFunction>& psi);

/// Throws InputError where some numbers have free parameters, and others are known by enclosures
/// alone, so that they have no sum.
void check_parameters(const Method& method, const std::vector<NumberMatrix>& matrices);

/// Returns the integrals of each function over [0, end].
[[nodiscard]] NumberVector integrals(const std::vector<BasisFunction>& functions, const Number& end,
                                     const Ground& ground);

/// B and A_psi: the integrals over [0, 1], and over [0, c_i], a row for each node.
struct BasisIntegrals {
    NumberVector B;
    NumberMatrix A_psi;
};
[[nodiscard]] BasisIntegrals basis_integrals(const Ingredients& given);

/// Returns psi_i(c_j), row by row.
[[nodiscard]] NumberMatrix values(const std::vector<BasisFunction>& functions,
                                  const NumberVector& nodes, const Ground& ground);

}  // namespace hvi::gen

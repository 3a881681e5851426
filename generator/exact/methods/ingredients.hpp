// What Algorithm 4.3 and the general Galerkin form (4.6) begin with: the basis and the nodes as
// exact functions and numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/exact/expressions/basis.hpp"
#include "generator/exact/methods/nodes.hpp"
#include "generator/exact/methods/tableau.hpp"
#include "generator/read/method.hpp"

namespace hvi::gen {

/// Everything exact that a method's text stands for.
struct Ingredients {
    Ground ground;
    std::vector<BasisFunction> psi;
    Nodes nodes;
};

/// Throws as quadrature_nodes() and basis_functions() do.
[[nodiscard]] Ingredients ingredients(const Method& method, Ground ground);

[[nodiscard]] Provenance provenance(const Method& method, const std::vector<BasisFunction>& psi);

/// `node 2, c = 1/2`
[[nodiscard]] std::string node_text(const NumberVector& nodes, std::size_t i);

/// Those of `--weights`, a number for each node; throws InputError for another count. Precondition:
/// they are given.
[[nodiscard]] NumberVector given_weights(const Method& method, const Ingredients& given);

/// The closed form, or 16 digits.
[[nodiscard]] std::string text_of(const Number& number);

/// sum_i v_i psi_i, as text.
[[nodiscard]] std::string combination_text(const NumberVector& v,
                                           const std::vector<BasisFunction>& psi);

/// Throws MathError where this combination of the functions is 0 not at the nodes alone.
void check_dependence(const Method& method, NumberVector v, std::vector<BasisFunction> psi);

/// Section 4.4.3: the method is consistent when 1 is in the span of the basis. Throws MathError.
void check_constants(const Method& method, const std::vector<BasisFunction>& psi);

/// Throws InputError where some numbers have free parameters, and others, known by enclosures
/// alone, no sum with them.
void check_parameters(const Method& method, const std::vector<NumberMatrix>& matrices);

/// Of each function over [0, end].
[[nodiscard]] NumberVector integrals(const std::vector<BasisFunction>& functions, const Number& end,
                                     const Ground& ground);

/// B and A_psi: the integrals over [0, 1], and over [0, c_i], a row for each node.
struct BasisIntegrals {
    NumberVector B;
    NumberMatrix A_psi;
};
[[nodiscard]] BasisIntegrals basis_integrals(const Ingredients& given);

/// psi_i(c_j), row by row.
[[nodiscard]] NumberMatrix values(const std::vector<BasisFunction>& functions,
                                  const NumberVector& nodes, const Ground& ground);

}  // namespace hvi::gen

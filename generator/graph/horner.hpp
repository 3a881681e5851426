// Horner's form of polynomials in nodes of a graph.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/graph/polynomial.hpp"

namespace hvi::gen {

/// Ways to write a polynomial. None is the shortest for all.
struct HornerForm {
    bool takes_last = false;          ///< of variables that equally many monomials have
    bool takes_roots = false;         ///< 1/sqrt(a) for negative powers, where 1/a would do
    bool divides_once = false;        ///< by the product of all divisors of a term
    bool takes_coefficients = false;  ///< a coefficient of several terms before variables
};

/// Returns a polynomial in Horner's form, as nodes of the graph: the variable that most monomials
/// have is taken out of them, again and again (Ceberio & Kreinovich, Greedy algorithms for
/// optimizing multivariate Horner schemes, SIGSAM Bull. 38 (2004) 8). A coefficient of parameters
/// is one node with its number, which is computed once.
[[nodiscard]] Scaled horner(Graph& graph, const NodePolynomial& polynomial, const HornerForm& form);

}  // namespace hvi::gen

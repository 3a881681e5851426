// Interpolation at all the roots of a polynomial over Q, where sums over the roots are rational.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "generator/exact/algebra/polynomial.hpp"
#include "generator/exact/functions/function.hpp"

namespace hvi::gen {

/// A function that is a polynomial over Q, as one.
[[nodiscard]] std::optional<RationalPolynomial> as_polynomial(const ExactFunction& function);

/// What Algorithm 4.3 needs of a basis of polynomials psi_1 .. psi_s of degree less than s at the
/// nodes c_1 .. c_s.
struct Interpolation {
    NumberMatrix M_inverse;  ///< of M[i][j] = psi_i(c_j)
    NumberVector b;          ///< the integrals over [0,1] of phi = M^-1 psi
};

/// Every entry is a polynomial in one node, computed in Q[x]/(P), and evaluated in the end:
/// rational where it is constant modulo the minimal polynomial of the node, so that equal weights
/// and zero weights are proved also at nodes without a closed form. `nodes` are the roots of P,
/// each once; empty when P has multiple roots or the psi are dependent.
[[nodiscard]] std::optional<Interpolation> interpolate(const std::vector<RationalPolynomial>& psi,
                                                       const RationalPolynomial& P,
                                                       const NumberVector& nodes,
                                                       const Ground& ground);

}  // namespace hvi::gen

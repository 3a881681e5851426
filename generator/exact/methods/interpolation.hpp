// Interpolation at all the roots of a polynomial over Q, where sums over the roots are rational.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "generator/exact/algebra/polynomial.hpp"
#include "generator/exact/functions/function.hpp"

namespace hvi::gen {

/// Returns a function as a polynomial over Q, if it is one.
[[nodiscard]] std::optional<RationalPolynomial> as_polynomial(const ExactFunction& function);

/// Input of Algorithm 4.3 for a basis of polynomials psi_1 .. psi_s of degree less than s at the
/// nodes c_1 .. c_s.
struct Interpolation {
    NumberMatrix M_inverse;  ///< inverse of M[i][j] = psi_i(c_j)
    NumberVector b;          ///< integrals over [0,1] of phi = M^-1 psi
};

/// Returns the interpolation. Every entry is a polynomial in one node, computed in Q[x]/(P), and
/// evaluated in the end. It is rational where it is constant modulo the minimal polynomial of the
/// node, so that equal weights and zero weights are proved also at nodes without a closed form.
/// `nodes` are the roots of P, each once; empty when P has multiple roots or the psi are dependent.
[[nodiscard]] std::optional<Interpolation> interpolate(const std::vector<RationalPolynomial>& psi,
                                                       const RationalPolynomial& P,
                                                       const NumberVector& nodes,
                                                       const Ground& ground);

}  // namespace hvi::gen

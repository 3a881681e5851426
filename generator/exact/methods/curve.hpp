// The curve between the ends of a step.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "generator/exact/methods/galerkin.hpp"

namespace hvi::gen {

/// A(tau), the antiderivative of a term in the basis, but for a factor, with A(0) = 0.
struct Antiderivative {
    enum class Kind {
        power,        ///< tau^power
        exponential,  ///< exp(rate tau) - 1
        sine,         ///< sin(rate tau)
        cosine,       ///< cos(rate tau) - 1
    };
    Kind kind;
    unsigned power = 0;
    Number rate = 0;
};

/// The Galerkin curve of Section 4.1, in the functions phi = M^-1 psi with phi_j(c_i) = delta_ij,
///
///     q_d(tau h) = q_0 + h sum_j integral_0^tau phi_j * dH/dp(Q_j, P_j),
///     integral_0^tau phi_j = b_j tau + sum_k F_jk g_k(tau).
///
/// All g_k vanish at both ends: they are what the curve departs by from its chord. For polynomials
/// they are g_k(tau) = (P_{k+1} - P_{k-1})(2 tau - 1)/2 = (2k + 1) integral_0^tau P_k(2 rho - 1)
/// drho, k = 1, 2, ..., of Legendre's P_k, and F_jk is the integral of phi_j(tau) P_k(2 tau - 1)
/// over [0,1]. Else g_k(tau) = A_k(tau) - tau A_k(1).
struct Curve {
    NumberMatrix F;                 ///< stages x functions; without columns for a straight line
    std::vector<Antiderivative> A;  ///< empty for polynomials
    std::size_t order;              ///< the error is O(h^(order+1)) in one step, for all tau
};

/// The curve of `derivation`, that of `method`. Throws InputError for a method with a free
/// parameter, and for a basis with other functions than sums of tau^k, exp(a tau), cos(b tau) and
/// sin(b tau), all of which are to come.
///
/// The order is min(s, r + 1) where the basis spans the polynomials of degree less than s and the
/// rule is exact for r degrees more than interpolation makes it. Then sum_j a~_ij c_j^(k-1) =
/// c_i^k/k for k <= r (see galerkin.cpp), so that the P_j, and with them the slopes, are good to
/// O(h^(r+1)); q_d' is their interpolating polynomial, with the error O(h^s) of its own. For other
/// bases it is 1: the span has the constants.
[[nodiscard]] Curve curve(const Method& method, const Derivation& derivation);

}  // namespace hvi::gen

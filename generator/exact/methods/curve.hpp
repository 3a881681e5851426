// The curve between the ends of a step.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "generator/exact/algebra/number_vector.hpp"

namespace hvi::gen {

struct AnyDerivation;
struct Method;

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

/// The Galerkin curve of Section 4.1, in the functions phi = M^-1 psi with phi_j(c_i) = delta_ij:
///
///     q_d(tau h) = q_0 + h sum_j integral_0^tau phi_j * dH/dp(Q_j, P_j),
///     integral_0^tau phi_j = b_j tau + sum_k F_jk g_k(tau).
///
/// All g_k vanish at both ends: with them the curve departs from its chord. For polynomials they
/// are g_k(tau) = (P_{k+1} - P_{k-1})(2 tau - 1)/2 = (2k + 1) integral_0^tau P_k(2 rho - 1) drho, k
/// = 1, 2, ..., with Legendre's P_k, and F_jk is the integral of phi_j(tau) P_k(2 tau - 1) over
/// [0,1]. Otherwise g_k(tau) = A_k(tau) - tau A_k(1).
///
/// The curve (4.2) with more nodes than functions and H = p^T K p/2 + U(q) is, with the letters of
/// GalerkinRule and A(tau) for the integrals of the psi_k over [0, tau],
///
///     q_d(tau h) = q_0 + tau h v + sum_j (tau - A(tau) G^-1 A_j^T) W_j,
///
/// The factor of W_j is n_ij with tau in place of c_i. The curve departs from the chord by sum_jk
/// F_jk g_k(tau) W_j, where A_k(tau) = B_k tau + sum_l R_kl g_l(tau) and F = -A_psi G^-1 R. For any
/// H it departs by the velocities U_i at the nodes, as these make V = G^-1 Psi diag(b) U: with F =
/// diag(b) Psi^T G^-1 R.
struct Curve {
    NumberMatrix F;  ///< velocities at nodes that have a weight x functions; without columns for a
                     ///< straight line
    std::optional<NumberMatrix> of_forces;  ///< all W_j x functions, with more nodes
    std::vector<Antiderivative> A;          ///< empty for polynomials
    std::size_t order;  ///< its error is O(h^(order+1)) in one step, for all tau
};

/// Returns the curve of `derivation`, which derives `method`. Throws InputError for a method with a
/// free parameter, and for a basis with other functions than sums of tau^k, exp(a tau), cos(b tau)
/// and sin(b tau), all of which are to come.
///
/// The order is min(s, r + 1) where the basis spans the polynomials of degree less than s and the
/// rule is exact for r degrees more than s - 1. With as many nodes as functions sum_j a~_ij
/// c_j^(k-1) = c_i^k/k for k <= r (see galerkin.cpp), so that the P_j, and with them the slopes,
/// are good to O(h^(r+1)); q_d' is their interpolating polynomial, with the error O(h^s) of its
/// own. With more nodes (4.6d) is the rule for
///
///     integral psi_j p = p_0 B_j + integral (B_j - A_j(tau)) p'(tau),
///
/// For a p of degree k the rule is satisfied where it is exact for degree s - 1 + k: so q_d' is
/// right up to O(h^min(s, r+1)) again. For other bases the order is 1: the span has the constants.
///
/// Momenta are combined from the same functions:
///
///     p(tau h) = p_0 - h sum_j integral_0^tau phi_j * dH/dq(Q_j, P_j),
///
/// The factor with more nodes is diag(b) Psi^T G^-1 R. As Q_j is on the curve, and P_j as good as
/// stated above, the slopes -dH/dq(Q_j, P_j) are those of the exact momenta up to O(h^min(s, r+1)).
/// So is their combination in the span: the order is that of the positions.
[[nodiscard]] Curve curve(const Method& method, const AnyDerivation& derivation);

}  // namespace hvi::gen

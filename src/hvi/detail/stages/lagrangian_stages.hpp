// The curve of a step of a Lagrangian: (4.14).
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/linear/frozen_matrix.hpp>
#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/curve_stages.hpp>

namespace hvi::detail {

/// A Curve of L(q, v) whose momenta are no unknowns: at node i, where the velocity is U_i = sum_j
/// phi_ij V_j,
///
///     P_i = dL/dv(Q_i, U_i),    Lp_i = h b_i dL/dq(Q_i, U_i).
///
/// Precondition: vectors are of fixed size.
template <class Vector, std::size_t nodes, std::size_t functions>
struct LagrangianStages : Curve<Vector, nodes, functions> {
    using Base = Curve<Vector, nodes, functions>;
    using typename Base::Index;
    using typename Base::Scalar;
    using typename Base::Table;

    /// Returns U_i.
    [[nodiscard]] Vector velocity(std::size_t i, const Table& X) const {
        Vector U = this->way(i, X);
        for (Index k = 0; k < this->n; ++k) { U[k] /= this->hb[i]; }
        return U;
    }

    /// Sets the slopes from the derivatives of L at node i.
    void set_slopes(std::size_t i, const Vector& dLdq, const Vector& dLdv) {
        for (Index k = 0; k < this->n; ++k) {
            this->Lp[i][k] = this->hb[i] * dLdq[k];
            this->Y[i][k] = (dLdv[k] - this->at.p[k]) - this->remainder.p[k];
        }
    }

    /// Takes a step of Newton's method with the Jacobian of h -> 0, in which d2L/dv2 is M
    /// everywhere: G_j M dW_j = -h F_j. The basis is orthogonal for the rule.
    void correct(const Table& X, const Table& D, const Scalar (&inverse_G)[functions],
                 const FrozenMatrix<Vector>& M) {
        for (std::size_t j = 0; j < functions; ++j) {
            const Vector step = M.inverse_times(this->defect(j, X, D));
            for (Index k = 0; k < this->n; ++k) {
                this->W[j][k] -= this->h * inverse_G[j] * step[k];
            }
        }
    }

    // ---- starting values ----

    /// Sets the velocity to v throughout: as 1 is in the span, V_j = B_j v/G_j.
    void go_straight(const Vector& v, const Scalar (&B)[functions],
                     const Scalar (&inverse_G)[functions]) {
        for (std::size_t j = 0; j < functions; ++j) {
            for (Index k = 0; k < this->n; ++k) {
                this->W[j][k] = this->h * B[j] * inverse_G[j] * v[k];
            }
        }
    }

    /// Extrapolates the curve of the last step.
    void extrapolate(const Scalar (&N_W)[functions][functions]) {
        for (Index k = 0; k < this->n; ++k) {
            std::array<Scalar, functions> last;
            for (std::size_t j = 0; j < functions; ++j) { last[j] = this->W[j][k]; }
            for (std::size_t j = 0; j < functions; ++j) {
                Scalar sum = 0;
                for (std::size_t l = 0; l < functions; ++l) { sum += N_W[j][l] * last[l]; }
                this->W[j][k] = sum;
            }
        }
    }
};

template <class Vector>
[[nodiscard]] Vector zero_like(Vector v) {
    for (IndexOf<Vector> k = 0; k < v.size(); ++k) { v[k] = 0; }
    return v;
}

/// Returns v of p = dL/dv(q, v), by M v = p - dL/dv(q, 0) with M = d2L/dv2; `time` is none, or t.
/// Precondition: `matrix` holds M.
template <class System, class Vector, class... Time>
[[nodiscard]] Vector velocity_of(const System& system, const FrozenMatrix<Vector>& matrix,
                                 const Vector& q, const Vector& p, const Time&... time) {
    const Vector rest = zero_like(q);
    Vector momentum{};
    system.dLdv(q, rest, time..., momentum);
    for (IndexOf<Vector> k = 0; k < q.size(); ++k) { momentum[k] = p[k] - momentum[k]; }
    return matrix.solve(momentum);
}

/// Returns v of p = dL/dv(q, v); NaN where M is singular.
template <class System, class Vector, class... Time>
[[nodiscard]] Vector velocity_of(const System& system, const Vector& q, const Vector& p,
                                 const Time&... time) {
    FrozenMatrix<Vector> M;
    const Vector rest = zero_like(q);
    if (M.compute([&](auto& out) { system.d2Ldv2(q, rest, time..., out); })) {
        return velocity_of(system, M, q, p, time...);
    }
    Vector none = q;
    for (IndexOf<Vector> k = 0; k < q.size(); ++k) {
        none[k] = infinity<ScalarOf<Vector>> - infinity<ScalarOf<Vector>>;
    }
    return none;
}

}  // namespace hvi::detail

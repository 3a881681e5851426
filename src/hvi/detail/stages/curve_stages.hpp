// The curve of a step and the momenta along it: the general Galerkin form (4.6).
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/coefficients/weights.hpp>
#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/moved.hpp>
#include <hvi/detail/stages/step_memory.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// The curve with the velocity sum_j phi_j V_j, where W_j = h V_j, and the momenta P_i = p + (e_p +
/// Y_i) at its nodes:
///
///     Q_i = q + (e_q + sum_j A_ij W_j),    next q = q + (e_q + sum_j B_j W_j),
///     F_j = sum_i X_ij Y_i - sum_i D_ij Lp_i = 0,    next p = p + (e_p + sum_i Lp_i),
///
/// The sum of X_ij over i is B_j, so that Y_i may stand for P_i. The step is symplectic when A_ij +
/// D_ij == B_j; both hold exactly in every format. CurveStages defines Lp_i and P_i for
/// Hamiltonians, LagrangianStages for Lagrangians.
template <class Vector, std::size_t nodes, std::size_t functions>
struct Curve : StepMemory<Vector> {
    using Scalar = ScalarOf<Vector>;
    using Index = IndexOf<Vector>;
    using Table = Scalar[nodes][functions];

    std::array<Vector, nodes> Q{}, P{}, Y{}, Lp{};
    std::array<Vector, functions> W{};
    std::array<Scalar, nodes> hb{};  ///< h b_i; see weigh()

    /// Sets hb.
    void weigh(const Scalar (&b)[nodes]) {
        if (this->h == weighed_) { return; }
        hb = weights_of_step(this->h, b);
        weighed_ = this->h;
    }

    /// Sets the velocity to zero, and the momenta to those of the state.
    void rest() {
        set_zero(W);
        set_zero(Y);
    }

    /// Sets Q_i, and how much they change.
    void positions(const Table& A) {
        for (Index k = 0; k < this->at.q.size(); ++k) {
            Scalar distance = 0;
            for (std::size_t i = 0; i < nodes; ++i) {
                Scalar increment = 0;
                for (std::size_t j = 0; j < functions; ++j) { increment += A[i][j] * W[j][k]; }
                const Scalar Q_i = moved(this->at.q[k], this->remainder.q[k] + increment);
                distance += abs(Q_i - Q[i][k]);
                Q[i][k] = Q_i;
            }
            this->change.q[k] = distance;
        }
    }

    /// Sets P_i, and how much they change.
    void momenta() {
        for (Index k = 0; k < this->at.q.size(); ++k) {
            Scalar distance = 0;
            for (std::size_t i = 0; i < nodes; ++i) {
                const Scalar P_i = moved(this->at.p[k], this->remainder.p[k] + Y[i][k]);
                distance += abs(P_i - P[i][k]);
                P[i][k] = P_i;
            }
            this->change.p[k] = distance;
        }
    }

    /// Returns h b_i times the velocity at node i: sum_j X_ij W_j.
    [[nodiscard]] Vector way(std::size_t i, const Table& X) const {
        Vector result = W[0];
        for (Index k = 0; k < this->at.q.size(); ++k) {
            Scalar sum = 0;
            for (std::size_t j = 0; j < functions; ++j) { sum += X[i][j] * W[j][k]; }
            result[k] = sum;
        }
        return result;
    }

    /// Returns F_j.
    [[nodiscard]] Vector defect(std::size_t j, const Table& X, const Table& D) const {
        Vector F = Y[0];
        for (Index k = 0; k < this->at.q.size(); ++k) {
            Scalar sum = 0;
            for (std::size_t i = 0; i < nodes; ++i) {
                sum += X[i][j] * Y[i][k] - D[i][j] * Lp[i][k];
            }
            F[k] = sum;
        }
        return F;
    }

    /// Returns the size that the rounding of component k of Q, and of P, is compared with. NOTE: it
    /// includes q, or p, since a stage may be near 0 where q or p is not.
    [[nodiscard]] Scalar size_q(Index k) const {
        Scalar size = abs(this->at.q[k]);
        for (const Vector& Q_i : Q) { size += abs(Q_i[k]); }
        for (const Vector& W_j : W) { size += abs(W_j[k]); }
        return size;
    }
    [[nodiscard]] Scalar size_p(Index k) const {
        Scalar size = abs(this->at.p[k]);
        for (const Vector& P_i : P) { size += abs(P_i[k]); }
        for (const Vector& Lp_i : Lp) { size += abs(Lp_i[k]); }
        return size;
    }

    /// Moves `at` to the end of the step.
    void advance(const Scalar (&B)[functions]) {
        for (Index k = 0; k < this->at.q.size(); ++k) {
            Scalar drift = 0, kick = 0;
            for (std::size_t j = 0; j < functions; ++j) { drift += B[j] * W[j][k]; }
            for (const Vector& Lp_i : Lp) { kick += Lp_i[k]; }
            this->add(this->at.q[k], this->remainder.q[k], drift);
            this->add(this->at.p[k], this->remainder.p[k], kick);
        }
    }

private:
    template <std::size_t count>
    static void set_zero(std::array<Vector, count>& vectors) {
        for (Vector& v : vectors) {
            for (Index k = 0; k < v.size(); ++k) { v[k] = 0; }
        }
    }

    Scalar weighed_ = 0;  ///< step size of hb
};

/// A Curve of H(q, p): Lp_i = -h b_i dH/dq(Q_i, P_i), Lq_i = h b_i dH/dp(Q_i, P_i), and
///
///     E_i = sum_j X_ij W_j - Lq_i = 0.
///
/// Precondition: vectors are of fixed size.
template <class Vector, std::size_t nodes, std::size_t functions>
struct CurveStages : Curve<Vector, nodes, functions> {
    using Base = Curve<Vector, nodes, functions>;
    using typename Base::Index;
    using typename Base::Scalar;
    using typename Base::Table;

    std::array<Vector, nodes> Lq{};

    /// Sets the slopes from the derivatives of H at node i.
    void set_slopes(std::size_t i, const Vector& dHdq, const Vector& dHdp) {
        for (Index k = 0; k < this->at.q.size(); ++k) {
            this->Lp[i][k] = -this->hb[i] * dHdq[k];
            Lq[i][k] = this->hb[i] * dHdp[k];
        }
    }

    /// Sets the slopes at all nodes from one pair of derivatives.
    void set_slopes(const Vector& dHdq, const Vector& dHdp) {
        for (std::size_t i = 0; i < nodes; ++i) { set_slopes(i, dHdq, dHdp); }
    }

    /// Returns E_i.
    [[nodiscard]] Vector defect_of_velocity(std::size_t i, const Table& X) const {
        Vector E = this->way(i, X);
        for (Index k = 0; k < this->at.q.size(); ++k) { E[k] -= Lq[i][k]; }
        return E;
    }

    /// Takes a step of Newton's method with the Jacobian of h -> 0, in which d2H/dp2 is K
    /// everywhere:
    ///
    ///     G_j dW_j = -sum_i phi_ij E_i - h K F_j,    h b_i K dY_i = sum_j X_ij dW_j + E_i.
    ///
    /// The basis is orthogonal for the rule, X_ij = b_i phi_ij and Z_ij = phi_ij/G_j.
    template <class Matrix>
    void correct(const Table& X, const Table& D, const Table& Z,
                 const Scalar (&inverse_G)[functions], const Matrix& K) {
        std::array<Vector, nodes> E;
        for (std::size_t i = 0; i < nodes; ++i) { E[i] = defect_of_velocity(i, X); }
        std::array<Vector, functions> dW;
        for (std::size_t j = 0; j < functions; ++j) {
            dW[j] = K.times(this->defect(j, X, D));
            for (Index k = 0; k < this->at.q.size(); ++k) {
                Scalar sum = this->h * inverse_G[j] * dW[j][k];
                for (std::size_t i = 0; i < nodes; ++i) { sum += Z[i][j] * E[i][k]; }
                dW[j][k] = -sum;
                this->W[j][k] -= sum;
            }
        }
        for (std::size_t i = 0; i < nodes; ++i) {
            for (Index k = 0; k < this->at.q.size(); ++k) {
                for (std::size_t j = 0; j < functions; ++j) { E[i][k] += X[i][j] * dW[j][k]; }
                E[i][k] /= this->hb[i];
            }
            const Vector dY = K.inverse_times(E[i]);
            for (Index k = 0; k < this->at.q.size(); ++k) { this->Y[i][k] += dY[k]; }
        }
    }

    /// Sets starting values: the curve of the last step, and the polynomial through its momenta,
    /// extrapolated.
    void extrapolate(const Scalar (&N_W)[functions][functions], const Scalar (&N_P)[nodes][nodes]) {
        for (Index k = 0; k < this->at.q.size(); ++k) {
            std::array<Scalar, functions> W_k;
            std::array<Scalar, nodes> P_k;
            for (std::size_t j = 0; j < functions; ++j) { W_k[j] = this->W[j][k]; }
            for (std::size_t i = 0; i < nodes; ++i) { P_k[i] = this->P[i][k] - this->at.p[k]; }
            for (std::size_t j = 0; j < functions; ++j) {
                Scalar sum = 0;
                for (std::size_t l = 0; l < functions; ++l) { sum += N_W[j][l] * W_k[l]; }
                this->W[j][k] = sum;
            }
            for (std::size_t i = 0; i < nodes; ++i) {
                Scalar sum = 0;
                for (std::size_t l = 0; l < nodes; ++l) { sum += N_P[i][l] * P_k[l]; }
                this->Y[i][k] = sum;
            }
        }
    }
};

}  // namespace hvi::detail

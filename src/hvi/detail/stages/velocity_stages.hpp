// The stages of an implicit stepper for quadratic kinetic energy.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/coefficients/weights.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/free_path.hpp>
#include <hvi/detail/stages/step_memory.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// Stages of H = p^T K p/2 + U(q) without their momenta, for w = h K p at the start:
///
///     Lp_j = -h b_j dH/dq(Q_j),    W_j = h K Lp_j,
///     Q_i = q + (e_q + c_i w + sum_j n_ij W_j),
///     next q = q + w + (e_q + sum_j (1 - c_j) W_j),    next w = w + sum_j W_j.
///
/// The method is symplectic when n_ij - n_ji == c_i - c_j, which holds exactly in every format. The
/// momenta are w/(h K): see free_path.hpp.
template <class Vector, std::size_t stages>
struct VelocityStages : StepMemory<Vector> {
    using Index = IndexOf<Vector>;
    using Scalar = ScalarOf<Vector>;

    std::array<Vector, stages> Q{}, Lp{}, W{};
    std::array<Vector, stages> drifted{};  ///< e_q + c_i w
    Vector free_path{}, rest_of_path{};    ///< w is the sum of both
    std::array<Scalar, stages> hb{};       ///< h b_j

    /// Begins a step; see StepMemory.
    [[nodiscard]] Status begin(const State<Vector>& x, Scalar step_size) {
        const Status status = StepMemory<Vector>::begin(x, step_size);
        if (!status.ok() || this->continues) { return status; }
        for (auto* vectors : {&Q, &Lp, &W, &drifted}) {
            for (Vector& v : *vectors) { fit(v, this->n); }
        }
        fit(free_path, this->n);
        fit(rest_of_path, this->n);
        return status;
    }

    /// Sets the values that depend on h alone.
    template <class System>
    void weigh(const System& system, const Scalar (&b)[stages]) {
        if (this->h == weighed_ && this->n == weighed_size_) { return; }
        hb = weights_of_step(this->h, b);
        factors_.set(system, this->n, this->h);
        weighed_ = this->h;
        weighed_size_ = this->n;
    }

    /// Sets w and `drifted` for stages at the times c.
    template <class System>
    void drift_freely(const System& system, const Scalar (&c)[stages]) {
        factors_.scale(system, this->at.p, this->remainder.p, free_path, rest_of_path);
        for (std::size_t i = 0; i < stages; ++i) {
            Vector& to = drifted[i];
            for (Index k = 0; k < this->at.q.size(); ++k) {
                to[k] = (this->remainder.q[k] + c[i] * rest_of_path[k]) + c[i] * free_path[k];
            }
        }
    }

    /// Sets W_j from Lp_j.
    template <class System>
    void drift(const System& system, std::size_t j) {
        const Vector& from = Lp[j];
        Vector& to = W[j];
        if constexpr (System::has_diagonal_mass) {
            for (Index k = 0; k < this->at.q.size(); ++k) { to[k] = factors_[k] * from[k]; }
        } else {
            Vector& scaled = factors_.scratch();
            for (Index k = 0; k < this->at.q.size(); ++k) { scaled[k] = factors_[k] * from[k]; }
            system.inverse_mass(scaled, to);
        }
    }

    /// Moves component k of q to the end of the step, where `by_forces` is sum_j (1 - c_j) W_j.
    void end_q(Index k, Scalar by_forces) {
        move_far<Scalar>(this->at.q[k], this->remainder.q[k], free_path[k],
                         rest_of_path[k] + by_forces);
    }

    /// Moves p to the end of the step.
    template <class System>
    void end_p(const System&) {
        factors_.kick(
            this->at.p, this->remainder.p, [&](Index k) { return kick<System>(k); },
            [&](Index k) {
                return exact_sum<Scalar, stages>([&](std::size_t j) { return Lp[j][k]; });
            });
    }

    [[nodiscard]] const PathFactors<Vector>& factors() const { return factors_; }

    // ---- one stage, for Newton's method ----

    [[nodiscard]] const Vector& position(std::size_t j) const { return Q[j]; }
    [[nodiscard]] Scalar force(std::size_t j, std::size_t k) const { return detail::at(Lp[j], k); }
    void set_force(std::size_t j, std::size_t k, Scalar value) { detail::at(Lp[j], k) = value; }

private:
    /// Returns the sum of the forces Lp_j, each times the factor of momenta and rounded.
    template <class System>
    [[nodiscard]] Pair<Scalar> kick(Index k) const {
        return exact_sum<Scalar, stages>([&](std::size_t j) {
            if constexpr (System::has_diagonal_mass) {
                return W[j][k];
            } else {
                return opaque(factors_[k] * Lp[j][k]);
            }
        });
    }

    PathFactors<Vector> factors_;
    Scalar weighed_ = 0;    ///< step size of hb and the factors
    Index weighed_size_{};  ///< of the vectors
};

}  // namespace hvi::detail

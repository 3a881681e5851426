// The stages of an implicit stepper.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/coefficients/weights.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/step_memory.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// Stage values Q_i, P_i of (4.18) and their slopes in scaled form,
///
///     Lq_j = h b_j dH/dp(Q_j, P_j),    Lp_i = -h b_i dH/dq(Q_i, P_i),
///     Q_i = q + (e_q + sum_j m_ij Lq_j),    P_j = p + (e_p + sum_i mt_ji Lp_i),
///
/// with m_ij = a_ij/b_j and mt_ji = a~_ji/b_i. The method is symplectic when m_ij + mt_ji == 1,
/// which holds exactly in every format.
template <class Vector, std::size_t positions, std::size_t momenta>
struct Stages : StepMemory<Vector> {
    using Scalar = ScalarOf<Vector>;

    std::array<Vector, positions> Q{}, Lp{};
    std::array<Vector, momenta> P{}, Lq{};
    std::array<Scalar, momenta> hb_q{};    ///< h b_j for Lq_j; see weigh()
    std::array<Scalar, positions> hb_p{};  ///< h b_i for Lp_i

    /// Begins a step; see StepMemory.
    [[nodiscard]] Status begin(const State<Vector>& x, Scalar step_size) {
        const Status status = StepMemory<Vector>::begin(x, step_size);
        if (!status.ok() || this->continues) { return status; }
        for (Vector& v : Q) { fit(v, this->n); }
        for (Vector& v : P) { fit(v, this->n); }
        for (Vector& v : Lq) { fit(v, this->n); }
        for (Vector& v : Lp) { fit(v, this->n); }
        return status;
    }

    /// Sets hb_q and hb_p, for steppers whose weights are no powers of two.
    void weigh(const Scalar (&b_q)[momenta], const Scalar (&b_p)[positions]) {
        if (this->h == weighed_) { return; }
        hb_q = weights_of_step(this->h, b_q);
        hb_p = weights_of_step(this->h, b_p);
        weighed_ = this->h;
    }

    /// Multiplies these slopes by a factor; see Sweeps.
    template <class Indices, class OtherIndices>
    void nudge(const Indices& of_q, const OtherIndices& of_p, Scalar factor) {
        for (const std::size_t j : of_q) { scale(Lq[j], factor); }
        for (const std::size_t i : of_p) { scale(Lp[i], factor); }
    }

    // ---- one stage, for Newton's method ----

    [[nodiscard]] const Vector& position(std::size_t i) const { return Q[i]; }
    [[nodiscard]] const Vector& momentum(std::size_t j) const { return P[j]; }
    [[nodiscard]] Scalar slope_q(std::size_t j, std::size_t k) const {
        return detail::at(Lq[j], k);
    }
    [[nodiscard]] Scalar slope_p(std::size_t i, std::size_t k) const {
        return detail::at(Lp[i], k);
    }
    void set_slope_q(std::size_t j, std::size_t k, Scalar value) { detail::at(Lq[j], k) = value; }
    void set_slope_p(std::size_t i, std::size_t k, Scalar value) { detail::at(Lp[i], k) = value; }

private:
    void scale(Vector& x, Scalar factor) const {
        for (IndexOf<Vector> k = 0; k < this->n; ++k) { x[k] *= factor; }
    }

    Scalar weighed_ = 0;  ///< step size of hb_q and hb_p
};

}  // namespace hvi::detail

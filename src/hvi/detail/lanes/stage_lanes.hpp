// The stages of an implicit stepper, side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <hvi/detail/coefficients/weights.hpp>
#include <hvi/detail/lanes/lane_math.hpp>
#include <hvi/detail/lanes/lane_products.hpp>
#include <hvi/detail/lanes/lane_tables.hpp>
#include <hvi/detail/lanes/lanes.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/step_memory.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// Stages in lanes: there is a row for each component, with a lane for each stage. The functions
/// that take coefficients take the columns of m or of mt.
///
/// NOTE: functions that sweeps call are inlined, as no register of this size lives through a call.
template <class Vector, std::size_t stages, std::size_t most = widest>
struct StageLanes : StepMemory<Vector> {
    using Scalar = ScalarOf<Vector>;
    using Lane = Lanes<Scalar, stages, most>;
    using Row = typename Lane::Row;
    using Matrix = LaneMatrix<Scalar, stages>;
    static constexpr std::size_t dimension = fixed_size<Vector>();

    using Rows = LaneRows<Scalar, stages, dimension>;

    Rows Q{}, P{}, Lq{}, Lp{};
    Row hb{};  ///< h b_j; see weigh()

    /// Sets hb.
    void weigh(const Scalar (&b)[stages]) {
        if (this->h == weighed_) { return; }
        hb = lane_row(weights_of_step(this->h, b));
        weighed_ = this->h;
    }

    /// Sets starting values: slopes as at the start of the step.
    void predict_q(const Vector& gradient) { fill(Lq, gradient, Lane(hb)); }
    void predict_p(const Vector& gradient) { fill(Lp, gradient, -Lane(hb)); }

    /// Sets all slopes to zero.
    void rest() { Lq = Lp = {}; }

    /// Sets starting values from the slopes of the last step, or of the last two.
    template <class... Before>
    void extrapolate_q(const Matrix& N, Before&&... before) {
        detail::extrapolate<Lane>(Lq, N, before...);
    }
    template <class... Before>
    void extrapolate_p(const Matrix& N, Before&&... before) {
        detail::extrapolate<Lane>(Lp, N, before...);
    }

    /// Return the stages as arguments of functions of the system.
    [[nodiscard, gnu::always_inline]] LaneAccess<Lane> all_positions() const {
        return read<Lane>(Q);
    }
    [[nodiscard, gnu::always_inline]] LaneAccess<Lane> all_momenta() const { return read<Lane>(P); }

    /// Sets Q_i = q + (e_q + sum_j m_ij Lq_j).
    [[gnu::always_inline]] void positions(const Matrix& m) {
        stage_values(m, Lq, this->at.q, this->remainder.q, Q, this->change.q);
    }

    /// Sets P_j = p + (e_p + sum_i mt_ji Lp_i).
    [[gnu::always_inline]] void momenta(const Matrix& mt) {
        stage_values(mt, Lp, this->at.p, this->remainder.p, P, this->change.p);
    }

    /// Returns rows that functions of the system write for later ones to read.
    template <std::size_t count>
    [[nodiscard, gnu::always_inline]] LaneAccess<Lane>
    write_to(LaneRows<Scalar, stages, count>& rows) const {
        return write<Lane>(rows, Lane(Scalar(1)));
    }
    template <std::size_t count>
    [[nodiscard, gnu::always_inline]] LaneAccess<Lane>
    read_from(const LaneRows<Scalar, stages, count>& rows) const {
        return read<Lane>(rows);
    }

    /// Return rows for dH/dp, stored as Lq_j = h b_j dH/dp, and for dH/dq, stored as Lp_i = -h b_i
    /// dH/dq.
    [[nodiscard, gnu::always_inline]] LaneAccess<Lane> velocities() {
        return write<Lane>(Lq, Lane(hb));
    }
    [[nodiscard, gnu::always_inline]] LaneAccess<Lane> forces() {
        return write<Lane>(Lp, -Lane(hb));
    }

    /// Multiplies all slopes by a factor; see Sweeps.
    void nudge(Scalar factor) {
        for (Rows* rows : {&Lq, &Lp}) {
            for (Row& row : *rows) { (Lane(factor) * Lane(row)).store(row); }
        }
    }

    /// Moves `at` to the end of the step.
    void advance() {
        for (std::size_t k = 0; k < dimension; ++k) {
            this->add(detail::at(this->at.q, k), detail::at(this->remainder.q, k), increment_q(k));
            this->add(detail::at(this->at.p, k), detail::at(this->remainder.p, k),
                      sum_of_lanes(Lane(Lp[k])));
        }
    }

    /// Returns sum_j Lq_j.
    [[nodiscard]] Scalar increment_q(std::size_t k) const { return sum_of_lanes(Lane(Lq[k])); }

    /// Return the size that the rounding of component k of Q, and of P, is compared with.
    [[nodiscard]] Scalar size_q(std::size_t k) const {
        return detail::abs(detail::at(this->at.q, k)) + sum(abs(Lane(Q[k])) + abs(Lane(Lq[k])));
    }
    [[nodiscard]] Scalar size_p(std::size_t k) const {
        return detail::abs(detail::at(this->at.p, k)) + sum(abs(Lane(P[k])) + abs(Lane(Lp[k])));
    }

    // ---- one stage, for Newton's method; see Stages ----

    [[nodiscard]] Vector position(std::size_t i) const { return lane_of<Vector>(Q, i); }
    /// Return the middle stage, or the mean of the two stages in the middle.
    [[nodiscard]] Vector middle_q() const { return middle_of<Vector>(Q); }
    [[nodiscard]] Vector middle_p() const { return middle_of<Vector>(P); }
    [[nodiscard]] Vector momentum(std::size_t j) const { return lane_of<Vector>(P, j); }
    [[nodiscard]] Scalar slope_q(std::size_t j, std::size_t k) const { return Lq[k][j]; }
    [[nodiscard]] Scalar slope_p(std::size_t i, std::size_t k) const { return Lp[k][i]; }
    void set_slope_q(std::size_t j, std::size_t k, Scalar value) { Lq[k].set(j, value); }
    void set_slope_p(std::size_t i, std::size_t k, Scalar value) { Lp[k].set(i, value); }

private:
    static void fill(Rows& rows, const Vector& gradient, const Lane& factor) {
        for (std::size_t k = 0; k < dimension; ++k) {
            (factor * detail::at(gradient, k)).store(rows[k]);
        }
    }

    [[gnu::always_inline]] static void stage_values(const Matrix& m, const Rows& slopes,
                                                    const Vector& start, const Vector& cut_off,
                                                    Rows& values, Vector& changes) {
        keep_in_memory(slopes);
        products<Lane>(
            m, slopes, [&](std::size_t k) { return Lane(detail::at(cut_off, k)); },
            [&](std::size_t k, const auto& ways)
                __attribute__((always_inline)) { move_from(k, start, ways, values, changes); });
    }

    Scalar weighed_ = 0;  ///< step size of hb
};

}  // namespace hvi::detail

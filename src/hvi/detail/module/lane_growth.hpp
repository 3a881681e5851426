// How much directions grow that eight trajectories carry along.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>

#include <hvi/detail/lanes/lane_functions.hpp>
#include <hvi/detail/module/rows_in_lanes.hpp>
#include <hvi/detail/trajectories/trajectories.hpp>

namespace hvi::detail {

/// The growth of a direction in each lane: ln |v| at each step, and MEGNO, in the form of a sum
/// over steps (P. M. Cincotta, C. M. Giordano & C. Simo, Physica D 182, 2003, 151-178):
///
///     Y_n = (2/n) sum_k k ln(|v_k|/|v_k-1|), and its mean over the steps.
///
/// States are ((q, dq), (dp, p)): directions are half of them.
template <class Stepper>
class LaneGrowth {
public:
    using State = typename Stepper::State;
    using Lane = typename State::Lane;
    using Scalar = typename Stepper::Scalar;

    static constexpr bool is_there = true;

    /// Begins with a direction of norm 1: dq, then dp.
    void begin(std::size_t lane, const double* direction, State& x) {
        for (std::size_t k = 0; k < n; ++k) {
            x.q[n + k].set(lane, static_cast<Scalar>(direction[k]));
            x.p[k].set(lane, static_cast<Scalar>(direction[n + k]));
        }
        before_.set(lane, 1);
        for (Row* row : {&steps_, &sum_, &weighted_, &of_megno_}) { row->set(lane, 0); }
    }

    /// Takes the growth in a step.
    void see(State& x) {
        Lane squares(Scalar(0));
        for (std::size_t k = 0; k < n; ++k) {
            const Lane dq(x.q[n + k]), dp(x.p[k]);
            squares = squares + (dq * dq + dp * dp);
        }
        const Lane norm = math::sqrt(squares), by = math::log(norm / Lane(before_));
        const Lane step = Lane(steps_) + Lane(Scalar(1)), weighted = Lane(weighted_) + step * by;
        step.store(steps_);
        weighted.store(weighted_);
        norm.store(before_);
        (Lane(sum_) + by).store(sum_);
        (Lane(of_megno_) + Scalar(2) * weighted / step).store(of_megno_);
        const auto is_far = x.going() & ((Lane(largest) < norm) | (norm < Lane(1 / largest)));
        if (any(is_far)) { rescale(is_far, x); }
    }

    /// Return the sum of logarithms, and the mean of MEGNO.
    [[nodiscard]] double logarithm(std::size_t lane) const {
        return static_cast<double>(sum_[lane]);
    }
    [[nodiscard]] double megno(std::size_t lane) const {
        return static_cast<double>(of_megno_[lane] / steps_[lane]);
    }

private:
    using Row = typename Lane::Row;

    static constexpr std::size_t n = fixed_size<typename Stepper::Vector>() / 2;
    static constexpr Scalar largest = power_of_two<Scalar>(bits<Scalar> < 50 ? 25 : 200);

    /// Scales directions by powers of two, so that nothing is rounded. NOTE: what a step has left
    /// for the next is that of other numbers, and is forgotten.
    void rescale(const typename State::Mask& lanes, State& x) {
        Row far;
        select(lanes, Lane(Scalar(1)), Lane(Scalar(0))).store(far);
        for (std::size_t lane = 0; lane < trajectories_at_once; ++lane) {
            if (far[lane] == 0 || before_[lane] == 0) { continue; }
            const int exponent = -std::ilogb(before_[lane]);
            before_.set(lane, std::scalbn(before_[lane], exponent));
            for (std::size_t k = 0; k < n; ++k) {
                x.q[n + k].set(lane, std::scalbn(x.q[n + k][lane], exponent));
                x.p[k].set(lane, std::scalbn(x.p[k][lane], exponent));
            }
            x.carried.begin_anew(lane);
        }
    }

    Row before_{}, steps_{}, sum_{}, weighted_{}, of_megno_{};
};

/// Functions of a module of rows that carry a direction along.
template <class Problem>
using GrowingRowsInLanes = RowsInLanes<Problem, LaneGrowth>;

}  // namespace hvi::detail

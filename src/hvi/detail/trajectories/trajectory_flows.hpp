// Flows of parts of H, of trajectories side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/numbers/compensated.hpp>
#include <hvi/detail/trajectories/trajectories.hpp>
#include <hvi/detail/trajectories/trajectory_sums.hpp>

namespace hvi::detail {

/// Lanes whose flows are to be computed, as their step size or their parameters have changed.
class ChangedLanes {
public:
    [[nodiscard]] bool any() const { return any_; }

    void add(std::size_t lane) { are_[lane] = any_ = true; }

    /// Calls compute(lane) for each of them, and leaves none.
    template <class Compute>
    void take(Compute compute) {
        for (std::size_t lane = 0; lane < trajectories_at_once; ++lane) {
            if (are_[lane]) { compute(lane); }
        }
        *this = {};
    }

private:
    std::array<bool, trajectories_at_once> are_{};
    bool any_ = false;
};

/// Trajectories on their way through a step, and the sums of their changes so far, which begin with
/// the remainders of the step before; see FlowPath.
template <class State>
struct TrajectoryPath {
    using Lane = typename State::Lane;
    struct Numbers {
        typename State::PositionValues q;
        typename State::Values p;
    };
    Numbers x, change;

    explicit TrajectoryPath(const State& at)
        : x{load(at.q), load(at.p)}, change{load(at.carried.q), load(at.carried.p)} {}

    void move_q(std::size_t k, const Lane& by) {
        x.q[k] += by;
        change.q[k] += by;
    }
    void move_p(std::size_t k, const Lane& by) {
        x.p[k] += by;
        change.p[k] += by;
    }

    /// Ends the step of `at`, where it began.
    void end(State& at) { TrajectorySums<State>::end(at, change.q, change.p); }
};

/// A path on which sums keep what rounding cuts off; see LongFlowPath.
template <class State>
struct LongTrajectoryPath : TrajectoryPath<State> {
    using Lane = typename State::Lane;
    using Numbers = typename TrajectoryPath<State>::Numbers;
    Numbers cut_off;  ///< from the sum of the changes

    explicit LongTrajectoryPath(const State& at) : TrajectoryPath<State>(at) {
        for (Lane& lane : cut_off.q) { lane = Lane(Number(0)); }
        for (Lane& lane : cut_off.p) { lane = Lane(Number(0)); }
    }

    void move_q(std::size_t k, const Lane& by, const Lane& remainder = Number(0)) {
        move(this->x.q[k], this->change.q[k], cut_off.q[k], by, remainder);
    }
    void move_p(std::size_t k, const Lane& by, const Lane& remainder = Number(0)) {
        move(this->x.p[k], this->change.p[k], cut_off.p[k], by, remainder);
    }

    void end(State& at) {
        Numbers to;
        add(at.q, this->change.q, cut_off.q, to.q);
        add(at.p, this->change.p, cut_off.p, to.p);
        TrajectorySums<State>::end_at(at, to.q, to.p, this->change.q, this->change.p, [](auto) {});
    }

private:
    using Number = typename State::Scalar;

    static void move(Lane& at, Lane& change, Lane& cut_off, const Lane& by, const Lane& remainder) {
        at += by;
        const Sum<Lane> sum = two_sum<Lane>(change, by);
        change = sum.value;
        cut_off += sum.remainder + remainder;
    }

    /// Sets `sum` to from + change + cut_off, and `change` to the remainder of the sum.
    template <std::size_t dimension>
    static void add(const std::array<typename Lane::Row, dimension>& from,
                    std::array<Lane, dimension>& change, const std::array<Lane, dimension>& cut_off,
                    std::array<Lane, dimension>& sum) {
        for (std::size_t k = 0; k < from.size(); ++k) {
            const Sum<Lane> first = two_sum<Lane>(from[k], change[k]);
            const Sum<Lane> exact = two_sum<Lane>(first.value, first.remainder + cut_off[k]);
            sum[k] = exact.value;
            change[k] = exact.remainder;
        }
    }
};

/// Returns the changes of each lane, which are those by small angles where `are_small` is true, and
/// those of any(), which is called where a lane needs them.
///
/// NOTE: the choice is made in any case, so that the code of what follows is the same; see
/// Trajectories::end().
template <class Mask, class Changes, class Any>
[[nodiscard, gnu::always_inline]] inline Changes small_or_any(const Mask& are_small,
                                                              const Changes& small, Any any) {
    Changes changes = all(are_small) ? small : any();
    for (std::size_t k = 0; k < changes.size(); ++k) {
        changes[k] = select(are_small, small[k], changes[k]);
    }
    return changes;
}

}  // namespace hvi::detail

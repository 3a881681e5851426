// Directions that steppers of the motion together with a direction carry along.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

#include <hvi/detail/stages/system.hpp>
#include <hvi/detail/trajectories/has_time.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// The state with the coordinates (q, dq) and the momenta (dp, p), of a state and a direction.
template <class Joint, class State, class Direction>
[[nodiscard]] Joint joined(const State& x, const Direction& d) {
    Joint joint;
    const std::size_t n = static_cast<std::size_t>(x.q.size());
    fit(joint.q, static_cast<IndexOf<decltype(joint.q)>>(2 * n));
    fit(joint.p, static_cast<IndexOf<decltype(joint.p)>>(2 * n));
    for (std::size_t k = 0; k < n; ++k) {
        at(joint.q, k) = at(x.q, k);
        at(joint.q, n + k) = at(d.q, k);
        at(joint.p, k) = at(d.p, k);
        at(joint.p, n + k) = at(x.p, k);
    }
    if constexpr (HasTime<Joint>::value) { joint.t = x.t; }
    return joint;
}

/// Moves a direction to where it is in such a state.
template <class Joint, class Direction>
void take_direction(const Joint& joint, Direction& d) {
    const std::size_t n = static_cast<std::size_t>(d.q.size());
    for (std::size_t k = 0; k < n; ++k) {
        at(d.q, k) = at(joint.q, n + k);
        at(d.p, k) = at(joint.p, k);
    }
}

template <class Stepper, class State, class = void>
struct CanGoOn : std::false_type {};
template <class Stepper, class State>
struct CanGoOn<
    Stepper, State,
    std::void_t<decltype(std::declval<Stepper&>().go_on_from(std::declval<const State&>()))>>
    : std::true_type {};

/// Tells a stepper that its last step ended in x, from which it differs by rounding at most.
template <class Stepper, class State>
void go_on_from(Stepper& stepper, const State& x) {
    if constexpr (CanGoOn<Stepper, State>::value) { stepper.go_on_from(x); }
}

/// Carries any number of directions one by one, apart from the stepper of the state that they are
/// at. `Stepper` takes the states of joined(), and each direction has one of its own.
template <class Stepper, class State>
class CarriedApart {
public:
    using Scalar = typename Stepper::Scalar;

    explicit CarriedApart(const Stepper& stepper) : idle_(stepper) {}

    /// See CarriedAlong.
    template <class OfState, class Directions>
    [[nodiscard]] Status advance(OfState& stepper, State& x, Directions& directions, Scalar h) {
        moved_.assign(std::begin(directions), std::end(directions));
        const Status carried = step(x, moved_, h);
        if (!carried.ok()) { return carried; }
        const Status status = stepper.step(x, h);
        if (status.ok()) { std::copy(moved_.begin(), moved_.end(), std::begin(directions)); }
        return status;
    }

    /// Carries all these directions along the step of size h from x. Unless the status is ok, some
    /// of them have been moved. Allocates where there are more of them than ever before.
    [[nodiscard]] Status step(const State& x, std::vector<State>& directions, Scalar h) {
        while (steppers_.size() < directions.size()) { steppers_.push_back(idle_); }
        for (std::size_t k = 0; k < directions.size(); ++k) {
            typename Stepper::State joint = joined<typename Stepper::State>(x, directions[k]);
            go_on_from(steppers_[k], joint);
            const Status status = steppers_[k].step(joint, h);
            if (!status.ok()) { return status; }
            take_direction(joint, directions[k]);
        }
        return {};
    }

    void reset() {
        for (Stepper& stepper : steppers_) { stepper.reset(); }
    }

private:
    Stepper idle_;  ///< takes no step: others are copies of it
    std::vector<Stepper> steppers_;
    std::vector<State> moved_;
};

}  // namespace hvi::detail

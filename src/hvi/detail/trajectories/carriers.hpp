// Steppers that carry directions along a motion, one by one or eight side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include <hvi/detail/stages/system.hpp>
#include <hvi/detail/trajectories/has_time.hpp>
#include <hvi/detail/trajectories/takes_several.hpp>
#include <hvi/detail/trajectories/trajectories.hpp>
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

/// Carries one direction along a motion; `Stepper` takes the states of joined().
template <class Stepper>
class SingleCarrier {
public:
    using Scalar = typename Stepper::Scalar;
    static constexpr std::size_t width = 1;

    explicit SingleCarrier(Stepper stepper) : stepper_(std::move(stepper)) {}

    /// Carries the direction along the step of size h from x. Unless the status is ok, it has kept
    /// its bits.
    template <class State>
    [[nodiscard]] Status step(const State& x, State* directions, std::size_t, Scalar h) {
        typename Stepper::State joint = joined<typename Stepper::State>(x, *directions);
        go_on_from(stepper_, joint);
        const Status status = stepper_.step(joint, h);
        if (status.ok()) { take_direction(joint, *directions); }
        return status;
    }

    void reset() { stepper_.reset(); }

private:
    Stepper stepper_;
};

/// Carries up to eight directions, side by side; each lane of `Stepper` is one. Steps solve
/// nothing, so that they leave nothing for the next.
template <class Stepper>
class LaneCarrier {
public:
    using Scalar = typename Stepper::Scalar;
    static constexpr std::size_t width = trajectories_at_once;

    explicit LaneCarrier(Stepper stepper) : stepper_(std::move(stepper)) {}

    /// Carries so many directions along the step of size h from x. Unless the status is ok, which
    /// is that of the first that fails, all have kept their bits.
    ///
    /// NOTE: lanes that are left over carry the last one.
    template <class State>
    [[nodiscard]] Status step(const State& x, State* directions, std::size_t count, Scalar h) {
        using Joint = typename Stepper::Trajectory;
        typename Stepper::State lanes;
        for (std::size_t lane = 0; lane < width; ++lane) {
            lanes.set(lane, joined<Joint>(x, directions[std::min(lane, count - 1)]));
        }
        const LaneStatus status = stepper_.step(lanes, h);
        for (std::size_t lane = 0; lane < count; ++lane) {
            if (!status[lane].ok()) { return status[lane]; }
        }
        for (std::size_t lane = 0; lane < count; ++lane) {
            take_direction(lanes[lane], directions[lane]);
        }
        return status[0];
    }

    void reset() { stepper_.reset(); }

private:
    Stepper stepper_;
};

template <class Stepper>
using CarrierOf =
    std::conditional_t<TakesSeveral<Stepper>::value, LaneCarrier<Stepper>, SingleCarrier<Stepper>>;

/// Carries any number of directions, by as many carriers as that takes.
template <class Stepper>
class Carriers {
public:
    using Scalar = typename Stepper::Scalar;

    explicit Carriers(Stepper stepper) : idle_(std::move(stepper)) {}

    /// Carries all these directions along the step of size h from x. Unless the status is ok, some
    /// of them have been moved. Allocates where there are more of them than ever before.
    template <class State>
    [[nodiscard]] Status step(const State& x, std::vector<State>& directions, Scalar h) {
        const std::size_t count = directions.size();
        while (carriers_.size() * width < count) { carriers_.push_back(Carrier(idle_)); }
        for (std::size_t first = 0; first < count; first += width) {
            const std::size_t here = std::min(width, count - first);
            const Status status =
                carriers_[first / width].step(x, directions.data() + first, here, h);
            if (!status.ok()) { return status; }
        }
        return {};
    }

    void reset() {
        for (Carrier& carrier : carriers_) { carrier.reset(); }
    }

private:
    using Carrier = CarrierOf<Stepper>;
    static constexpr std::size_t width = Carrier::width;

    Stepper idle_;  ///< takes no step: others are copies of it
    std::vector<Carrier> carriers_;
};

}  // namespace hvi::detail

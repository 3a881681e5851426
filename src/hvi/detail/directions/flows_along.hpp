// Directions that flows of parts of H carry along.
// SPDX-License-Identifier: MIT
//
// NOTE: to be included before the header of a stepper, as dual.hpp is.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include <hvi/detail/directions/groups.hpp>
#include <hvi/detail/numbers/dual.hpp>
#include <hvi/detail/stages/flow_sums.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// A state whose numbers have their derivatives along `parts` directions beside them: dual numbers,
/// which flows move as they move numbers. `Path` is the way through a step.
template <class State, template <class> class Path, std::size_t parts>
class DirectionsInDuals {
public:
    using Scalar = ScalarOf<decltype(State::q)>;
    static constexpr std::size_t width = parts;

    /// Takes `count` directions; those that are left over are 0.
    template <class Iterator>
    void take(Iterator directions, std::size_t count) {
        for (std::size_t i = 0; i < parts; ++i) {
            const auto& d = directions[static_cast<std::ptrdiff_t>(std::min(i, count - 1))];
            for (std::size_t k = 0; k < dimension; ++k) {
                set(at_.q[k].by[i], i < count ? at(d.q, k) : Scalar(0));
                set(at_.p[k].by[i], i < count ? at(d.p, k) : Scalar(0));
            }
        }
    }

    template <class Iterator>
    void give(Iterator directions, std::size_t count) const {
        for (std::size_t i = 0; i < count; ++i) {
            auto& d = directions[static_cast<std::ptrdiff_t>(i)];
            for (std::size_t k = 0; k < dimension; ++k) {
                at(d.q, k) = at_.q[k].by[i];
                at(d.p, k) = at_.p[k].by[i];
            }
        }
    }

    /// Carries the directions along the step from x that move(path) takes. `clock`: that of a path
    /// in time, where the step begins; or none.
    template <class Move, class... Clock>
    [[nodiscard]] Status carry(const State& x, const Move& move, Clock... clock) {
        for (std::size_t k = 0; k < dimension; ++k) {
            set(at_.q[k].value, at(x.q, k));
            set(at_.p[k].value, at(x.p, k));
        }
        Path<DualState> path(clock...);
        if (!sums_.begin(at_, path)) { return Status(Status::Code::unsafe_arithmetic); }
        move(path);
        return sums_.end(at_, path) ? Status() : Status(Status::Code::not_finite);
    }

    void forget() { sums_.forget(); }

private:
    static constexpr std::size_t dimension = fixed_size<decltype(State::q)>();
    using DualState = hvi::State<std::array<Dual<Scalar, parts>, dimension>>;

    /// Sets a number. The remainders of the last step go on where each is the one it ended with.
    void set(Scalar& number, const Scalar& to) {
        if (number != to) { sums_.forget(); }
        number = to;
    }

    DualState at_{};
    FlowSums<DualState> sums_;
};

/// Any number of directions at a state that flows move: six at a time, and a few that are left over
/// one by one.
///
/// NOTE: six take one and a half to five times as long as one, and eight more than six and two, as
/// they do not stay in registers.
template <class State, template <class> class Path>
class FlowsAlong {
public:
    /// See Groups.
    template <class Directions>
    void take(const Directions& directions) {
        groups_.take(directions);
    }
    template <class Directions>
    void give(Directions& directions) {
        groups_.give(directions);
    }

    /// Carries all along a step from x, whose flows move(path) takes, unless the status is not ok.
    template <class Move, class... Clock>
    [[nodiscard]] Status carry(const State& x, const Move& move, const Clock&... clock) {
        Status status;
        groups_.each([&](auto& group, std::size_t, std::size_t) {
            status = group.carry(x, move, clock...);
            return status.ok();
        });
        return status;
    }

    void forget() { groups_.forget(); }

private:
    template <std::size_t parts>
    using Directions = DirectionsInDuals<State, Path, parts>;

    static constexpr std::size_t few = 2;
    Groups<Directions<1>, Directions<6>, few> groups_;
};

}  // namespace hvi::detail

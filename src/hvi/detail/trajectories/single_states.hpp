// Trajectories of an ensemble, one by one.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <hvi/detail/trajectories/courses.hpp>
#include <hvi/detail/trajectories/in_parallel.hpp>
#include <hvi/detail/trajectories/take.hpp>
#include <hvi/integrate.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// Trajectories that `Stepper` advances one at a time. NOTE: the stepper first forgets its memory
/// of the trajectory before, so that nothing depends on their order.
template <class Stepper>
class SingleStates {
public:
    using Trajectory = typename Stepper::State;
    using Courses = detail::Courses<Stepper>;

    explicit SingleStates(const std::vector<Trajectory>& starts)
        : states_(starts), runs_(starts.size()) {}

    /// Returns the number of pieces: a thread takes one at a time.
    [[nodiscard]] std::size_t pieces() const { return states_.size(); }

    /// Takes the trajectories of these pieces through their courses, or up to where watch(i, x) of
    /// a trajectory is false.
    template <class Watch>
    void advance(Numbers& pieces, const Courses& courses, const Watch& watch) {
        Stepper stepper(courses.parameters(0));
        for (std::size_t i = 0; pieces.take(i);) {
            Run& run = runs_[i];
            if (!run.ok() || courses.steps(i) <= 0) { continue; }
            if (courses.has_own_parameters()) { stepper = Stepper(courses.parameters(i)); }
            stepper.reset();
            const Run more = taken(stepper, i, courses, watch);
            run.status = more.status;
            run.steps += more.steps;
        }
    }

    [[nodiscard]] const Trajectory& state(std::size_t i) const { return states_[i]; }
    [[nodiscard]] Status status(std::size_t i) const { return runs_[i].status; }
    [[nodiscard]] std::int64_t steps(std::size_t i) const { return runs_[i].steps; }

    [[nodiscard]] bool ok() const {
        return std::all_of(runs_.begin(), runs_.end(), [](const Run& run) { return run.ok(); });
    }

private:
    template <class Watch>
    [[nodiscard]] Run taken(Stepper& stepper, std::size_t i, const Courses& courses,
                            [[maybe_unused]] const Watch& watch) {
        if constexpr (std::is_same_v<Watch, NoWatch>) {
            return take(stepper, states_[i], courses.h(i), courses.steps(i));
        } else {
            Run run;
            while (run.steps < courses.steps(i)) {
                run.status = stepper.step(states_[i], courses.h(i));
                if (!run.ok()) { break; }
                ++run.steps;
                const Trajectory& now = states_[i];
                if (!watch(i, now)) { break; }
            }
            return run;
        }
    }

    std::vector<Trajectory> states_;
    std::vector<Run> runs_;
};

}  // namespace hvi::detail

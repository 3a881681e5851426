// Trajectories of an ensemble, each for itself.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <hvi/detail/trajectories/take.hpp>
#include <hvi/integrate.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// `Stepper` advances one state. NOTE: it forgets what it remembers of the one before, so that
/// nothing depends on which these are.
template <class Stepper>
class SingleStates {
public:
    using Trajectory = typename Stepper::State;
    using Scalar = typename Stepper::Scalar;

    explicit SingleStates(const std::vector<Trajectory>& starts)
        : states_(starts), runs_(starts.size()) {}

    /// What a thread takes at a time.
    [[nodiscard]] std::size_t pieces() const { return states_.size(); }

    void advance(std::size_t piece, Stepper& stepper, Scalar h, std::int64_t steps) {
        Run& run = runs_[piece];
        if (!run.ok() || steps <= 0) { return; }
        stepper.reset();
        const Run more = take(stepper, states_[piece], h, steps);
        run.status = more.status;
        run.steps += more.steps;
    }

    [[nodiscard]] const Trajectory& state(std::size_t i) const { return states_[i]; }
    [[nodiscard]] Status status(std::size_t i) const { return runs_[i].status; }
    [[nodiscard]] std::int64_t steps(std::size_t i) const { return runs_[i].steps; }

    [[nodiscard]] bool ok() const {
        return std::all_of(runs_.begin(), runs_.end(), [](const Run& run) { return run.ok(); });
    }

private:
    std::vector<Trajectory> states_;
    std::vector<Run> runs_;
};

}  // namespace hvi::detail

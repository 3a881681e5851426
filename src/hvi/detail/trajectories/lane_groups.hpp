// Trajectories of an ensemble, eight side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <hvi/detail/trajectories/trajectories.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// Groups of eight trajectories. `Stepper` advances a group, and takes all its steps before those
/// of the next one, while the group is in the nearest cache.
template <class Stepper>
class LaneGroups {
public:
    using Trajectory = typename Stepper::Trajectory;
    using Scalar = typename Stepper::Scalar;

    explicit LaneGroups(const std::vector<Trajectory>& starts)
        : groups_((starts.size() + width - 1) / width) {
        // NOTE: places that are left over in the last group are copies of the last trajectory, so
        // that nothing can happen in them that does not happen to it.
        for (std::size_t i = 0; i < groups_.size() * width; ++i) {
            groups_[i / width].x.set(i % width, starts[std::min(i, starts.size() - 1)]);
        }
    }

    /// Returns the number of pieces: a thread takes one at a time.
    [[nodiscard]] std::size_t pieces() const { return groups_.size(); }

    /// Gives the stepper the parameters of a piece.
    static void give(const std::vector<typename Stepper::Parameters>& parameters, std::size_t piece,
                     Stepper& stepper) {
        for (std::size_t lane = 0; lane < width; ++lane) {
            const std::size_t i = std::min(piece * width + lane, parameters.size() - 1);
            stepper.set_parameters(lane, parameters[i]);
        }
    }

    void advance(std::size_t piece, Stepper& stepper, Scalar h, std::int64_t steps) {
        advance(stepper, groups_[piece], h, steps);
    }

    [[nodiscard]] Trajectory state(std::size_t i) const { return group(i).x[i % width]; }
    [[nodiscard]] Status status(std::size_t i) const { return group(i).x.status()[i % width]; }
    [[nodiscard]] std::int64_t steps(std::size_t i) const { return group(i).steps[i % width]; }

    [[nodiscard]] bool ok() const {
        return std::all_of(groups_.begin(), groups_.end(),
                           [](const Group& group) { return group.x.status().ok(); });
    }

private:
    static constexpr std::size_t width = trajectories_at_once;
    using Steps = std::array<std::int64_t, width>;

    /// Trajectories that go side by side.
    struct Group {
        typename Stepper::State x;
        Steps steps{};
    };

    /// NOTE: on a copy, which no other thread sees, so that compilers keep it in registers. The
    /// stepper first forgets its memory of another group.
    static void advance(Stepper& stepper, Group& group, Scalar h, std::int64_t steps) {
        typename Stepper::State x = group.x;
        stepper.reset();
        Going going(x.status());
        std::int64_t step = 0;
        for (; step < steps && going.any; ++step) {
            if (!stepper.step(x, h).ok()) { going.update(x.status(), step, group.steps); }
        }
        going.end(step, group.steps);
        group.x = x;
    }

    /// Lanes that have not stopped, and the steps of each lane.
    struct Going {
        std::array<bool, width> lanes{};
        bool any = false;

        explicit Going(const LaneStatus& status) {
            for (std::size_t lane = 0; lane < width; ++lane) {
                lanes[lane] = status[lane].ok();
                any = any || lanes[lane];
            }
        }

        void update(const LaneStatus& status, std::int64_t step, Steps& steps) {
            const Going before = *this;
            *this = Going(status);
            for (std::size_t lane = 0; lane < width; ++lane) {
                if (before.lanes[lane] && !lanes[lane]) { steps[lane] += step; }
            }
        }

        void end(std::int64_t step, Steps& steps) const {
            for (std::size_t lane = 0; lane < width; ++lane) {
                if (lanes[lane]) { steps[lane] += step; }
            }
        }
    };

    [[nodiscard]] const Group& group(std::size_t i) const { return groups_[i / width]; }

    std::vector<Group> groups_;
};

}  // namespace hvi::detail

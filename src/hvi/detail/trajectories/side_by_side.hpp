// Trajectories side by side, each to an end of its own.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <hvi/detail/trajectories/trajectories.hpp>

namespace hvi::detail {

/// Most steps that are taken between two questions to a source.
inline constexpr std::int64_t steps_at_once = 4096;

/// Advances the trajectories of a source, eight at a time. One that has come to its end leaves its
/// lane to the next, so that a long one does not hold seven others.
///
/// `Source` has these members. begin(lane, x, stepper) puts a trajectory into a lane of x, gives
/// the stepper its size of steps and its parameters, and returns how many steps it takes, or 0
/// where there are no more. see(stepper, x) looks at a state after each step, which it may change,
/// and returns false where it ends a trajectory before its last step; ends(lane) is which.
/// end(lane, x, steps) takes a trajectory that has taken so many steps. goes_on() is false where
/// the work is to end.
template <class Stepper, class Source>
class SideBySide {
public:
    /// Forgets what the stepper knows of other trajectories.
    SideBySide(Stepper& stepper, Source& source) : stepper_(stepper), source_(source) {
        stepper_.reset();
        for (std::size_t lane = 0; lane < width; ++lane) { begin(lane); }
    }

    /// Takes all to their ends.
    void run() {
        while (are_there() && source_.goes_on()) {
            const std::int64_t taken = take(steps_ahead());
            for (std::size_t lane = 0; lane < width; ++lane) {
                if (left_[lane] != 0) { look_after(lane, taken); }
            }
        }
    }

private:
    static constexpr std::size_t width = trajectories_at_once;
    using State = typename Stepper::State;

    void begin(std::size_t lane) {
        left_[lane] = all_[lane] = source_.begin(lane, x_, stepper_);
        if (left_[lane] == 0) { x_.rest(lane); }
    }

    [[nodiscard]] bool are_there() const {
        return std::any_of(left_.begin(), left_.end(), [](std::int64_t left) { return left != 0; });
    }

    /// Returns how many steps all lanes take before the first of them is at its end.
    [[nodiscard]] std::int64_t steps_ahead() const {
        std::int64_t fewest = steps_at_once;
        for (const std::int64_t left : left_) {
            if (left != 0) { fewest = std::min(fewest, left); }
        }
        return fewest;
    }

    /// Takes steps, up to the first that fails in a lane or ends it. Returns their number.
    ///
    /// NOTE: on a copy, which nobody else sees, so that compilers keep it in registers.
    [[gnu::flatten]] std::int64_t take(std::int64_t steps) {
        State x = x_;
        Stepper stepper = stepper_;
        std::int64_t taken = 0;
        bool is_ok = true;
        for (; taken < steps && is_ok; ++taken) {
            const bool has_failed = !stepper.step(x).ok();
            is_ok = source_.see(stepper, x) && !has_failed;
        }
        stepper_ = stepper;
        x_ = x;
        return taken;
    }

    void look_after(std::size_t lane, std::int64_t taken) {
        const bool has_failed = !x_.status()[lane].ok();
        left_[lane] -= taken;
        if (!has_failed && !source_.ends(lane) && left_[lane] != 0) { return; }
        source_.end(lane, x_, all_[lane] - left_[lane] - (has_failed ? 1 : 0));
        begin(lane);
    }

    Stepper& stepper_;
    Source& source_;
    State x_;
    std::array<std::int64_t, width> all_{}, left_{};  ///< steps; 0 where a lane has no trajectory
};

}  // namespace hvi::detail

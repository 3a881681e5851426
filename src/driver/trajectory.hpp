// A stepper's way from its initial data: a table of states, and what became of the invariants.
// SPDX-License-Identifier: MIT
//
// For `Problem` see main.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <driver/answer.hpp>
#include <driver/columns.hpp>
#include <driver/departure.hpp>
#include <driver/table.hpp>
#include <hvi/detail/trajectories/take.hpp>
#include <hvi/integrate.hpp>
#include <hvi/state.hpp>

namespace hvi::driver {

/// When the invariants of a run are looked at.
enum class Watch {
    steps,  ///< after every step
    rows,   ///< where a row is written: they cost as much as a step does
};

/// Seconds that a step takes where nobody looks on, over at most half a second; the start is where
/// the run begins. Zero where no step can be taken.
template <class Problem, Watch watch>
double seconds_of_step(double h, std::int64_t steps) {
    using Clock = std::chrono::steady_clock;
    constexpr std::int64_t batch = watch == Watch::rows ? 8 : 256;
    constexpr std::chrono::milliseconds enough(500);
    using Scalar = typename Problem::Stepper::Scalar;
    auto stepper = Problem::stepper();
    auto x = Problem::initial();
    std::int64_t taken = 0;
    const auto start = Clock::now();
    auto now = start;
    while (taken < steps && now - start < enough) {
        const Run run =
            detail::take(stepper, x, static_cast<Scalar>(h), std::min(batch, steps - taken));
        taken += run.steps;
        if (!run.ok()) { steps = taken; }
        now = Clock::now();
    }
    return taken == 0
               ? 0.0
               : std::chrono::duration<double>(now - start).count() / static_cast<double>(taken);
}

/// The run, a step of which is one row in `every`; the last row is where it ends.
template <class Problem, Watch watch>
class Trajectory {
public:
    Trajectory(double h, std::int64_t steps, std::int64_t every, const char* path)
        : h_(h), steps_(steps), every_(every), table_(path) {}

    /// Chooses the columns behind the time, as columns.hpp has them: coordinates, momenta and
    /// invariants are numbered in this order. False where there are no such columns.
    [[nodiscard]] bool choose(std::string_view columns) {
        const std::size_t count = 2 * x_.q.size() + invariants_.count;
        bool are_there = true;
        table_.cell("t");
        const bool is_right = for_each_column(columns, [&](std::string_view name, auto number) {
            are_there = are_there && number >= 0 && static_cast<std::size_t>(number) < count;
            numbers_.push_back(static_cast<std::size_t>(number));
            table_.cell(name);
        });
        table_.end_row();
        return is_right && are_there;
    }

    /// Says what became of it. False where the table could not be written. Precondition: choose().
    [[nodiscard]] bool run() {
        row();
        while (taken_ < steps_ && status_.ok() && table_.good()) { advance(); }
        if (taken_ % every_ != 0) { row(); }
        tell();
        return table_.close();
    }

private:
    using Stepper = typename Problem::Stepper;

    void advance() {
        const std::int64_t left = std::min(every_, steps_ - taken_);
        const Run run = detail::take(stepper_, x_, h_, watch == Watch::rows ? left : 1);
        status_ = run.status;
        iterations_ += run.iterations;
        taken_ += run.steps;
        if (run.steps == 0) { return; }
        invariants_.see(stepper_, x_);
        if (taken_ % every_ == 0) {
            row();
            tell_progress();
        }
    }

    [[nodiscard]] double value(std::size_t number) const {
        const std::size_t n = x_.q.size();
        if (number < n) { return x_.q[number]; }
        if (number < 2 * n) { return x_.p[number - n]; }
        return invariants_.values()[number - 2 * n];
    }

    void row() {
        table_.cell(static_cast<double>(taken_) * h_);
        for (const std::size_t number : numbers_) { table_.cell(value(number)); }
        table_.end_row();
        ++rows_;
    }

    /// Ten times a second.
    void tell_progress() {
        const auto now = std::chrono::steady_clock::now();
        if (now - last_word_ < std::chrono::milliseconds(100)) { return; }
        last_word_ = now;
        say("progress", static_cast<double>(taken_) / static_cast<double>(steps_));
    }

    /// Says the number of a variable that begins with no finite number, where that is why no step
    /// is made.
    void tell_unfit() const {
        const std::size_t n = x_.q.size();
        std::size_t number = 0;
        while (number < 2 * n && std::isfinite(value(number))) { ++number; }
        if (number < 2 * n) { say("unfit", static_cast<std::int64_t>(number)); }
    }

    void tell() const {
        say("status", status_.ok() ? "ok" : status_.message());
        if (!status_.ok() && taken_ == 0) { tell_unfit(); }
        say("steps", taken_);
        say("rows", rows_);
        say("iterations", iterations_);
        say("evaluations", static_cast<std::int64_t>(stepper_.evaluations()));
        for (const Departure& departure : invariants_.departures()) {
            say("start", departure.start);
            say("largest", departure.largest);
            say("last", departure.last);
        }
    }

    double h_;
    std::int64_t steps_, every_;
    Table table_;
    std::vector<std::size_t> numbers_;  // of the columns
    Stepper stepper_ = Problem::stepper();
    typename Stepper::State x_ = Problem::initial();
    Status status_;
    std::int64_t taken_ = 0, rows_ = 0, iterations_ = 0;
    Invariants<Problem> invariants_{stepper_, x_};
    std::chrono::steady_clock::time_point last_word_ = std::chrono::steady_clock::now();
};

/// The command `trajectory H STEPS EVERY COLUMNS FILE`. The status of its end is 0 also where a
/// step failed, 2 where this is not how it was called, 3 where the file cannot be written.
template <class Problem, Watch watch = Watch::steps>
int trajectory(const std::vector<std::string_view>& words) {
    double h = 0;
    std::int64_t steps = 0, every = 0;
    const bool is_right = words.size() == 5 && read(words[0], h) && read(words[1], steps) &&
                          read(words[2], every) && steps >= 0 && every >= 1;
    if (!is_right) { return 2; }
    Trajectory<Problem, watch> trajectory(h, steps, every, std::string(words[4]).c_str());
    if (!trajectory.choose(words[3])) { return 2; }
    say("seconds_of_step", seconds_of_step<Problem, watch>(h, steps));
    return trajectory.run() ? 0 : 3;
}

}  // namespace hvi::driver

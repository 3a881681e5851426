// A stepper's way from its initial data: a table of states, and what became of the invariants.
// SPDX-License-Identifier: MIT
//
// For `Problem` see main.hpp.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <driver/answer.hpp>
#include <driver/departure.hpp>
#include <driver/table.hpp>
#include <hvi/state.hpp>

namespace hvi::driver {

/// Seconds that a step takes where nobody looks on, over at most half a second; the start is where
/// the run begins. Zero where no step can be taken.
template <class Problem>
double seconds_of_step(double h, std::int64_t steps) {
    using Clock = std::chrono::steady_clock;
    constexpr std::int64_t batch = 256;
    constexpr std::chrono::milliseconds enough(500);
    auto stepper = Problem::stepper();
    auto x = Problem::initial();
    std::int64_t taken = 0;
    const auto start = Clock::now();
    auto now = start;
    while (taken < steps && now - start < enough) {
        for (std::int64_t i = 0; i < batch && taken < steps; ++i, ++taken) {
            if (!stepper.step(x, h).ok()) { steps = taken; }
        }
        now = Clock::now();
    }
    return taken == 0
               ? 0.0
               : std::chrono::duration<double>(now - start).count() / static_cast<double>(taken);
}

/// The run, a step of which is one row in `every`; the last row is where it ends.
template <class Problem>
class Trajectory {
public:
    Trajectory(double h, std::int64_t steps, std::int64_t every, const char* path)
        : h_(h), steps_(steps), every_(every), table_(path) {}

    /// Says what became of it. False where the table could not be written.
    [[nodiscard]] bool run() {
        write_names();
        row();
        while (taken_ < steps_ && status_.ok() && table_.good()) { advance(); }
        if (taken_ % every_ != 0) { row(); }
        tell();
        return table_.close();
    }

private:
    using Stepper = typename Problem::Stepper;

    void advance() {
        status_ = stepper_.step(x_, h_);
        iterations_ += status_.iterations;
        if (!status_.ok()) { return; }
        ++taken_;
        invariants_.see(stepper_, x_);
        if (taken_ % every_ == 0) {
            row();
            tell_progress();
        }
    }

    void write_names() {
        table_.cell("t");
        for (const char* name : Problem::variables) { table_.cell(name); }
        for (const char* name : Problem::invariants) { table_.cell(name); }
        table_.end_row();
    }

    void row() {
        table_.cell(static_cast<double>(taken_) * h_);
        for (const auto& q : x_.q) { table_.cell(q); }
        for (const auto& p : x_.p) { table_.cell(p); }
        for (const double value : invariants_.values()) { table_.cell(value); }
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

    void tell() const {
        say("status", status_.ok() ? "ok" : status_.message());
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
    Stepper stepper_ = Problem::stepper();
    typename Stepper::State x_ = Problem::initial();
    Status status_;
    std::int64_t taken_ = 0, rows_ = 0, iterations_ = 0;
    Invariants<Problem> invariants_{stepper_, x_};
    std::chrono::steady_clock::time_point last_word_ = std::chrono::steady_clock::now();
};

/// The command `trajectory H STEPS EVERY FILE`. The status of its end is 0 also where a step
/// failed, 2 where this is not how it was called, 3 where the file cannot be written.
template <class Problem>
int trajectory(const std::vector<std::string_view>& words) {
    double h = 0;
    std::int64_t steps = 0, every = 0;
    const bool is_right = words.size() == 4 && read(words[0], h) && read(words[1], steps) &&
                          read(words[2], every) && steps >= 0 && every >= 1;
    if (!is_right) { return 2; }
    say("seconds_of_step", seconds_of_step<Problem>(h, steps));
    return Trajectory<Problem>(h, steps, every, std::string(words[3]).c_str()).run() ? 0 : 3;
}

}  // namespace hvi::driver

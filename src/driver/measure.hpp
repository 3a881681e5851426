// Where a run ends, what it costs, and how long it takes.
// SPDX-License-Identifier: MIT
//
// For `Problem` see main.hpp.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <driver/answer.hpp>
#include <driver/departure.hpp>
#include <hvi/state.hpp>

namespace hvi::driver {

/// Run times of repetitions.
class Timings {
public:
    void add(double seconds) {
        seconds_.insert(std::upper_bound(seconds_.begin(), seconds_.end(), seconds), seconds);
        total_ += seconds;
    }

    [[nodiscard]] std::size_t count() const { return seconds_.size(); }
    [[nodiscard]] double total() const { return total_; }
    [[nodiscard]] double median() const { return seconds_[seconds_.size() / 2]; }

    /// The middle half of them, as a part of the median.
    [[nodiscard]] double spread() const {
        const std::size_t quarter = seconds_.size() / 4;
        return (seconds_[seconds_.size() - 1 - quarter] - seconds_[quarter]) / median();
    }

private:
    std::vector<double> seconds_;  // sorted
    double total_ = 0;
};

/// One run from the start, timed. False where a step fails.
template <class Problem>
[[nodiscard]] bool take_time(double h, std::int64_t steps, Timings& timings) {
    auto stepper = Problem::stepper();
    auto x = Problem::initial();
    const auto start = std::chrono::steady_clock::now();
    for (std::int64_t i = 0; i < steps; ++i) {
        if (!stepper.step(x, h).ok()) { return false; }
    }
    timings.add(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    return true;
}

/// Says how fast the state moves at the end, to a few digits: by a step that is short.
template <class Problem, class State>
void tell_velocity(const State& x, double h) {
    auto stepper = Problem::stepper();
    State y = x;
    const double shorter = h / (1 << 20);
    static_cast<void>(stepper.step(y, shorter));
    for (std::size_t k = 0; k < x.q.size(); ++k) { say("velocity", (y.q[k] - x.q[k]) / shorter); }
    for (std::size_t k = 0; k < x.p.size(); ++k) { say("velocity", (y.p[k] - x.p[k]) / shorter); }
}

/// The command `measure H STEPS SECONDS`: one run that is looked at, and repetitions that are
/// timed, over so many seconds and at least three. As for trajectory().
template <class Problem>
int measure(const std::vector<std::string_view>& words) {
    constexpr std::size_t least = 3, most = 101;
    double h = 0, seconds = 0;
    std::int64_t steps = 0;
    const bool is_right = words.size() == 3 && read(words[0], h) && read(words[1], steps) &&
                          read(words[2], seconds) && steps >= 0;
    if (!is_right) { return 2; }

    auto stepper = Problem::stepper();
    auto x = Problem::initial();
    Invariants<Problem> invariants(stepper, x);
    Status status;
    std::int64_t taken = 0, iterations = 0;
    while (taken < steps && status.ok()) {
        status = stepper.step(x, h);
        iterations += status.iterations;
        taken += status.ok() ? 1 : 0;
        invariants.see(stepper, x);
    }
    say("status", status.ok() ? "ok" : status.message());
    say("steps", taken);
    say("iterations", iterations);
    say("evaluations", static_cast<std::int64_t>(stepper.evaluations()));
    for (const Departure& departure : invariants.departures()) {
        say("largest", departure.largest);
    }
    for (const auto& q : x.q) { say("end", q); }
    for (const auto& p : x.p) { say("end", p); }
    tell_velocity<Problem>(x, h);
    if (!status.ok() || seconds <= 0) { return 0; }

    Timings timings;
    while (timings.count() < least || (timings.total() < seconds && timings.count() < most)) {
        if (!take_time<Problem>(h, steps, timings)) { return 0; }
    }
    say("seconds", timings.median());
    say("spread", timings.spread());
    return 0;
}

}  // namespace hvi::driver

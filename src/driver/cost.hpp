// Cost of a run: its outcome in words, and its time.
// SPDX-License-Identifier: MIT
//
// For `Problem` see departure.hpp.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <driver/answer.hpp>
#include <driver/departure.hpp>

namespace hvi::driver {

/// Outcome of a run.
struct Outcome {
    std::string_view status = "ok";  ///< or why it stopped
    std::int64_t steps = 0;          ///< taken
    std::int64_t iterations = 0;     ///< of a solver
    std::int64_t evaluations = 0;    ///< of dH/dq

    [[nodiscard]] bool ok() const { return status == "ok"; }
};

/// Writes the outcome, and the departures of the invariants.
template <class Problem>
void tell(const Outcome& outcome, const Invariants<Problem>& invariants) {
    say("status", outcome.status);
    say("steps", outcome.steps);
    say("iterations", outcome.iterations);
    say("evaluations", outcome.evaluations);
    for (const detail::Departure& departure : invariants.departures()) {
        say("largest", departure.largest);
        say("drift", departure.slope());
    }
}

/// Writes the outcome, the departures of the invariants, and the end of the run.
template <class Problem, class State>
void tell(const Outcome& outcome, const Invariants<Problem>& invariants, const State& x) {
    tell(outcome, invariants);
    for (const auto& q : x.q) { say("end", q); }
    for (const auto& p : x.p) { say("end", p); }
}

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

    /// Returns the interquartile range, relative to the median.
    [[nodiscard]] double spread() const {
        const std::size_t quarter = seconds_.size() / 4;
        return (seconds_[seconds_.size() - 1 - quarter] - seconds_[quarter]) / median();
    }

private:
    std::vector<double> seconds_;  // sorted
    double total_ = 0;
};

/// Times repetitions over `seconds` seconds, at least three, and writes their median. prepare() is
/// not timed; it returns a function that does a run and returns false where the run fails.
template <class Prepare>
void tell_time(double seconds, Prepare prepare) {
    constexpr std::size_t least = 3, most = 101;
    Timings timings;
    while (timings.count() < least || (timings.total() < seconds && timings.count() < most)) {
        auto run = prepare();
        const auto start = std::chrono::steady_clock::now();
        if (!run()) { return; }
        const auto end = std::chrono::steady_clock::now();
        timings.add(std::chrono::duration<double>(end - start).count());
    }
    say("seconds", timings.median());
    say("spread", timings.spread());
}

}  // namespace hvi::driver

// A stepper's way from its initial data: a table of states, and what became of the invariants.
// SPDX-License-Identifier: MIT
//
// For `Problem` see departure.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include <driver/answer.hpp>
#include <driver/columns.hpp>
#include <driver/departure.hpp>
#include <driver/table.hpp>
#include <hvi/detail/trajectories/flat.hpp>
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

/// Some numbers of a run, a step of which is one row in `every`; the last row is where it ends.
class Rows {
public:
    Rows(std::int64_t every, const char* path) : every_(every), table_(path) {}

    /// Chooses the columns behind the time, as columns.hpp has them: coordinates, momenta and
    /// invariants are numbered in this order. False where there are no such columns, of so many.
    [[nodiscard]] bool choose(std::string_view columns, std::size_t count) {
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

    [[nodiscard]] bool good() const { return table_.good(); }
    [[nodiscard]] std::int64_t count() const { return count_; }

    [[nodiscard]] bool has_row(std::int64_t taken) const { return taken % every_ == 0; }

    /// How many steps there are to the next row.
    [[nodiscard]] std::int64_t ahead(std::int64_t taken) const { return every_ - taken % every_; }

    /// Writes the row of so many steps, once, where there is one. It is made of value(number).
    template <class Value>
    void see(std::int64_t taken, bool is_end, double time, Value value) {
        if (taken == last_ || !(has_row(taken) || is_end)) { return; }
        last_ = taken;
        table_.cell(time);
        for (const std::size_t number : numbers_) { table_.cell(value(number)); }
        table_.end_row();
        ++count_;
    }

    [[nodiscard]] bool close() { return table_.close(); }

private:
    std::int64_t every_;
    Table table_;
    std::vector<std::size_t> numbers_;  // of the columns
    std::int64_t count_ = 0, last_ = -1;
};

/// The run, and what is written of it.
template <class Problem, Watch watch>
class Trajectory {
public:
    Trajectory(double h, std::int64_t steps) : h_(h), steps_(steps) {}

    /// One more table, a row in `every` steps. False where there are no such columns: see Rows.
    [[nodiscard]] bool add(std::int64_t every, std::string_view columns, const char* path) {
        tables_.emplace_back(every, path);
        const auto& x = detail::flat<Stepper>(x_);
        return tables_.back().choose(columns,
                                     x.q.size() + x.p.size() + invariants_.values().size());
    }

    /// Says what became of it. False where a table could not be written. Precondition: there is
    /// one.
    [[nodiscard]] bool run() {
        write(false);
        while (taken_ < steps_ && status_.ok() && are_good()) { advance(); }
        write(true);
        tell();
        bool are_whole = true;
        for (Rows& table : tables_) { are_whole = table.close() && are_whole; }
        return are_whole;
    }

private:
    using Stepper = typename Problem::Stepper;

    /// To the next row of a table, where these are looked at alone.
    void advance() {
        std::int64_t ahead = steps_ - taken_;
        for (const Rows& table : tables_) { ahead = std::min(ahead, table.ahead(taken_)); }
        const Run run = take(ahead);
        status_ = run.status;
        iterations_ += run.iterations;
        taken_ += run.steps;
        if (run.steps == 0) { return; }
        write(false);
        if (tables_.front().has_row(taken_)) { tell_progress(); }
    }

    /// Looks at invariants after each step, or at the end.
    [[nodiscard]] Run take(std::int64_t steps) {
        if constexpr (watch == Watch::steps) {
            return invariants_.take(stepper_, x_, h_, steps);
        } else {
            const Run run = detail::take(stepper_, x_, h_, steps);
            if (run.steps > 0) { invariants_.see(stepper_, x_); }
            return run;
        }
    }

    [[nodiscard]] bool are_good() const {
        return std::all_of(tables_.begin(), tables_.end(),
                           [](const Rows& table) { return table.good(); });
    }

    template <class State>
    [[nodiscard]] double value(const State& x, std::size_t number) const {
        const std::size_t n = x.q.size(), end = n + x.p.size();
        if (number < n) { return x.q[number]; }
        return number < end ? x.p[number - n] : invariants_.values()[number - end];
    }

    void write(bool is_end) {
        if (tables_.front().has_row(taken_)) { motion_.see(stepper_, x_, invariants_); }
        const auto& x = detail::flat<Stepper>(x_);
        for (Rows& table : tables_) {
            table.see(taken_, is_end, static_cast<double>(taken_) * h_,
                      [&](std::size_t number) { return value(x, number); });
        }
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
        const auto& x = detail::flat<Stepper>(x_);
        const std::size_t count = x.q.size() + x.p.size();
        std::size_t number = 0;
        while (number < count && std::isfinite(value(x, number))) { ++number; }
        if (number < count) { say("unfit", static_cast<std::int64_t>(number)); }
    }

    void tell() const {
        say("status", status_.ok() ? "ok" : status_.message());
        if (!status_.ok() && taken_ == 0) { tell_unfit(); }
        say("steps", taken_);
        say("rows", tables_.front().count());
        say("iterations", iterations_);
        say("evaluations", static_cast<std::int64_t>(stepper_.evaluations()));
        for (const detail::Departure& departure : invariants_.departures()) {
            say("start", departure.start);
            say("largest", departure.largest);
            say("last", departure.last);
        }
        say("motion", motion_.mean());
    }

    double h_;
    std::int64_t steps_;
    std::deque<Rows> tables_;
    Stepper stepper_ = Problem::stepper();
    typename Stepper::State x_ = Problem::initial();
    Status status_;
    std::int64_t taken_ = 0, iterations_ = 0;
    Invariants<Problem> invariants_{stepper_, x_};
    EnergyOfMotion<Problem> motion_;
    std::chrono::steady_clock::time_point last_word_ = std::chrono::steady_clock::now();
};

/// The command `trajectory H STEPS EVERY COLUMNS FILE`, the last three for each of its tables. The
/// status of its end is 0 also where a step failed, 2 where this is not how it was called, 3 where
/// a file cannot be written.
template <class Problem, Watch watch = Watch::steps>
int trajectory(const std::vector<std::string_view>& words) {
    double h = 0;
    std::int64_t steps = 0, every = 0;
    const bool is_right = words.size() >= 5 && words.size() % 3 == 2 && read(words[0], h) &&
                          read(words[1], steps) && steps >= 0;
    if (!is_right) { return 2; }
    Trajectory<Problem, watch> trajectory(h, steps);
    for (std::size_t k = 2; k < words.size(); k += 3) {
        const bool is_table =
            read(words[k], every) && every >= 1 &&
            trajectory.add(every, words[k + 1], std::string(words[k + 2]).c_str());
        if (!is_table) { return 2; }
    }
    say("seconds_of_step", seconds_of_step<Problem, watch>(h, steps));
    return trajectory.run() ? 0 : 3;
}

}  // namespace hvi::driver

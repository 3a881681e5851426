// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/trajectory.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <deque>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <driver/answer.hpp>
#include <driver/departure.hpp>
#include <driver/pace.hpp>
#include <hvi/detail/trajectories/event_steps.hpp>

#include "generator/drive/checkpoint_saver.hpp"
#include "generator/drive/column_samples.hpp"
#include "generator/drive/driven_problem.hpp"
#include "generator/drive/reductions.hpp"
#include "generator/drive/rows.hpp"

namespace hvi::gen {

namespace {

using State = DrivenStepper::State;

/// A run, and its tables.
class Trajectory {
public:
    explicit Trajectory(const TrajectoryWishes& wishes)
        : wishes_(wishes),
          counts_(wishes.events.events.size()),
          samples_(wishes),
          saver_(wishes.checkpoints) {
        open_tables();
        const Rows& own = tables_.front();
        if (!own.has_times()) return;
        course_.output_at(wishes.tables.front().times, [this](const State& x, double t) {
            at_output_.see(stepper_, x);
            const Rows::Value value_there = [&](std::size_t number) {
                return value(x, at_output_.values(), number);
            };
            for (Rows& table : tables_)
                if (table.has_times()) table.write(t, value_there);
            samples_.see_row(value_there);
        });
    }

    /// Runs, and reports the outcome. Returns false where a table could not be written.
    [[nodiscard]] bool run() {
        if (wishes_.clock) course_.take_time_from([](const State& x) { return x.q.back(); });
        wishes_.resumed ? resume(*wishes_.resumed) : begin();
        while (goes_on()) advance();
        if (is_stopped()) save();
        if (run_.ending == Ending::all_steps && !is_stopped()) course_.finish(x_, wishes_.h, run_);
        if (has_come_to_end()) run_.t = wishes_.clock->until;
        if (!is_stopped()) see_end();
        tell();
        bool are_whole = event_rows_->close();
        for (Rows& table : tables_) are_whole = table.close() && are_whole;
        return are_whole;
    }

    [[nodiscard]] std::int64_t steps() const { return run_.run.steps; }

    void tell_frequencies() const { samples_.tell(); }

private:
    void open_tables() {
        if (!wishes_.resumed) {
            for (const TableWishes& table : wishes_.tables) tables_.emplace_back(table);
            event_rows_.emplace(wishes_.events);
            return;
        }
        const Checkpoint& from = *wishes_.resumed;
        if (!fits(from)) throw std::runtime_error("the checkpoint does not fit the run");
        for (std::size_t k = 0; k < wishes_.tables.size(); ++k)
            tables_.emplace_back(wishes_.tables[k], Rows::Place{from.sizes.at(k), from.rows.at(k),
                                                                from.steps, from.t});
        event_rows_.emplace(wishes_.events, from.sizes.back());
    }

    void begin() {
        course_.begin(x_, 0, wishes_.h);
        write();
        reductions_.begin(0, value_now());
    }

    /// Takes the end of the run, which with an event lies within a step.
    void see_end() {
        const bool is_within = run_.ending == Ending::event || run_.ending == Ending::accumulation;
        if (is_within) invariants_.see(stepper_, x_);
        for (Rows& table : tables_) table.see_end(run_.t, value_now());
        reductions_.see(run_.t, value_now());
    }

    [[nodiscard]] bool goes_on() const {
        return taken() < wishes_.steps && run_.ending == Ending::all_steps && are_good() &&
               !is_stopped();
    }

    [[nodiscard]] std::int64_t evaluations() const { return evaluations_ + stepper_.evaluations(); }

    // ---- checkpoints ----

    /// Whether a checkpoint has the right sizes. NOTE: anybody may have made the file.
    [[nodiscard]] bool fits(const Checkpoint& from) const {
        const std::size_t events = counts_.size() + (wishes_.clock ? 1 : 0);
        return from.state.size() == x_.q.size() + x_.p.size() + x_.time.size() &&
               from.departures.size() == invariants_.departures().size() &&
               from.events.size() == events && from.counts.size() == counts_.size() &&
               from.reductions.size() == reductions_.memory_size() &&
               from.rows.size() == wishes_.tables.size() &&
               from.sizes.size() == wishes_.tables.size() + 1;
    }

    void resume(const Checkpoint& from) {
        run_.run.steps = from.steps;
        run_.run.iterations = from.iterations;
        evaluations_ = from.evaluations;
        run_.t = from.t;
        auto next = from.state.begin();
        for (std::vector<double>* part : {&x_.q, &x_.p, &x_.time})
            for (double& value : *part) value = *next++;
        invariants_.resume(stepper_, x_, from.departures);
        motion_.resume(from.motion, from.motions);
        counts_ = from.counts;
        reductions_.resume(from.reductions);
        course_.resume(run_.t, wishes_.h, from.events);
    }

    [[nodiscard]] Checkpoint here() {
        Checkpoint result{.steps = taken(),
                          .iterations = run_.run.iterations,
                          .evaluations = evaluations(),
                          .t = run_.t};
        for (const std::vector<double>* part : {&x_.q, &x_.p, &x_.time})
            result.state.insert(result.state.end(), part->begin(), part->end());
        result.departures = invariants_.departures();
        result.motion = motion_.sum();
        result.motions = motion_.count();
        result.events = course_.memory();
        result.counts = counts_;
        result.reductions = reductions_.memory();
        for (Rows& table : tables_) {
            result.sizes.push_back(table.flushed_size());
            result.rows.push_back(table.count());
        }
        result.sizes.push_back(event_rows_->flushed_size());
        return result;
    }

    /// Writes a checkpoint, where they are wished for, and forgets what a resumed run would not
    /// know.
    void save() {
        if (!wishes_.checkpoints || run_.ending != Ending::all_steps) return;
        saver_.save(here());
        stepper_.reset();
    }

    [[nodiscard]] std::int64_t taken() const { return run_.run.steps; }

    /// Advances to the next row of a table, where only rows are observed.
    void advance() {
        std::int64_t ahead = wishes_.steps - taken();
        for (const Rows& table : tables_) ahead = std::min(ahead, table.ahead(taken()));
        const std::int64_t before = taken();
        ahead = std::min({ahead, saver_.ahead(taken()), samples_.ahead(taken())});
        is_looked_into() ? look_into(ahead) : take(std::min(ahead, to_output()));
        if (taken() == before) return;
        write();
        tell_progress();
        if (saver_.is_due(taken())) save();
    }

    /// Returns the number of steps that may be taken before one that contains an output time.
    [[nodiscard]] std::int64_t to_output() const {
        constexpr double most = 1e6;  // so that it sees soon that it is to stop
        if (!course_.has_output()) return static_cast<std::int64_t>(most);
        if (wishes_.clock) return 0;
        const double steps = (course_.next_output() - run_.t) / wishes_.h;
        return static_cast<std::int64_t>(std::clamp(std::floor(steps) - 1, 0.0, most));
    }

    [[nodiscard]] bool is_looked_into() const {
        return wishes_.clock || !wishes_.events.events.empty() || to_output() == 0;
    }

    /// Takes steps, one by one where each is observed.
    void take(std::int64_t steps) {
        const std::int64_t before = taken(), at_once = reductions_.any() ? 1 : steps;
        while (taken() - before < steps && run_.ending == Ending::all_steps) {
            take_at_once(at_once);
            if (run_.ending == Ending::all_steps) reduce();
        }
        if (wishes_.looks_at_rows && taken() > before) invariants_.see(stepper_, x_);
    }

    void take_at_once(std::int64_t steps) {
        const Run run = wishes_.looks_at_rows ? stepper_.advance(x_, wishes_.h, steps)
                                              : invariants_.take(stepper_, x_, wishes_.h, steps);
        run_.run.status = run.status;
        run_.run.iterations += run.iterations;
        run_.run.steps += run.steps;
        if (!run.ok()) run_.ending = Ending::failed_step;
        run_.t = static_cast<double>(taken()) * wishes_.h;
    }

    /// Takes steps that may contain events or output times, at most so many: several where all are
    /// looked into anyway and are quick, as what is done between them takes as long as a small one.
    void look_into(std::int64_t most) {
        constexpr std::int64_t at_once = 16;
        const bool are_several = is_quick_ && (wishes_.clock || !wishes_.events.events.empty());
        const std::int64_t end = taken() + (are_several ? std::min(at_once, most) : 1);
        do {
            look_into_step();
        } while (taken() < end && run_.ending == Ending::all_steps && !is_stopped());
    }

    void look_into_step() {
        const std::int64_t before = taken();
        course_.take(stepper_, x_, wishes_.h, static_cast<double>(before + 1) * wishes_.h, run_);
        if (taken() == before) return;
        invariants_.see(stepper_, x_);
        if (reductions_.any()) reductions_.see(run_.t, value_now());
    }

    /// Takes the values of a step. NOTE: where invariants cost as much as a step, they are computed
    /// only if some are reduced.
    void reduce() {
        if (!reductions_.any()) return;
        const bool costs = wishes_.looks_at_rows && reductions_.any_from(count_of_variables());
        if (costs) at_step_.see(stepper_, x_);
        const std::vector<double>& invariants = (costs ? at_step_ : invariants_).values();
        reductions_.see(run_.t, [&](std::size_t number) { return value(x_, invariants, number); });
    }

    /// Returns events that write themselves to the table.
    [[nodiscard]] std::vector<Event<DrivenStepper>> events() {
        return counted_events(wishes_.events.events, wishes_.clock, counts_,
                              [this](std::size_t i, std::int64_t number, const State& x, double t) {
                                  event_rows_->write(wishes_.events.events[i].name, number, t,
                                                     seen(x));
                              });
    }

    [[nodiscard]] bool has_come_to_end() const {
        return wishes_.clock && run_.ending == Ending::event && run_.event == counts_.size();
    }

    /// Returns the state without time and its momentum.
    [[nodiscard]] State seen(const State& x) const { return wishes_.clock ? without_clock(x) : x; }

    [[nodiscard]] bool are_good() const {
        return std::all_of(tables_.begin(), tables_.end(),
                           [](const Rows& table) { return table.good(); });
    }

    [[nodiscard]] std::size_t hidden() const { return wishes_.clock ? 1 : 0; }
    [[nodiscard]] std::size_t count_of_variables() const {
        return x_.q.size() + x_.p.size() - 2 * hidden();
    }

    /// Returns a value by its column number. NOTE: time and its momentum are no columns.
    [[nodiscard]] double value(const State& x, const std::vector<double>& invariants,
                               std::size_t number) const {
        const std::size_t n = x.q.size() - hidden(), end = count_of_variables();
        if (number < n) return x.q[number];
        return number < end ? x.p[number - n] : invariants[number - end];
    }

    [[nodiscard]] Rows::Value value_now() const {
        return [this](std::size_t number) { return value(x_, invariants_.values(), number); };
    }

    void write() {
        if (tables_.front().has_row(taken())) motion_.see(stepper_, x_, invariants_);
        for (Rows& table : tables_) table.see(taken(), run_.t, value_now());
        samples_.see(taken(), value_now());
    }

    /// Reports progress ten times a second.
    void tell_progress() {
        const auto now = std::chrono::steady_clock::now();
        is_quick_ = now - last_look_ < std::chrono::milliseconds(1);
        last_look_ = now;
        if (now - last_word_ < std::chrono::milliseconds(100)) return;
        last_word_ = now;
        const double part = wishes_.clock
                                ? run_.t / wishes_.clock->until
                                : static_cast<double>(taken()) / static_cast<double>(wishes_.steps);
        driver::say("progress", std::clamp(part, 0.0, 1.0));
    }

    /// Reports the number of a variable whose start is no finite number, where that is why no step
    /// is made.
    void tell_unfit() const {
        const State variables = seen(x_);
        const std::size_t count = variables.q.size() + variables.p.size();
        std::size_t number = 0;
        while (number < count && std::isfinite(value(x_, {}, number))) ++number;
        if (number < count) driver::say("unfit", static_cast<std::int64_t>(number));
    }

    void tell_end() const {
        tell_ending(run_, counts_.size());
        if (is_stopped() && run_.ending == Ending::all_steps) driver::say("status", "interrupted");
        if (run_.ending == Ending::failed_step && taken() == 0) tell_unfit();
    }

    void tell() const {
        tell_end();
        driver::say("t", run_.t);
        driver::say("rest", run_.rest);
        driver::say("steps", taken());
        driver::say("rows", tables_.front().count());
        driver::say("iterations", run_.run.iterations);
        driver::say("evaluations", evaluations());
        for (const std::int64_t count : counts_) driver::say("events", count);
        for (const detail::Departure& departure : invariants_.departures()) {
            driver::say("start", departure.start);
            driver::say("largest", departure.largest);
            driver::say("last", departure.last);
            // NOTE: not each step is looked at.
            const auto steps = static_cast<double>(std::max<std::int64_t>(1, taken()));
            driver::say("drift", departure.slope() * departure.looks / steps);
        }
        driver::say("motion", motion_.mean());
        for (const double result : reductions_.results()) driver::say("reduced", result);
    }

    const TrajectoryWishes& wishes_;
    std::deque<Rows> tables_;
    std::optional<EventRows> event_rows_;
    std::vector<std::int64_t> counts_;  ///< numbers of events
    std::int64_t evaluations_ = 0;      ///< before it was resumed
    ColumnSamples samples_;
    DrivenStepper stepper_ = DrivenProblem::stepper();
    State x_ = DrivenProblem::initial();
    EventRun<double> run_;
    driver::Invariants<DrivenProblem> invariants_{stepper_, x_}, at_output_{stepper_, x_},
        at_step_{stepper_, x_};
    Reductions reductions_{wishes_.reductions};
    driver::EnergyOfMotion<DrivenProblem> motion_;
    detail::EventSteps<DrivenStepper> course_{events(), stepper_};
    CheckpointSaver saver_;
    std::chrono::steady_clock::time_point last_word_ = std::chrono::steady_clock::now(),
                                          last_look_ = last_word_;
    bool is_quick_ = false;  ///< whether what was taken at once took less than a millisecond
};

}  // namespace

int take_trajectory(const TrajectoryWishes& wishes) {
    using driver::Watch;
    heed_signals();
    Trajectory trajectory(wishes);
    if (!trajectory.run()) return 3;
    if (is_stopped()) {
        driver::say("seconds_of_step", 0.0);
        return 0;
    }
    trajectory.tell_frequencies();
    const Watch watch = wishes.looks_at_rows ? Watch::rows : Watch::steps;
    driver::say("seconds_of_step",
                driver::seconds_of_step<DrivenProblem>(watch, wishes.h, trajectory.steps()));
    return 0;
}

}  // namespace hvi::gen

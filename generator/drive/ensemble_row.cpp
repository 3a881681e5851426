// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/ensemble_row.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <driver/departure.hpp>
#include <hvi/detail/trajectories/event_steps.hpp>

#include "generator/drive/checkpoint_saver.hpp"
#include "generator/drive/driven_problem.hpp"
#include "generator/drive/reductions.hpp"
#include "generator/drive/tangents.hpp"

namespace hvi::gen {

namespace {

using State = DrivenStepper::State;

constexpr std::size_t number_of(RowStatus status) { return static_cast<std::size_t>(status); }

/// Steps that are taken between two looks for a signal.
constexpr std::int64_t at_once = 4096;

/// A signal has come.
struct RowIsStopped {};

/// NOTE: it is not copied, as its events refer to it when they count.
class Row {
public:
    Row(const RowWishes& wishes, const RowStart& start)
        : wishes_(wishes), start_(start), counts_(start.events ? start.events->size() : 0) {
        if (!is_looked_into()) return;
        static const std::vector<DrivenEvent> none;
        course_.emplace(
            counted_events(start_.events ? *start_.events : none, start_.clock, counts_), stepper_);
        if (start_.clock) course_->take_time_from([](const State& x) { return x.q.back(); });
    }

    /// Returns false where a signal asks for the end.
    [[nodiscard]] bool take() {
        if (course_) course_->begin(x_, 0, start_.h);
        reductions_.begin(0, value_now());
        while (run_.run.steps < start_.steps && run_.ending == Ending::all_steps) {
            if (is_stopped()) return false;
            advance(std::min(start_.steps - run_.run.steps, at_once));
        }
        if (course_ && run_.ending == Ending::all_steps) course_->finish(x_, start_.h, run_);
        see_end();
        return true;
    }

    [[nodiscard]] RowEnd end() const {
        RowEnd result{.status = status(), .steps = run_.run.steps, .t = run_.t};
        for (const std::size_t number : wishes_.columns) result.columns.push_back(value(number));
        if (has_energy()) result.energy_error = invariants_.departures().front().largest;
        result.events = counts_;
        result.reduced = reductions_.results();
        return result;
    }

    [[nodiscard]] double rest() const { return run_.rest; }

private:
    [[nodiscard]] bool is_looked_into() const { return start_.clock || !counts_.empty(); }

    [[nodiscard]] static bool has_energy() {
        const std::vector<std::string>& names = DrivenProblem::invariants();
        return !names.empty() && names.front() == "energy";
    }

    void advance(std::int64_t steps) {
        if (!course_) return take_steps(steps);
        for (std::int64_t k = 0; k < steps && run_.ending == Ending::all_steps; ++k) {
            const std::int64_t before = run_.run.steps;
            const double next = static_cast<double>(before + 1) * start_.h;
            course_->take(stepper_, x_, start_.h, next, run_);
            if (run_.run.steps == before) continue;
            if (!wishes_.looks_at_end) invariants_.see(stepper_, x_);
            reduce();
        }
    }

    /// Takes steps, one by one where each is reduced.
    void take_steps(std::int64_t steps) {
        const std::int64_t several = reductions_.any() ? 1 : steps;
        for (std::int64_t k = 0; k < steps && run_.ending == Ending::all_steps; k += several) {
            const Run run = wishes_.looks_at_end
                                ? stepper_.advance(x_, start_.h, several)
                                : invariants_.take(stepper_, x_, start_.h, several);
            run_.run.status = run.status;
            run_.run.steps += run.steps;
            if (!run.ok()) run_.ending = Ending::failed_step;
            run_.t = static_cast<double>(run_.run.steps) * start_.h;
            if (run.ok()) reduce();
        }
    }

    void reduce() {
        if (!reductions_.any()) return;
        const bool costs = wishes_.looks_at_end && reductions_.any_from(count_of_variables());
        if (costs) invariants_.see(stepper_, x_);
        reductions_.see(run_.t, value_now());
    }

    /// Takes the end of the run, which with an event lies within a step.
    void see_end() {
        if (start_.clock && run_.ending == Ending::event && run_.event == counts_.size())
            run_.t = start_.clock->until;
        if (is_looked_into() || wishes_.looks_at_end) invariants_.see(stepper_, x_);
        reductions_.see(run_.t, value_now());
    }

    [[nodiscard]] std::size_t status() const {
        switch (run_.ending) {
        case Ending::failed_step: return failed();
        case Ending::accumulation: return number_of(RowStatus::accumulation);
        case Ending::undefined: return number_of(RowStatus::undefined_event);
        case Ending::time_stands: return number_of(RowStatus::time_stands);
        case Ending::all_steps: return start_.clock ? number_of(RowStatus::time_stands) : 0;
        case Ending::event: break;
        }
        return number_of(RowStatus::ok);
    }

    /// Returns the number of a failed step's code; a start that is no number is called so.
    [[nodiscard]] std::size_t failed() const {
        const auto is_number = [](double value) { return std::isfinite(value); };
        const bool are_numbers = std::all_of(x_.q.begin(), x_.q.end(), is_number) &&
                                 std::all_of(x_.p.begin(), x_.p.end(), is_number);
        if (run_.run.steps == 0 && !are_numbers) return number_of(RowStatus::no_number);
        return static_cast<std::size_t>(run_.run.status.code());
    }

    [[nodiscard]] std::size_t hidden() const { return start_.clock ? 1 : 0; }
    [[nodiscard]] std::size_t count_of_variables() const {
        return x_.q.size() + x_.p.size() - 2 * hidden();
    }

    /// Returns a value by its column number. NOTE: a scaled time and its momentum are no columns.
    [[nodiscard]] double value(std::size_t number) const {
        const std::size_t n = x_.q.size() - hidden(), end = count_of_variables();
        if (number < n) return x_.q[number];
        return number < end ? x_.p[number - n] : invariants_.values()[number - end];
    }
    [[nodiscard]] Reductions::Value value_now() const {
        return [this](std::size_t number) { return value(number); };
    }

    const RowWishes& wishes_;
    const RowStart& start_;
    std::vector<std::int64_t> counts_;
    DrivenStepper stepper_ = DrivenProblem::stepper();
    State x_ = stepper_.initial();
    EventRun<double> run_;
    driver::Invariants<DrivenProblem> invariants_{stepper_, x_};
    Reductions reductions_{wishes_.reductions};
    std::optional<detail::EventSteps<DrivenStepper>> course_;
};

/// Measures the growth of a direction along a trajectory that has come to its end.
void add_growth(const RowStart& start, double rest, RowEnd& end) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    DrivenProblem::make = start.make_directions;
    const TangentWishes wishes{
        .h = start.h, .steps = end.steps, .rest = rest, .largest = true, .t = end.t};
    const bool is_there = end.status == number_of(RowStatus::ok) && end.steps > 0;
    const auto see = [](std::int64_t) {
        if (is_stopped()) throw RowIsStopped();
    };
    const LargestGrowth growth = is_there ? largest_growth(wishes, see) : LargestGrowth{};
    end.lyapunov = is_there && growth.status.ok() ? growth.lyapunov : none;
    end.megno = is_there && growth.status.ok() ? growth.megno : none;
}

}  // namespace

std::optional<RowEnd> take_row(const RowWishes& wishes, const RowStart& start) {
    DrivenProblem::make = start.make;
    Row row(wishes, start);
    if (!row.take()) return {};
    RowEnd end = row.end();
    try {
        if (wishes.growth) add_growth(start, row.rest(), end);
    } catch (const RowIsStopped&) { return {}; }
    return end;
}

}  // namespace hvi::gen

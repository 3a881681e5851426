// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/eventful_run.hpp"

#include <cstddef>
#include <memory>

#include <driver/answer.hpp>
#include <driver/cost.hpp>
#include <driver/departures.hpp>
#include <driver/measure.hpp>
#include <hvi/detail/trajectories/event_steps.hpp>

#include "generator/drive/driven_problem.hpp"

namespace hvi::gen {

namespace {

/// NOTE: it is not copied, as its events refer to it when they count.
class EventfulRun {
public:
    using State = DrivenStepper::State;

    explicit EventfulRun(const EventfulRunWishes& wishes)
        : wishes_(wishes), counts_(wishes.events.size()) {
        if (wishes_.clock) course_.take_time_from([](const State& x) { return x.q.back(); });
        course_.output_at(wishes_.times,
                          [this](const State& x, double) { outputs_.push_back(x.q.front()); });
    }

    /// Calls see(stepper, x, t) after each step and at the end of the run.
    template <class See>
    void take(See see) {
        course_.begin(x_, 0, wishes_.h);
        while (run_.run.steps < wishes_.steps && run_.ending == Ending::all_steps) {
            const double next = static_cast<double>(run_.run.steps + 1) * wishes_.h;
            course_.take(stepper_, x_, wishes_.h, next, run_);
            if (run_.ok()) see(stepper_, x_, run_.t);
        }
        if (run_.ending == Ending::all_steps) course_.finish(x_, wishes_.h, run_);
    }

    /// Whether the run has come to its intended end.
    [[nodiscard]] bool ok() const {
        return run_.ending == (wishes_.clock ? Ending::event : Ending::all_steps);
    }

    void tell() const {
        tell_ending(run_, counts_.size());
        if (wishes_.clock && run_.ending == Ending::all_steps)
            driver::say("status", "the time does not come to its end in so many steps");
        driver::say("t", run_.t);
        driver::say("steps", run_.run.steps);
        driver::say("iterations", run_.run.iterations);
        driver::say("evaluations", stepper_.evaluations());
        for (const std::int64_t count : counts_) driver::say("events", count);
        for (const double q : outputs_) driver::say("output", q);
        const State end = wishes_.clock ? without_clock(x_) : x_;
        for (const double q : end.q) driver::say("end", q);
        for (const double p : end.p) driver::say("end", p);
        if (!wishes_.clock) driver::tell_velocity<DrivenProblem>(x_, wishes_.h);
    }

private:
    const EventfulRunWishes& wishes_;
    std::vector<std::int64_t> counts_;
    std::vector<double> outputs_;
    DrivenStepper stepper_ = DrivenProblem::stepper();
    State x_ = DrivenProblem::initial();
    EventRun<double> run_;
    detail::EventSteps<DrivenStepper> course_{
        counted_events(wishes_.events, wishes_.clock, counts_), stepper_};
};

using Invariants = driver::Invariants<DrivenProblem>;

[[nodiscard]] Invariants invariants_at_start() {
    return {DrivenProblem::stepper(), DrivenProblem::initial()};
}

void sample(const EventfulRunWishes& wishes) {
    const double until =
        wishes.clock ? wishes.clock->until : wishes.h * static_cast<double>(wishes.steps);
    Invariants invariants = invariants_at_start();
    driver::DepartureSamples<DrivenProblem> samples(until, wishes.samples);
    EventfulRun run(wishes);
    run.take([&](const DrivenStepper& stepper, const DrivenStepper::State& x, double t) {
        invariants.see(stepper, x);
        samples.see(t, invariants);
    });
}

/// Returns a run for tell_time().
[[nodiscard]] auto repetition(const EventfulRunWishes& wishes) {
    return [run = std::make_unique<EventfulRun>(wishes)] {
        run->take([](const auto&, const auto&, double) {});
        return run->ok();
    };
}

}  // namespace

int take_eventful_run(const EventfulRunWishes& wishes) {
    if (wishes.samples > 0) {
        sample(wishes);
        return 0;
    }
    Invariants invariants = invariants_at_start();
    EventfulRun run(wishes);
    run.take([&](const DrivenStepper& stepper, const DrivenStepper::State& x, double) {
        invariants.see(stepper, x);
    });
    run.tell();
    for (const hvi::detail::Departure& departure : invariants.departures())
        driver::say("largest", departure.largest);
    if (run.ok() && wishes.seconds > 0)
        driver::tell_time(wishes.seconds, [&] { return repetition(wishes); });
    return 0;
}

}  // namespace hvi::gen

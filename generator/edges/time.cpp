// Extreme cases of events and scaled time.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "generator/drive/eventful_run.hpp"
#include "generator/edges/edges.hpp"
#include "generator/edges/passage.hpp"
#include "generator/edges/program.hpp"
#include "generator/edges/time_cases.hpp"
#include "generator/hamiltonian/canonical.hpp"
#include "generator/interpret/event_program.hpp"
#include "generator/simulate/eventful_run.hpp"
#include "generator/support/bar.hpp"

namespace hvi::gen {

namespace {

/// A compiled run.
struct ReadyRun {
    const RunCase* run;
    ModuleBuild module;
    std::vector<DrivenEvent> events;
    std::string method;
};

ReadyRun ready(Builds& builds, const ExactMethod& method, const RunCase& run) {
    const LoweredScene lowered = hvi::gen::lowered(run.scene);
    const SceneStepper stepper = scene_stepper(
        method.method, lowered, simulation_wishes(Solver::automatic, method.composition));
    return {&run, simulation_program(stepper).order(builds),
            driven_events(stepper.system, *lowered.written), method.name()};
}

/// NOTE: in scaled time a step takes less time than its size, or a little more. A run that takes
/// more steps than `most` does not end.
EventfulRunWishes wishes_of(const ReadyRun& ready) {
    constexpr std::int64_t most = 100'000;
    const RunCase& run = *ready.run;
    EventfulRunWishes wishes{.h = run.h, .steps = most, .events = ready.events, .times = run.times};
    if (run.scene.scale)
        wishes.clock = ScaledClock{run.until};
    else
        wishes.steps = std::llround(run.until / run.h);
    return wishes;
}

std::string text(const EventfulMeasurement& seen) {
    std::string text = fmt::format("{} at t = {:.9g}", seen.run.status, seen.t);
    if (!seen.outputs.empty()) text += fmt::format(", q = {:.9g}", fmt::join(seen.outputs, ", "));
    if (seen.events.empty())
        text += fmt::format(", the energy off by {:.2g}", seen.run.departures.front());
    if (!seen.events.empty())
        text += fmt::format(", {} event{}", fmt::join(seen.events, ", "),
                            seen.events == std::vector<std::int64_t>{1} ? "" : "s");
    return text;
}

EdgeCheck checked(const ReadyRun& ready) {
    const RunCase& run = *ready.run;
    EdgeCheck check{ready.method, run.scene.name, run.what, run.expected, "", false};
    const EventfulMeasurement seen = measure(ready.module.target(), wishes_of(ready));
    check.seen = text(seen);
    check.agrees = run.agrees(seen);
    return check;
}

/// Checks that there is no stepper, for the expected reason.
EdgeCheck checked(const ExactMethod& method, const RefusedScale& refused) {
    EdgeCheck check{method.name(), refused.scene.name,
                    refused.what,  "no run: a scale that " + refused.words,
                    "a stepper",   false};
    try {
        static_cast<void>(scene_stepper(method.method, refused.scene,
                                        simulation_wishes(Solver::automatic, method.composition)));
    } catch (const MathError& error) {
        check.seen = error.what();
        check.agrees = check.seen.find(refused.words) != std::string::npos;
    }
    return check;
}

EdgeCheck checked(const ExactMethod& method, const ClaimedJump& jump) {
    const WrittenOutScene written = unrolled(jump.scene);
    const CanonicalFinding found =
        canonical(hamiltonian_of(written), written.parameters, written.events.front());
    const auto words = [](Vanishing holds) {
        return holds == Vanishing::proved    ? "proved"
               : holds == Vanishing::refuted ? "refused"
                                             : "neither proved nor refused";
    };
    const Vanishing expected = jump.is_symplectic ? Vanishing::proved : Vanishing::refuted;
    return {method.name(),   jump.scene.name,    jump.what,
            words(expected), words(found.holds), found.holds == expected};
}

}  // namespace

EdgeChapter events_and_scales(Builds& builds, const std::vector<ExactMethod>& methods) {
    EdgeChapter chapter{
        "time",
        "Events and scaled time",
        "A scale dt/ds that is not positive where a run begins is refused; where it vanishes or is "
        "no number on the way the run ends with a status. Events are counted where the exact "
        "motion has them: not where a function is zero at the start, nor where it does not change "
        "its sign; also two in one step, two at one time, and one just at the end. Of infinitely "
        "many before a time the run ends with a status there. A jump that is said to be symplectic "
        "is proved to be, or refused. Of checkpoints the last whole one counts, with every bit.",
        {},
        {}};
    const std::vector<RefusedScale> scales = refused_scales();
    const std::vector<ClaimedJump> jumps = claimed_jumps();
    std::vector<RunCase> runs = runs_in_scaled_time();
    for (RunCase& run : runs_with_events()) runs.push_back(std::move(run));
    std::vector<ReadyRun> all;
    for (const ExactMethod& method : methods) {
        const int order = known_order(method).order;
        for (const RunCase& run : runs) {
            if (order < run.least_order) continue;
            if (auto refusal = refusal_of_general_form(method, run.scene))
                chapter.checks.push_back(*std::move(refusal));
            else
                all.push_back(ready(builds, method, run));
        }
    }
    Bar bar;
    for (std::size_t i = 0; i < all.size(); ++i) {
        bar.show(static_cast<double>(i) / static_cast<double>(all.size()),
                 "events and scaled time: " + all[i].method);
        chapter.checks.push_back(checked(all[i]));
    }
    for (const ExactMethod& method : methods) {
        for (const RefusedScale& scale : scales) chapter.checks.push_back(checked(method, scale));
        for (const ClaimedJump& jump : jumps) chapter.checks.push_back(checked(method, jump));
    }
    chapter.checks.push_back(numbers_of_checkpoint());
    chapter.checks.push_back(cut_checkpoint());
    return chapter;
}

}  // namespace hvi::gen

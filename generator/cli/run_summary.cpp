// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/run_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <utility>

#include "generator/cli/run_frequencies.hpp"
#include "generator/cli/run_wishes.hpp"
#include "generator/support/warning.hpp"

namespace hvi::gen {

namespace {

double per_step(std::int64_t count, std::int64_t steps) {
    return static_cast<double>(count) / static_cast<double>(steps);
}

/// Returns the remaining time at the end that is shorter than a step.
std::string left_out(const Steps& asked) {
    const double last = static_cast<double>(asked.count) * asked.size;
    return fmt::format("t = {:.10g} to {:.10g}, which is less than a step", last,
                       last + asked.left);
}

/// Returns the start of a quantity, its measured errors, and the knowledge about it. NOTE: a
/// quantity that is not conserved at all energies may be conserved at the run's energy, so its
/// changes are no errors. `counts_sweeps`: the steps are symplectic up to their last change alone.
std::string said_of(const Conserved& kept, const std::vector<Statement>& statements,
                    bool counts_sweeps) {
    const auto statement =
        std::find_if(statements.begin(), statements.end(),
                     [&](const Statement& each) { return each.name == kept.name; });
    const bool is_known = statement != statements.end() && statement->keeping != Keeping::unknown;
    if (is_known && statement->keeping == Keeping::not_conserved)
        return fmt::format(
            "{:.10g}; {}; on this run {} changed by {:.2e} at most, {:.2e} at the end", kept.start,
            statement->reason, kept.name, kept.largest, kept.last);
    const bool is_kept = is_known && statement->keeping == Keeping::kept;
    const char* const but =
        counts_sweeps && is_kept ? ", but for the last change of each step" : "";
    return fmt::format(
        "{:.10g}, largest error {:.2e}, at the end {:.2e}{}", kept.start, kept.largest, kept.last,
        is_known ? fmt::format("; {}{}", keeping_text(statement->keeping), but) : "");
}

/// Returns the drift of the energy, and what it is of |H|.
std::string said_of_drift(const Conserved& energy) {
    const double size = std::abs(energy.start);
    return fmt::format("{:.2e} of the energy a step{}", energy.drift,
                       size > 0 ? fmt::format(", {:.2e} of |H|", energy.drift / size) : "");
}

/// Returns `section, 12 times`.
std::string events_text(const std::string& name, std::int64_t count) {
    return fmt::format("{}, {}", name, count == 1 ? "once" : fmt::format("{} times", count));
}

std::string wanted(const WishedRun& wished) {
    return wished.clock ? fmt::format("t = {:.10g} was wanted", wished.clock->until)
                        : fmt::format("{} steps were wanted", wished.steps.count);
}

}  // namespace

std::string what_was_done(const WishedRun& wished, const Simulation& run) {
    return wished.clock ? fmt::format("{} steps at t = {:.10g}", run.steps, run.t)
                        : fmt::format("{} of {} steps", run.steps, wished.steps.count);
}

void note_left_out(const Steps& asked) {
    if (asked.left == 0) return;
    std::fputs(fmt::format("note: {}left out is {} of {:.10g}\n",
                           asked.count == 0 ? "no step is made; " : "", left_out(asked), asked.size)
                   .c_str(),
               stderr);
}

std::string summary(const WishedRun& wished, const Simulation& run, const MonitorFindings& found) {
    const RunSubject& subject = wished.subject;
    const Steps& asked = wished.steps;
    std::size_t width = std::string_view("evaluations").size();
    for (const Conserved& kept : run.conserved) width = std::max(width, kept.name.size());
    for (const Reduction& each : wished.reductions) width = std::max(width, each.name.size());
    std::string text;
    const auto line = [&](const std::string& name, const std::string& value) {
        text += fmt::format("{:<{}}  {}\n", name, width, value);
    };
    line("scene", subject.scene + (subject.description.empty() ? "" : ": " + subject.description));
    line("method", subject.title);
    const Iteration* iteration = wished.stepper.step.iteration();
    const int sweeps = iteration == nullptr ? 0 : iteration->sweeps;
    if (sweeps > 0) line("sweeps", sweeps_text(sweeps));
    line("steps", fmt::format("{} of {}{}, until t = {:.10g}", run.steps, asked.size,
                              wished.clock ? " in scaled time" : "", run.t));
    if (run.stopped_by) line("stopped", fmt::format("by the event `{}`", *run.stopped_by));
    if (asked.left != 0 && !run.stopped_by) line("left out", left_out(asked));
    if (!run.ok()) line("incomplete", fmt::format("{}: {}", wanted(wished), run.status));
    if (!wished.shortfall.empty()) line("accuracy", wished.shortfall);
    if (run.steps > 0) {
        line("time", fmt::format("{} a step, {} in all", duration(run.seconds_of_step),
                                 duration(run.seconds_of_step * static_cast<double>(run.steps))));
        if (const auto* flows = std::get_if<FlowStep>(&wished.stepper.step.form)) {
            const SmallSteps& small = wished.stepper.system.parts->small_steps;
            line("flows", fmt::format("{} a step, of {} parts of H{}", flows->flows(),
                                      flows->fractions.size(),
                                      small.exist() ? fmt::format(", {} of them in {} small steps",
                                                                  small.parts, small.count)
                                                    : ""));
        } else {
            line("evaluations", fmt::format("{:.2f} of d{}/dq a step, {} in all",
                                            per_step(run.evaluations, run.steps),
                                            subject.function_letter, run.evaluations));
        }
        if (run.iterations > 0)
            line("iterations", fmt::format("{:.2f} a step", per_step(run.iterations, run.steps)));
    }
    for (const Conserved& kept : run.conserved) {
        line(kept.name, said_of(kept, wished.statements, sweeps > 0));
        if (sweeps > 0 && kept.name == "energy") line("drift", said_of_drift(kept));
    }
    for (std::size_t i = 0; i < run.reduced.size(); ++i)
        line(wished.reductions[i].name, fmt::format("{:.10g}", run.reduced[i]));
    for (std::size_t i = 0; i < run.events.size(); ++i)
        if (const DrivenEvent& event = wished.events.events[i]; !event.event.is_kink)
            line("event", events_text(event.name, run.events[i]));
    for (const auto& [name, value] : lines_of(wished.monitors, found)) line(name, value);
    for (const auto& [name, value] : lines_of(run.frequencies)) line(name, value);
    if (!wished.not_looked_for.empty())
        line("symmetries", "not looked for: " + wished.not_looked_for);
    return text;
}

void warn_of_energy(const Simulation& run, const WishedRun& wished) {
    constexpr double much = 0.1;
    const auto& events = wished.events.events;
    const bool may_jump = std::any_of(events.begin(), events.end(),
                                      [](const DrivenEvent& each) { return bool(each.set); });
    if (may_jump) return;  // a jump may change the energy
    for (const Conserved& kept : run.conserved) {
        if (kept.name != "energy") continue;
        const double scale = std::max(std::abs(kept.start), run.energy_of_motion);
        if (scale == 0 || !(kept.largest > much * scale)) return;
        warn(
            fmt::format("the energy changes by {:.2g}, of a scale of {:.2g}: the step is too large",
                        kept.largest, scale),
            wished.help_on_steps);
    }
}

}  // namespace hvi::gen

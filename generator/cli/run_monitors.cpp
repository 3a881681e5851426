// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/run_monitors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "generator/support/bar.hpp"
#include "generator/support/pace.hpp"

namespace hvi::gen {

namespace {

/// Measurements on directions that are wished for.
TangentWishes tangents_of(const RunOptions& options) {
    return {.matrix = options.tangent,
            .largest = options.lyapunov == Exponents::largest || options.megno,
            .spectrum = options.lyapunov == Exponents::spectrum,
            .sali = options.sali};
}

std::string_view wish_for_directions(const RunOptions& options) {
    if (options.tangent) return "--tangent";
    if (options.lyapunov) return "--lyapunov";
    return options.megno ? "--megno" : "--sali";
}

bool goes_on_by_steps(const Scene& scene) {
    return !scene.kinks && std::none_of(scene.events.begin(), scene.events.end(),
                                        [](const IndexedEvent& each) { return bool(each.set); });
}

/// Throws InputError where a motion does not go on by steps of one size, without jumps.
void check_steps(const Scene& scene, std::string_view what) {
    if (scene.kinks)
        throw InputError(fmt::format("{} is not built for kinks that end steps", what),
                         scene.kinks);
    for (const IndexedEvent& event : scene.events)
        if (event.set)
            throw InputError(fmt::format("{} is not built for events that jump", what),
                             event.place);
}

/// Shows how far a measurement is.
class Shown {
public:
    Shown(const Simulation& run, const char* what) : pace_(static_cast<double>(run.steps), what) {}

    void operator()(double part) { bar_.show(part, pace_.at(part, Pace::Clock::now())); }

private:
    Bar bar_;
    Pace pace_;
};

using Lines = std::vector<std::pair<std::string, std::string>>;

void add_directions(const TangentFindings& found, Lines& lines) {
    if (found.lyapunov) lines.emplace_back("lyapunov", fmt::format("{:.6g}", *found.lyapunov));
    if (!found.exponents.empty()) {
        std::vector<std::string> all;
        for (const double value : found.exponents) all.push_back(fmt::format("{:.6g}", value));
        lines.emplace_back("lyapunov", fmt::format("{}", fmt::join(all, " ")));
    }
    if (found.megno) lines.emplace_back("megno", fmt::format("{:.6g}", *found.megno));
    if (found.sali) lines.emplace_back("sali", fmt::format("{:.3e}", *found.sali));
    if (!found.entries.empty())
        lines.emplace_back(
            "tangent",
            fmt::format("D^T J D - J is {:.1e} of the largest entry squared at most", found.form));
    if (!found.fault.empty())
        lines.emplace_back("directions", "not carried to the end: " + found.fault);
}

std::string said_of(const ShadowFindings& found) {
    if (!found.fault.empty()) return "not measured to the end: " + found.fault;
    return fmt::format("{:.15g}, largest change {:.2e}, at the end {:.2e}; differences err by some "
                       "{:.1e}",
                       found.start, found.largest, found.last, found.error);
}

}  // namespace

Monitors wished_monitors(const MethodAndScene& both, const StepperWishes& wishes,
                         const RunOptions& options, const SceneStepper& stepper) {
    Monitors result{.tangents = tangents_of(options)};
    if (result.tangents.any()) {
        const std::string_view what = wish_for_directions(options);
        check_steps(both.scene, what);
        result.tangent = tangent_stepper(both.method, both.scene, wishes, what);
    }
    if (options.shadow) {
        check_steps(both.scene, "--shadow");
        result.shadow = shadow_stepper(both.method, both.scene, wishes, "--shadow");
        result.degrees = hamiltonian_of(unrolled(both.scene)).coordinates.size();
    }
    if (stepper.system.time && goes_on_by_steps(both.scene))
        result.balance = balance_stepper(both.method, both.scene, wishes);
    return result;
}

std::string MonitorFindings::fault() const {
    if (!directions.fault.empty())
        return "directions are not carried to the end: " + directions.fault;
    if (shadow && !shadow->fault.empty())
        return "the shadow is not measured to the end: " + shadow->fault;
    if (balance && !balance->fault.empty())
        return "the balance is not measured to the end: " + balance->fault;
    return {};
}

void begin(const Monitors& monitors, Runner& runner) {
    for (const std::optional<SceneStepper>* each :
         {&monitors.tangent, &monitors.shadow, &monitors.balance})
        if (*each) runner.begin(**each);
}

MonitorFindings measured(const Monitors& monitors, const Simulation& run, double h,
                         Runner& runner) {
    MonitorFindings found;
    if (monitors.tangent && run.steps > 0) {
        TangentWishes wishes = monitors.tangents;
        wishes.h = h;
        wishes.steps = run.steps;
        Shown shown(run, "steps with directions");
        found.directions = find_tangents(runner.target(*monitors.tangent), wishes,
                                         [&](double part) { shown(part); });
    }
    if (monitors.shadow && run.steps >= ShadowWishes::fewest_steps()) {
        Shown shown(run, "steps with a shadow");
        found.shadow =
            find_shadow(runner.target(*monitors.shadow), {h, run.steps, monitors.degrees},
                        [&](double part) { shown(part); });
    }
    if (monitors.balance && run.steps > 0 && runner.can_take(*monitors.balance)) {
        Shown shown(run, "steps of the balance");
        found.balance = find_balance(runner.target(*monitors.balance), {h, run.steps},
                                     [&](double part) { shown(part); });
    }
    return found;
}

Lines lines_of(const Monitors& monitors, const MonitorFindings& found) {
    Lines lines;
    add_directions(found.directions, lines);
    if (found.shadow)
        lines.emplace_back("shadow", said_of(*found.shadow));
    else if (monitors.shadow)
        lines.emplace_back("shadow", fmt::format("not measured: that takes {} steps at least",
                                                 ShadowWishes::fewest_steps()));
    if (found.balance && found.balance->fault.empty())
        lines.emplace_back("balance",
                           fmt::format("H - H(0) - the integral of dH/dt is {:.2e} at most, {:.2e} "
                                       "at the end",
                                       found.balance->largest, found.balance->last));
    return lines;
}

}  // namespace hvi::gen

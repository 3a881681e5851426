// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/run_monitors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <complex>
#include <string_view>

#include "generator/drive/table.hpp"
#include "generator/hamiltonian/time_scale.hpp"
#include "generator/interpret/event_program.hpp"
#include "generator/module/start_parameters.hpp"
#include "generator/pipeline/directions.hpp"
#include "generator/pipeline/passes.hpp"
#include "generator/read/nearest.hpp"
#include "generator/read/parse.hpp"
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

/// Directions that go along at once. Throws InputError where there would be a stepper for each of
/// too many.
std::size_t count_of_directions(const Scene& scene, const RunOptions& options) {
    const bool takes_all = options.tangent || options.lyapunov == Exponents::spectrum;
    const std::size_t degrees = degrees_of_freedom(scene);
    if (!takes_all) return options.sali ? 2 : 1;
    if (degrees <= most_degrees_of_freedom) return 2 * degrees;
    throw InputError(
        fmt::format("{} takes two directions for each degree of freedom, of which there are {}; "
                    "it is built for at most {}",
                    options.tangent ? "--tangent" : "--lyapunov=spectrum", degrees,
                    most_degrees_of_freedom),
        scene.place, "--lyapunov, --megno and --sali take one or two directions");
}

/// Throws InputError where sums stay loops. Precondition: the scene calls no function of the
/// user's.
FindMotion motion_of_scaled_time(const Scene& scene, const SceneStepper& stepper,
                                 std::string_view what) {
    if (!stepper.system.is_written_out())
        throw InputError(fmt::format("{} is not built for a scale of the time where sums stay "
                                     "loops",
                                     what),
                         scene.scale->place,
                         "--unroll yes writes the sums out, up to 256 degrees of freedom");
    return driven_motion(stepper.system, with_time_scale(unrolled(scene)));
}

/// Throws InputError where the scene has no such parameter that is a number of a program.
void check_parameter(const Scene& scene, const SceneStepper& stepper, const std::string& name,
                     const Place& place) {
    const std::vector<SystemParameter>& parameters = stepper.system.parameters;
    const bool is_there =
        std::any_of(parameters.begin(), parameters.end(),
                    [&](const SystemParameter& parameter) { return parameter.name == name; });
    if (is_there && scene.fixed.count(name) == 0) return;
    std::vector<std::string> all;
    for (const SystemParameter& parameter : parameters)
        if (scene.fixed.count(parameter.name) == 0) all.push_back(parameter.name);
    throw InputError(fmt::format("there is no parameter `{}` to differentiate by", name), place,
                     all.empty() ? "this scene has none" : "parameters: " + listed(all));
}

/// Returns the derivative of the initial values. Throws InputError where it is not known here.
std::vector<double> start_of_sensitivity(const System& system, const std::string& parameter,
                                         const Place& place) {
    if (const auto start = start_by_parameter(system, parameter)) return *start;
    throw InputError("the derivative of these initial values is not known", place,
                     "let [initial] have numbers and functions of parameters");
}

/// Returns the stepper that carries the derivative by a parameter, and what that begins with.
Sensitivity sensitivity_of(const MethodAndScene& both, const SceneStepper& stepper,
                           const StepperWishes& wishes, const std::string& name, const Place& place,
                           std::string_view what) {
    if (!stepper.system.parts)
        return {name, sensitivity_stepper(both.method, both.scene, wishes, name, what)};
    return {name, stepper_of_parameter(stepper, both.method, both.scene, wishes, name, what),
            start_of_sensitivity(stepper.system, name, place)};
}

std::vector<Sensitivity> sensitivities_of(const MethodAndScene& both, const SceneStepper& stepper,
                                          const StepperWishes& wishes, const Given& list) {
    constexpr std::string_view what = "--sensitivity";
    std::vector<Sensitivity> result;
    check_steps(both.scene, what);
    for (const Name& each : parse_names(list)) {
        const Place place{list, each.range};
        const std::string name =
            list->text.substr(each.range.begin, each.range.end - each.range.begin);
        check_parameter(both.scene, stepper, name, place);
        const bool is_new =
            std::none_of(result.begin(), result.end(),
                         [&](const Sensitivity& other) { return other.parameter == name; });
        if (!is_new) throw InputError(fmt::format("`{}` is named twice", name), place);
        result.push_back(sensitivity_of(both, stepper, wishes, name, place, what));
    }
    return result;
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

const DrivenEvent& event_named(const std::string& name, const EventWishes& events) {
    return *std::find_if(events.events.begin(), events.events.end(),
                         [&](const DrivenEvent& event) { return event.name == name; });
}

using Lines = std::vector<std::pair<std::string, std::string>>;

/// `2.1 0.5+0.8i 0.5-0.8i 0.47`
std::string text_of(const std::vector<std::complex<double>>& numbers) {
    std::vector<std::string> all;
    for (const std::complex<double>& number : numbers)
        all.push_back(number.imag() == 0
                          ? fmt::format("{:.6g}", number.real())
                          : fmt::format("{:.6g}{:+.6g}i", number.real(), number.imag()));
    return fmt::format("{}", fmt::join(all, " "));
}

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
    if (!found.multipliers.empty()) lines.emplace_back("multipliers", text_of(found.multipliers));
    if (!found.fault.empty())
        lines.emplace_back("directions", "not carried to the end: " + found.fault);
}

/// Says what there is of the event that ended the run. NOTE: that it is not built is no fault, as
/// the matrix is there.
void add_event(const MonitorFindings& found, Lines& lines) {
    const TangentFindings& directions = found.directions;
    if (!found.event || !directions.fault.empty()) return;
    const std::string& name = found.event->name;
    if (!found.event->crossing) {
        lines.emplace_back("section", "its derivatives are not built where H is too long to be "
                                      "written out, and for rotations");
        return;
    }
    if (directions.event_time.empty()) {
        lines.emplace_back("section", fmt::format("the motion touches `{}`: its time has no "
                                                  "derivative by the start",
                                                  name));
        return;
    }
    lines.emplace_back("section", fmt::format("derivatives of the time and the state of `{}` by "
                                              "the start are in section.csv",
                                              name));
    if (!directions.return_multipliers.empty())
        lines.emplace_back("return map", text_of(directions.return_multipliers));
}

std::string said_of(const ShadowFindings& found) {
    if (!found.fault.empty()) return "not measured to the end: " + found.fault;
    return fmt::format("{:.15g}, largest change {:.2e}, at the end {:.2e}; differences err by some "
                       "{:.1e}",
                       found.start, found.largest, found.last, found.error);
}

/// NOTE: no function near H stays what it is where H depends on the time.
void add_shadow(Monitors& monitors, const MethodAndScene& both, const SceneStepper& stepper,
                const StepperWishes& wishes) {
    constexpr std::string_view what = "--shadow";
    check_steps(both.scene, what);
    if (stepper.system.time) {
        monitors.balance = balance_stepper(both.method, both.scene, wishes, what);
        return;
    }
    monitors.shadow = shadow_stepper(both.method, both.scene, wishes, what);
    monitors.degrees = hamiltonian_of(unrolled(both.scene)).coordinates.size();
}

}  // namespace

Monitors wished_monitors(const MethodAndScene& both, const SceneStepper& stepper,
                         const StepperWishes& wishes, const RunOptions& options,
                         const Runner& runner) {
    Monitors result{.tangents = tangents_of(options)};
    if (result.tangents.any()) {
        const std::string_view what = wish_for_directions(options);
        check_steps(both.scene, what);
        const std::size_t count = count_of_directions(both.scene, options);
        // NOTE: what carries directions along is compiled, as all that has rotations is.
        result.tangent =
            runner.interprets() && both.scene.rotations.texts.empty()
                ? tangent_stepper(both.method, both.scene, wishes, what)
                : stepper_of_directions(stepper, both.method, both.scene, wishes, what, count);
        if (both.scene.scale) result.motion = motion_of_scaled_time(both.scene, stepper, what);
    }
    if (options.sensitivity) {
        result.sensitivities = sensitivities_of(both, stepper, wishes, options.sensitivity);
        if (both.scene.scale)
            result.motion = motion_of_scaled_time(both.scene, stepper, "--sensitivity");
    }
    if (options.shadow) add_shadow(result, both, stepper, wishes);
    return result;
}

std::string MonitorFindings::fault() const {
    if (!directions.fault.empty())
        return "directions are not carried to the end: " + directions.fault;
    for (const TangentFindings& each : sensitivities)
        if (!each.fault.empty())
            return "the end is not differentiated by parameters: " + each.fault;
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
    for (const Sensitivity& each : monitors.sensitivities) runner.begin(each.stepper);
}

MonitorFindings measured(const Monitors& monitors, const Simulation& run, const EventWishes& events,
                         double h, Runner& runner) {
    MonitorFindings found;
    if (monitors.tangent && (run.steps > 0 || run.rest != 0 || run.stopped_by)) {
        TangentWishes wishes = monitors.tangents;
        wishes.h = h;
        wishes.steps = run.steps;
        wishes.rest = run.rest;
        wishes.t = run.t;
        wishes.motion = monitors.motion;
        if (run.stopped_by && wishes.matrix) {
            found.event = event_named(*run.stopped_by, events);
            wishes.crossing = found.event->crossing;
        }
        Shown shown(run, "steps with directions");
        found.directions = find_tangents(runner.target(*monitors.tangent), wishes,
                                         [&](double part) { shown(part); });
    }
    for (const Sensitivity& each : monitors.sensitivities) {
        Shown shown(run, "steps with derivatives by a parameter");
        found.sensitivities.push_back(find_tangents(runner.target(each.stepper),
                                                    {.h = h,
                                                     .steps = run.steps,
                                                     .rest = run.rest,
                                                     .own = true,
                                                     .start = each.start,
                                                     .motion = monitors.motion},
                                                    [&](double part) { shown(part); }));
    }
    if (monitors.shadow && run.steps >= ShadowWishes::fewest_steps()) {
        Shown shown(run, "steps with a shadow");
        found.shadow =
            find_shadow(runner.target(*monitors.shadow), {h, run.steps, monitors.degrees},
                        [&](double part) { shown(part); });
    }
    if (monitors.balance && run.steps > 0) {
        Shown shown(run, "steps of the balance");
        found.balance = find_balance(runner.target(*monitors.balance), {h, run.steps},
                                     [&](double part) { shown(part); });
    }
    return found;
}

std::string table_of_sensitivities(const Monitors& monitors, const MonitorFindings& found,
                                   const std::vector<NameBox>& names) {
    if (monitors.sensitivities.empty()) return "";
    std::string text = "parameter";
    const std::size_t count = found.sensitivities.front().own.size();
    for (std::size_t k = 0; k < count; ++k) text += "," + text_of_cell(name_at(names, k));
    for (std::size_t k = 0; k < monitors.sensitivities.size(); ++k) {
        text += "\n" + monitors.sensitivities[k].parameter;
        for (const double value : found.sensitivities[k].own) text += fmt::format(",{}", value);
    }
    return text + "\n";
}

std::string section_table(const TangentFindings& found, const std::vector<NameBox>& names) {
    const std::size_t count = found.event_time.size();
    if (count == 0) return "";
    std::string text = "of";
    for (std::size_t k = 0; k < count; ++k) text += "," + text_of_cell(name_at(names, k));
    text += fmt::format("\nt,{}\n", fmt::join(found.event_time, ","));
    for (std::size_t row = 0; row < count; ++row) {
        const auto begin = found.event_state.begin() + static_cast<std::ptrdiff_t>(row * count);
        text += fmt::format("{},{}\n", text_of_cell(name_at(names, row)),
                            fmt::join(begin, begin + static_cast<std::ptrdiff_t>(count), ","));
    }
    return text;
}

Lines lines_of(const Monitors& monitors, const MonitorFindings& found) {
    Lines lines;
    add_directions(found.directions, lines);
    add_event(found, lines);
    if (!monitors.sensitivities.empty())
        lines.emplace_back("sensitivity",
                           fmt::format("derivatives by {} parameter{} are in sensitivity.csv",
                                       monitors.sensitivities.size(),
                                       monitors.sensitivities.size() == 1 ? "" : "s"));
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

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/simulate/simulation.hpp"

#include <fmt/format.h>

#include <charconv>
#include <map>
#include <string_view>
#include <utility>

#include "generator/emit/text.hpp"
#include "generator/support/child.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

constexpr const char* header_name = "stepper.hpp";

std::string lines(const std::vector<std::string>& items) {
    return fmt::format("{}", fmt::join(items, ",\n"));
}

std::string quoted(const std::vector<std::string>& names) {
    std::vector<std::string> items;
    for (const std::string& name : names) items.push_back('"' + name + '"');
    return lines(items);
}

/// The members of the stepper that compute what a run is to keep. Where H depends on the time the
/// energy is among the columns too, but nothing is said of its departure.
std::string values(const LoweredScene& lowered) {
    std::vector<std::string> items;
    for (const std::string& name : conserved_names(lowered))
        items.push_back(fmt::format("stepper.{}(x)", name));
    return lines(items);
}

template <class Number>
Number number(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    HVI_CHECK(error == std::errc{} && end == text.data() + text.size());
    return value;
}

/// Reads what the program says: see src/driver/trajectory.hpp.
class Listener {
public:
    Listener(std::vector<std::string> names, const std::function<void(double)>& on_progress)
        : names_(std::move(names)), on_progress_(on_progress) {}

    void hear(std::string_view line) {
        const std::size_t blank = line.find(' ');
        HVI_CHECK(blank != std::string_view::npos);
        const std::string_view key = line.substr(0, blank), value = line.substr(blank + 1);
        if (key == "progress") return on_progress_(number<double>(value));
        if (key == "status") result_.status = value;
        if (key == "steps") result_.steps = number<std::int64_t>(value);
        if (key == "rows") result_.rows = number<std::int64_t>(value);
        if (key == "iterations") result_.iterations = number<std::int64_t>(value);
        if (key == "evaluations") result_.evaluations = number<std::int64_t>(value);
        if (key == "seconds_of_step") result_.seconds_of_step = number<double>(value);
        if (key == "start") {
            HVI_CHECK(result_.conserved.size() < names_.size());
            result_.conserved.push_back({names_[result_.conserved.size()], number<double>(value)});
        }
        if (key == "largest") result_.conserved.back().largest = number<double>(value);
        if (key == "last") result_.conserved.back().last = number<double>(value);
    }

    [[nodiscard]] Simulation result() && {
        HVI_CHECK(!result_.status.empty() && result_.conserved.size() == names_.size());
        return std::move(result_);
    }

private:
    std::vector<std::string> names_;
    const std::function<void(double)>& on_progress_;
    Simulation result_;
};

}  // namespace

std::vector<std::string> conserved_names(const LoweredScene& lowered) {
    std::vector<std::string> names;
    if (!lowered.system.time) names.emplace_back("energy");
    for (const NamedExpression& invariant : lowered.scene.invariants)
        names.push_back(invariant.name);
    return names;
}

void check_simulation(const SceneStepper& stepper) {
    if (!stepper.scheme.from_parameter) return;
    const std::string& name = stepper.scheme.from_parameter->numbers.parameter;
    for (const Parameter& parameter : stepper.lowered.scene.parameters)
        if (parameter.name == name) return;
    throw InputError(fmt::format("the parameter `{}` of the method has no value", name), {},
                     fmt::format("give it one: --param {}=1", name));
}

StepperWishes simulation_wishes(Solver solver) {
    return {.solver = solver, .energy = true, .invariants = true, .evaluations = true};
}

ProgramText simulation_program(const SceneStepper& stepper) {
    const std::vector<std::string> conserved = conserved_names(stepper.lowered);
    return {fill("trajectory.cpp.in",
                 {{"header", header_name},
                  {"stepper", stepper.class_name},
                  {"variables", quoted(variables(stepper.lowered.scene.hamiltonian))},
                  {"invariants", quoted(conserved)},
                  {"count", std::to_string(conserved.size())},
                  {"values", values(stepper.lowered)}}),
            {{header_name, stepper.header}}};
}

Simulation run_simulation(const std::filesystem::path& program, const SceneStepper& stepper,
                          const Steps& steps, std::int64_t every,
                          const std::filesystem::path& table,
                          const std::function<void(double)>& on_progress) {
    Listener listener(conserved_names(stepper.lowered), on_progress);
    const ChildResult ended =
        run_child({program.string(), fmt::format("{}", steps.size), std::to_string(steps.count),
                   std::to_string(every), table.string()},
                  ".", [&](std::string_view line) { listener.hear(line); });
    if (ended.status == 3) throw EnvironmentError("cannot write " + table.string());
    if (ended.status > 128)
        throw EnvironmentError(
            fmt::format("the compiled program was ended by signal {}", ended.status - 128));
    HVI_CHECK(ended.ok());
    return std::move(listener).result();
}

}  // namespace hvi::gen

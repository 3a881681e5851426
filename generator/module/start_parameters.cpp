// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/module/start_parameters.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>

#include "generator/emit/system/scene_code.hpp"
#include "generator/graph/written.hpp"
#include "generator/lower/taken_names.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

bool depends_on_parameters_alone(const Graph& graph, const Scaled& value) {
    return (graph.at(value.node).roles & ~static_cast<Roles>(Role::parameter)) == 0;
}

/// Returns the starting values of a family that depend on parameters only.
std::vector<Scaled*> places(const Graph& graph, SystemStart& start) {
    std::vector<Scaled*> result;
    const auto add = [&](Scaled& value) {
        if (depends_on_parameters_alone(graph, value)) { result.push_back(&value); }
    };
    if (auto* rule = std::get_if<SystemStart::Rule>(&start.values)) { add(rule->value); }
    if (auto* list = std::get_if<SystemStart::List>(&start.values)) {
        for (Scaled& value : list->values) { add(value); }
    }
    if (auto* points = std::get_if<SystemStart::Points>(&start.values)) {
        for (Scaled& value : points->values) { add(value); }
    }
    return result;
}

std::vector<Scaled*> places(System& system) {
    std::vector<Scaled*> result;
    for (SystemStart& start : system.initial) {
        const std::vector<Scaled*> more = places(system.graph, start);
        result.insert(result.end(), more.begin(), more.end());
    }
    return result;
}

/// Returns the double nearest to a value; empty where it has none, or where it cannot be computed
/// here.
std::optional<double> number(const Graph& graph, const Scaled& value,
                             const std::map<std::string, Expression>& parameters) {
    // NOTE: both are exact, and the quotient is rounded once.
    if (graph.is_number(value)) {
        return static_cast<double>(value.factor.above) / static_cast<double>(value.factor.below);
    }
    const std::optional<Expression> expression = written(graph, value);
    if (!expression) { return {}; }
    try {
        constexpr std::size_t of_double = 1;
        const std::optional<Dyadic> rounded =
            rounded_value(replaced(*expression, parameters))[of_double];
        if (!rounded || !std::isfinite(rounded->to_double())) { return {}; }
        return rounded->to_double();
    } catch (const InputError&) { return {}; } catch (const MathError&) {
        return {};
    }
}

std::optional<std::vector<double>> numbers(const System& system,
                                           const std::vector<Scaled*>& values) {
    std::map<std::string, Expression> parameters;
    for (const SystemParameter& parameter : system.parameters) {
        parameters.emplace(parameter.name, parameter.value);
    }
    std::vector<double> result;
    for (const Scaled* value : values) {
        const std::optional<double> rounded = number(system.graph, *value, parameters);
        if (!rounded) { return {}; }
        result.push_back(*rounded);
    }
    return result;
}

}  // namespace

StartParameters with_start_parameters(System system) {
    constexpr std::size_t most = 2000;
    const std::vector<Scaled*> starts = places(system);
    if (starts.size() > most) { return {std::move(system), {}}; }
    std::optional<std::vector<double>> values = numbers(system, starts);
    if (!values) { return {std::move(system), {}}; }
    std::set<std::string> taken = taken_names(system);
    const std::string name = new_name("start", taken);
    for (std::size_t k = 0; k < starts.size(); ++k) {
        const std::string of_value = fmt::format("{}[{}]", name, k + 1);
        *starts[k] = system.graph.input(of_value, Role::parameter);
        system.parameters.push_back({of_value, {}, starts[k]->node});
    }
    return {std::move(system), std::move(*values)};
}

}  // namespace hvi::gen

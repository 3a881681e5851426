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
#include "generator/lower/tangent.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

/// Starting values of a family, and the numbers of their elements in the family.
struct Places {
    std::vector<Scaled*> values;
    std::vector<std::size_t> elements;
};

bool depends_on_parameters_alone(const Graph& graph, const Scaled& value) {
    return (graph.at(value.node).roles & ~static_cast<Roles>(Role::parameter)) == 0;
}

/// Returns the starting values of a family that depend on parameters only.
Places places(const Graph& graph, SystemStart& start) {
    Places result;
    const auto add = [&](Scaled& value, std::size_t element) {
        if (!depends_on_parameters_alone(graph, value)) { return; }
        result.values.push_back(&value);
        result.elements.push_back(element);
    };
    const auto add_all = [&](std::vector<Scaled>& values) {
        for (std::size_t k = 0; k < values.size(); ++k) { add(values[k], k); }
    };
    if (auto* rule = std::get_if<SystemStart::Rule>(&start.values)) { add(rule->value, 0); }
    if (auto* list = std::get_if<SystemStart::List>(&start.values)) { add_all(list->values); }
    if (auto* points = std::get_if<SystemStart::Points>(&start.values)) { add_all(points->values); }
    return result;
}

std::vector<Scaled*> places(System& system) {
    std::vector<Scaled*> result;
    for (SystemStart& start : system.initial) {
        const Places more = places(system.graph, start);
        result.insert(result.end(), more.values.begin(), more.values.end());
    }
    return result;
}

/// Returns the name of an element of a family, by their numbers. Precondition: the system is
/// written out.
std::string name_of_element(const System& system, std::size_t family, std::size_t element) {
    const std::size_t n = system.coordinates.size();
    const FamilyKind kind = family < n ? FamilyKind::coordinate : FamilyKind::conjugate;
    for (const Access& access : system.accesses) {
        const bool is_it =
            access.kind == kind && access.family == family % n && access.component == element;
        if (is_it) { return system.graph.at(access.node).name; }
    }
    HVI_CHECK(false);
    return "";
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

std::optional<double>
StartValue::number(const Graph& graph, const std::map<std::string, Expression>& parameters) const {
    return hvi::gen::number(graph, value, parameters);
}

std::vector<StartValue> start_values(const System& system) {
    System copy = system;
    std::vector<StartValue> result;
    for (std::size_t family = 0; family < copy.initial.size(); ++family) {
        const Places found = places(copy.graph, copy.initial[family]);
        for (std::size_t k = 0; k < found.values.size(); ++k) {
            StartValue start{"", *found.values[k]};
            if (copy.is_written_out())
                start.variable = name_of_element(copy, family, found.elements[k]);
            result.push_back(std::move(start));
        }
    }
    return result;
}

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

std::optional<std::vector<double>> start_by_parameter(const System& system,
                                                      const std::string& parameter) {
    const std::size_t n = system.degrees_of_freedom();
    std::map<std::string, Expression> parameters;
    for (const SystemParameter& each : system.parameters) {
        parameters.emplace(each.name, each.value);
    }
    const System along = with_sensitivity(system, parameter);
    const std::vector<StartValue> all = start_values(along);  // of (q, dq), (dp, p)
    if (all.size() != 4 * n) { return {}; }
    std::vector<double> result;
    for (std::size_t k = n; k < 3 * n; ++k) {
        const std::optional<double> value = all[k].number(along.graph, parameters);
        if (!value) { return {}; }
        result.push_back(*value);
    }
    return result;
}

}  // namespace hvi::gen

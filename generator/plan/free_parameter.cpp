// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/free_parameter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

std::string text(const ZeroPlaces& zeros, const std::string& parameter) {
    if (!zeros.family.empty()) { return zeros.family; }
    std::string list;
    const auto mirrored = [&](double place) {
        return std::any_of(zeros.places.begin(), zeros.places.end(), [&](double other) {
            return std::abs(place + other) < 1e-6 * std::abs(place);
        });
    };
    for (const double place : zeros.places) {
        if (place < 0 && mirrored(place)) { continue; }
        list +=
            fmt::format("{}{}{:.6g}", list.empty() ? "" : ", ", mirrored(place) ? "+-" : "", place);
    }
    return fmt::format("{} = {} (all of size below {:.0f})", parameter, list,
                       ParametricNumbers::most_printed);
}

/// Notes the parameter values at which there is no method.
void note_zeros(Step& step) {
    const ParametricNumbers& numbers = step.from_parameter->numbers;
    const auto what = [](Zero zero) {
        return zero == Zero::pole ? "coefficients are infinite there" : "a weight is zero there";
    };
    if (numbers.at_zero != Zero::harmless) {
        step.decisions.push_back(
            {fmt::format("no method at {} = 0", numbers.parameter), what(numbers.at_zero)});
    }
    for (const ZeroPlaces& zeros : numbers.zeros) {
        step.decisions.push_back(
            {"no method at " + text(zeros, numbers.parameter), what(zeros.zero)});
    }
}

bool depend(const NumberVector& numbers) {
    return std::any_of(numbers.begin(), numbers.end(),
                       [](const Number& number) { return number.has_parameters(); });
}

/// Returns the places among `others` of the numbers of a step that depend on a parameter.
FromParameter places(const Step& step, const Tableau& tableau, NumberVector& others) {
    const auto other = [&](const Number& number) {
        others.push_back(number);
        return others.size() - 1;
    };
    FromParameter from;
    const auto weights = [&](const std::vector<StageValue>& values, auto& places) {
        for (const StageValue& value : values) {
            auto& place = places.emplace_back();
            const bool merged = value.stages.size() > 1;
            if (merged && value.weight.has_parameters()) { place = other(value.weight); }
        }
    };
    weights(step.positions, from.positions);
    weights(step.momenta, from.momenta);
    for (std::size_t i = 0; i < step.positions.size(); ++i) {
        auto& row = from.m.emplace_back(step.momenta.size());
        for (std::size_t j = 0; j < step.momenta.size(); ++j) {
            if (!step.m[i][j].has_parameters()) { continue; }
            const std::size_t column = step.momenta[j].stages.front();
            const Number& a = tableau.A[step.positions[i].stages.front()][column];
            row[j] = FromParameter::Ratio{other(a), column};
        }
    }
    for (const Number& c : step.c) {
        auto& place = from.c.emplace_back();
        if (c.has_parameters()) { place = other(c); }
    }
    return from;
}

}  // namespace

void check_no_parameter(const OneStepMethod& method) {
    const std::vector<std::string>& parameters = std::visit(
        [](const auto& base) -> const std::vector<std::string>& { return base.parameters; },
        method.base);
    if (parameters.empty()) { return; }
    throw InputError(
        "steps of the general Galerkin form, and of Lagrangians, with a free parameter "
        "are not built",
        method.place, "give it a value: --param " + parameters.front() + "=1");
}

void set_from_parameter(Step& step, const Tableau& tableau, const std::optional<Place>& method) {
    if (!depend(tableau.b) && std::none_of(step.m.begin(), step.m.end(), depend)) {
        for (const std::string& name : tableau.parameters) {
            step.decisions.push_back({"no argument for " + name, "it cancels"});
        }
        return;
    }
    NumberVector others;
    FromParameter from = places(step, tableau, others);
    try {
        from.numbers = parametric(tableau.b, others);
    } catch (const InputError& error) {
        if (error.place()) { throw; }
        throw InputError(error.what(), method, error.help());
    }
    step.from_parameter = std::move(from);
    note_zeros(step);
}

}  // namespace hvi::gen

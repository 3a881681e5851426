// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/module/driven.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <variant>

#include "generator/emit/steps/along.hpp"
#include "generator/emit/steps/emit.hpp"
#include "generator/emit/system/scene_code.hpp"
#include "generator/module/start_parameters.hpp"
#include "generator/module/stepper_part.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

/// Whether a module takes the values of all lists, as far as the command line has room. NOTE: it
/// takes all or none, and files it reads itself.
bool are_lists_numbers(const System& system) {
    constexpr std::size_t most = 2000;
    std::size_t count = 0;
    for (const SystemTable& table : system.tables) {
        const auto* values = std::get_if<std::vector<Expression>>(&table.values);
        if (values == nullptr) { return false; }
        count += values->size();
    }
    return count <= most;
}

/// The system with other values in their places.
System without_values(System system) {
    for (SystemParameter& parameter : system.parameters) { parameter.value = {}; }
    for (SystemSize& size : system.sizes) { size.value = 1; }
    if (are_lists_numbers(system)) {
        for (SystemTable& table : system.tables) {
            for (Expression& value : std::get<std::vector<Expression>>(table.values)) {
                value = {};
            }
        }
    }
    return system;
}

/// NOTE: what stands above is for people who read the header.
std::string code_of(const std::string& header) {
    return header.substr(header.find("#pragma once"));
}

/// Values of lists, one after the other; none where some of them stay in the source.
std::vector<double> values_of_lists(const System& system) {
    std::vector<double> result;
    if (!are_lists_numbers(system)) { return result; }
    for (const SystemTable& table : system.tables) {
        for (const Expression& value : std::get<std::vector<Expression>>(table.values)) {
            result.push_back(value_of_number(value));
        }
    }
    return result;
}

/// The text of the class, for a compiler.
std::string class_text(const SceneStepper& stepper, const System& system, SeldomSolvers seldom) {
    const std::string header =
        emit(stepper.method, stepper.step,
             {.class_name = stepper.class_name,
              .command = "",
              .system = &system,
              .wishes = stepper.members,
              .evaluations = stepper.evaluations ? &*stepper.evaluations : nullptr,
              .seldom = seldom});
    return include_of_along(stepper.step) + without_once(code_of(header));
}

/// NOTE: g++ takes three quarters of its time for <cmath> to read Bessel functions and the like,
/// which steppers do not call. A header of the user's may.
std::string skipped(const SceneStepper& stepper) {
    return stepper.own_headers.empty() ? "#define _GLIBCXX_BITS_SPECFUN_H 1" : "";
}

/// Parts of a module's text that depend on the kind of its steps.
struct ModuleKind {
    std::string include;    ///< before the header of the stepper
    std::string driven;     ///< the header with the functions of the module
    std::string face;       ///< the class that has them
    std::string functions;  ///< their type and symbol
    std::string stepper;    ///< the class of the stepper
};

/// Returns the statements that read parameters, of which one may be what dual numbers are
/// differentiated by. NOTE: they may return.
std::string reading_of(const SceneStepper& stepper, const System& system,
                       const std::string& reading) {
    if (stepper.differentiated_by.empty()) { return reading; }
    const NodeNames names = parameter_names(system);
    const auto found = std::find_if(
        system.parameters.begin(), system.parameters.end(),
        [&](const SystemParameter& each) { return each.name == stepper.differentiated_by; });
    HVI_CHECK(found != system.parameters.end());
    return fmt::format("[&] {{\n{}\n}}();\n{}.by[0] = 1;", reading, names.at(found->node));
}

ModuleKind kind_of(const SceneStepper& stepper) {
    if (stepper.step.layout == Layout::trajectories) {
        const bool grows = stepper.has_direction;
        return {"",
                grows ? "hvi/detail/module/lane_growth.hpp" : "hvi/detail/module/rows_in_lanes.hpp",
                grows ? "hvi::detail::GrowingRowsInLanes" : "hvi::detail::RowsInLanes",
                "RowFunctions hvi_rows", stepper.class_name};
    }
    ModuleKind kind{"", "hvi/detail/module/driven.hpp", "hvi::detail::Driven",
                    "DrivenFunctions hvi_scene", stepper.class_name};
    if (stepper.step.dual_parts != 0) {
        const std::optional<HamiltonianParts>& parts = stepper.system.parts;
        kind.include = "#include <driver/dual.hpp>";
        if (parts && calls(*parts, RuntimeFunction::orbits))
            kind.include += "\n#include <hvi/detail/stages/orbits_in_duals.hpp>";
        kind.driven = "driver/carried_in_duals.hpp";
        kind.stepper = fmt::format("Basic{}<hvi::driver::Dual<{}>>", stepper.class_name,
                                   stepper.step.dual_parts);
    }
    return kind;
}

}  // namespace

DrivenSystem driven_system(const System& system) {
    StartParameters start = with_start_parameters(system);
    std::vector<double> numbers = values_of_numbers(system);
    const std::vector<double> lists = values_of_lists(system);
    numbers.insert(numbers.end(), start.values.begin(), start.values.end());
    numbers.insert(numbers.end(), lists.begin(), lists.end());
    return {without_values(std::move(start.system)), std::move(numbers)};
}

DrivenModule driven_module(const SceneStepper& stepper) {
    DrivenSystem driven = driven_system(stepper.system);
    const System& system = driven.system;
    DrivenModule module;
    module.numbers = std::move(driven.numbers);
    const ModuleKind kind = kind_of(stepper);
    const std::string skip = skipped(stepper);
    const auto source = [&](SeldomSolvers seldom) {
        Holes holes = stepper_holes(system, kind.stepper, class_text(stepper, system, seldom));
        holes["set"] = reading_of(stepper, system, holes["set"]);
        holes.merge(Holes{{"skip", skip},
                          {"numbers", kind.include},
                          {"driven", kind.driven},
                          {"face", kind.face},
                          {"functions", kind.functions}});
        return fill("driven.cpp.in", holes);
    };
    if (!has_seldom_solvers(stepper.step)) {
        module.source = source(SeldomSolvers::within);
        return module;
    }
    module.source = source(SeldomSolvers::apart);
    module.solvers =
        fill("solvers.cpp.in", {{"skip", skip},
                                {"numbers", kind.include},
                                {"stepper", class_text(stepper, system, SeldomSolvers::alone)},
                                {"class", kind.stepper}});
    return module;
}

}  // namespace hvi::gen

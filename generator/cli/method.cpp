// Reading METHOD and its parameters.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "generator/read/method.hpp"
#include "generator/read/names.hpp"

namespace hvi::gen {

namespace {

Method read_method(const MethodOptions& options) {
    if (options.name) return named_method(options.name);
    if (options.file) return method_from_file(options.file->text);
    return method_from_text(options.basis, options.nodes, options.weights);
}

/// Reads each `--param`.
std::vector<Parameter> parameters_in(const std::vector<Given>& assignments) {
    std::vector<Parameter> parameters;
    std::set<std::string> names;
    for (const Given& assignment : assignments) {
        parameters.push_back(parse_parameter(assignment));
        if (!names.insert(parameters.back().name).second)
            throw InputError("`" + parameters.back().name + "` is given a value twice",
                             parameters.back().place);
    }
    return parameters;
}

}  // namespace

Method method_of(const MethodOptions& options) {
    Method method = read_method(options);
    for (Parameter& parameter : parameters_in(options.parameters))
        set_parameter(method, std::move(parameter));
    return method;
}

Coefficients coefficients_of(const std::filesystem::path& file, const MethodOptions& options) {
    Coefficients coefficients = coefficients_from_file(file);
    for (Parameter& parameter : parameters_in(options.parameters))
        set_parameter(coefficients, std::move(parameter));
    return coefficients;
}

namespace {

/// Reads a scene with the values of sizes and of other parameters that are given.
Scene scene_in(const SystemOptions& system, const std::vector<Parameter>& values) {
    if (system.scene) {
        Scene scene = find_scene(system.scene, values);
        if (system.split) {
            scene.split = *system.split;
            scene.origin += fmt::format(" --split {}", word_of(*system.split));
        }
        return scene;
    }
    return scene_from_hamiltonian(system.hamiltonian, system.coordinates, system.momenta, values);
}

/// Reads the method. `of_scene` is the name that a scene has for one, or null.
Method method_for(const MethodOptions& options, const std::shared_ptr<const Source>& of_scene,
                  const std::optional<Place>& place) {
    const bool is_given = options.name || options.basis || options.file;
    if (is_given) return read_method(options);
    if (of_scene == nullptr)
        throw InputError("no method is given, and the scene names none", place,
                         "for example --method gauss:4");
    return named_method(of_scene);
}

/// Returns the first place of a symbol, with an index or without.
Place first_place(const IndexedExpression& function, std::string_view name) {
    std::optional<Range> range;
    walk(function.written, [&](const Expression& part) {
        const bool is_name =
            part.kind == Expression::Kind::symbol || part.kind == Expression::Kind::element;
        if (!range && is_name && part.name == name) range = part.range;
        return !range;
    });
    return {function.source, range.value_or(Range{})};
}

bool has_parameter(const Method& method, const std::string& name) {
    const std::vector<std::string> names = parameter_names(method);
    return std::find(names.begin(), names.end(), name) != names.end();
}

void check_values(const Scene& scene) {
    for (const IndexedValue& parameter : scene.parameters) {
        if (!std::holds_alternative<NoValue>(parameter.value)) continue;
        throw InputError("the parameter `" + parameter.name + "` has no value",
                         first_place(scene.function, without_index(parameter.name)),
                         "give the value that it has where a program gives none: --param " +
                             parameter.name + "=1");
    }
}

}  // namespace

MethodAndHamiltonian read_hamiltonian(const MethodOptions& options, const SystemOptions& system) {
    const std::vector<Parameter> parameters = parameters_in(options.parameters);
    MethodAndHamiltonian both{
        read_method(options),
        hamiltonian_from_text(system.hamiltonian, system.coordinates, system.momenta, parameters)};
    check_together(both.method, both.hamiltonian);
    for (const Parameter& parameter : parameters)
        set_parameter(both.method, both.hamiltonian, parameter);
    return both;
}

MethodAndScene read_scene(const MethodOptions& options, const SystemOptions& system) {
    const std::vector<Parameter> parameters = parameters_in(options.parameters);
    Scene scene = scene_in(system, parameters);
    Method method = method_for(options, scene.run.method, scene.place);
    check_together(method, scene);
    for (const Parameter& parameter : parameters) {
        if (!has_parameter(method, parameter.name)) scene.origin += parameter_option(parameter);
        set_parameter(method, scene, parameter);
    }
    check_values(scene);
    return {std::move(method), std::move(scene), parameters};
}

Scene read_scene_alone(const std::vector<Given>& assignments, const SystemOptions& system) {
    const std::vector<Parameter> parameters = parameters_in(assignments);
    Scene scene = scene_in(system, parameters);
    Method none;
    for (const Parameter& parameter : parameters) set_parameter(none, scene, parameter);
    return scene;
}

MethodAndScene read_both(const MethodOptions& options, const SystemOptions& system) {
    const std::vector<Parameter> parameters = parameters_in(options.parameters);
    MethodAndScene both{read_method(options), scene_in(system, parameters), parameters};
    check_together(both.method, both.scene);
    for (const Parameter& parameter : parameters) {
        both.scene.fixed.insert(parameter.name);
        set_parameter(both.method, both.scene, parameter);
    }
    return both;
}

}  // namespace hvi::gen

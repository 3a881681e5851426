// Reading METHOD and its parameters.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "generator/options/option_table.hpp"
#include "generator/pipeline/any_size.hpp"
#include "generator/read/method.hpp"
#include "generator/read/names.hpp"
#include "generator/read/no_loops.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

namespace {

Method read_method(const MethodOptions& options) {
    if (options.name) return named_method(options.name);
    if (options.file) return method_from_file(options.file->text);
    return method_from_text(options.basis, options.nodes, options.weights);
}

/// With the values of sizes alone.
Hamiltonian read_hamiltonian(const SystemOptions& options, const std::vector<Parameter>& values) {
    return hamiltonian_from_text(options.hamiltonian, options.coordinates, options.momenta, values);
}

/// What each `--param` says.
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

/// A scene that is a Hamiltonian and nothing else. Its parameters have no values yet.
WrittenOutScene scene_of(Hamiltonian hamiltonian) {
    WrittenOutScene scene;
    for (const std::string& name : parameter_names(hamiltonian)) {
        scene.parameters.push_back({name, {}, {}});
    }
    scene.mechanics = std::move(hamiltonian);
    return scene;
}

/// `of_scene`: the name that a scene has for one, or null.
Method method_for(const MethodOptions& options, const std::shared_ptr<const Source>& of_scene,
                  const std::optional<Place>& place) {
    const bool is_given = options.name || options.basis || options.file;
    if (is_given) return read_method(options);
    if (of_scene == nullptr)
        throw InputError("no method is given, and the scene names none", place,
                         "for example --method gauss:4");
    return named_method(of_scene);
}

/// Where a symbol stands first.
Place first_place(const MechanicalFunction& function, const std::string& name) {
    std::optional<Range> range;
    walk(function.expression, [&](const Expression& part) {
        if (!range && part.kind == Expression::Kind::symbol && part.name == name)
            range = part.range;
        return !range;
    });
    return {function.source, range.value_or(Range{})};
}

bool has_parameter(const Method& method, const std::string& name) {
    const std::vector<std::string> names = parameter_names(method);
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// With the method that is given, or that of the scene.
MethodAndScene completed(WrittenOutScene scene, const MethodOptions& options) {
    Method method = method_for(options, scene.run.method, scene.place);
    check_together(method, scene);
    std::string defaults;
    for (Parameter& parameter : parameters_in(options.parameters)) {
        if (!has_parameter(method, parameter.name)) defaults += parameter_option(parameter);
        set_parameter(method, scene, std::move(parameter));
    }
    function_of(scene).origin += defaults;
    for (const Parameter& parameter : scene.parameters) {
        if (parameter.place.source == nullptr)
            throw InputError("the parameter `" + parameter.name + "` has no value",
                             first_place(function_of(scene), parameter.name),
                             "give the value that it has where a program gives none: --param " +
                                 parameter.name + "=1");
    }
    // What the method was derived with is fixed; the others are defaults.
    const auto is_fixed = [&](const Parameter& parameter) {
        return has_parameter(method, parameter.name);
    };
    const auto is_default = [&](const Parameter& parameter) { return !is_fixed(parameter); };
    std::erase_if(function_of(scene).parameters, is_default);
    return {std::move(method), std::move(scene)};
}

/// Completes a scene whose sums stay loops.
MethodAndLargeScene completed(Scene scene, const Given& name, const MethodOptions& options) {
    Method method = method_for(options, scene.run.method, whole(name));
    for (Parameter& parameter : parameters_in(options.parameters)) {
        const bool is_of_scene = assign(scene, parameter);
        const bool is_of_method = has_parameter(method, parameter.name);
        if (!is_of_scene && !is_of_method)
            throw InputError(fmt::format("neither the method nor the scene has a parameter `{}`",
                                         parameter.name),
                             parameter.place);
        if (!is_of_method) scene.origin += parameter_option(parameter);
        if (is_of_scene && is_of_method) scene.fixed.insert(parameter.name);
        if (is_of_method) set_parameter(method, std::move(parameter));
    }
    return {std::move(method), std::move(scene)};
}

}  // namespace

MethodAndSystem read_system(const MethodOptions& options, const SystemOptions& system) {
    Method method = read_method(options);
    std::vector<Parameter> parameters = parameters_in(options.parameters);
    if (!system.scene) {
        Hamiltonian hamiltonian = read_hamiltonian(system, parameters);
        check_together(method, hamiltonian);
        for (Parameter& parameter : parameters)
            set_parameter(method, hamiltonian, std::move(parameter));
        return {std::move(method), std::move(hamiltonian)};
    }
    auto found = find_scene_of_any_size(system.scene, parameters, system.sums).scene;
    if (auto* large = std::get_if<Scene>(&found)) {
        MethodAndLargeScene both = completed(std::move(*large), system.scene, options);
        both.scene.origin += options_for({.unroll = system.sums.choice});
        return {std::move(both.method), LargeSystem{std::move(both.scene), std::move(parameters)}};
    }
    WrittenOutScene scene = std::get<WrittenOutScene>(std::move(found));
    function_of(scene).origin += options_for({.unroll = system.sums.choice});
    refuse_rotations(function_of(scene), "`scheme`");
    check_together(method, scene);
    for (Parameter& parameter : parameters) set_parameter(method, scene, std::move(parameter));
    return std::visit(
        [&](auto& function) {
            return MethodAndSystem{std::move(method), std::move(function)};
        },
        scene.mechanics);
}

MethodAndScene read_scene(const MethodOptions& options, const SystemOptions& system) {
    const std::vector<Parameter> parameters = parameters_in(options.parameters);
    return completed(system.scene ? find_scene(system.scene, parameters)
                                  : scene_of(read_hamiltonian(system, parameters)),
                     options);
}

std::variant<MethodAndScene, MethodAndLargeScene>
read_scene_of_any_size(const MethodOptions& options, const SystemOptions& system) {
    if (!system.scene) return read_scene(options, system);
    const std::vector<Parameter> parameters = parameters_in(options.parameters);
    auto [found, unrolling] = find_scene_of_any_size(system.scene, parameters, system.sums);
    try {
        if (auto* large = std::get_if<Scene>(&found)) {
            MethodAndLargeScene both = completed(std::move(*large), system.scene, options);
            both.unrolling = std::move(unrolling);
            return both;
        }
    } catch (const NoLoops& obstacle) {
        const Scene written = find_indexed_scene(system.scene, parameters);
        if (!may_write_out(written, system.sums.choice)) throw;
        unrolling = {true, obstacle.what()};
        found = written_out(written, system.scene, obstacle.what());
    }
    MethodAndScene both = completed(std::get<WrittenOutScene>(std::move(found)), options);
    both.unrolling = std::move(unrolling);
    return both;
}

std::variant<WrittenOutScene, Scene> read_scene_alone(const std::vector<Given>& assignments,
                                                      const SystemOptions& system) {
    const std::vector<Parameter> parameters = parameters_in(assignments);
    std::variant<WrittenOutScene, Scene> found;
    if (system.scene)
        found = find_scene_of_any_size(system.scene, parameters, system.sums).scene;
    else
        found = scene_of(read_hamiltonian(system, parameters));
    Method none;
    for (const Parameter& parameter : parameters) {
        if (auto* scene = std::get_if<WrittenOutScene>(&found))
            set_parameter(none, *scene, parameter);
        auto* large = std::get_if<Scene>(&found);
        if (large != nullptr && !assign(*large, parameter))
            throw InputError(fmt::format("the scene has no parameter `{}`", parameter.name),
                             parameter.place);
    }
    return found;
}

std::variant<MethodAndScene, MethodAndLargeScene> read_both(const MethodOptions& options,
                                                            const SystemOptions& system) {
    const std::vector<Parameter> parameters = parameters_in(options.parameters);
    if (system.scene) {
        auto found = find_scene_of_any_size(system.scene, parameters, system.sums).scene;
        if (auto* large = std::get_if<Scene>(&found))
            return completed(std::move(*large), system.scene, options);
    }
    Method method = read_method(options);
    WrittenOutScene scene = system.scene ? find_scene(system.scene, parameters)
                                         : scene_of(read_hamiltonian(system, parameters));
    check_together(method, scene);
    for (const Parameter& parameter : parameters) set_parameter(method, scene, parameter);
    return MethodAndScene{std::move(method), std::move(scene)};
}

}  // namespace hvi::gen

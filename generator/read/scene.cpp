// Scenes by name, and the values of their parameters.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "generator/read/embedded.hpp"
#include "generator/read/names.hpp"
#include "generator/read/nearest.hpp"
#include "generator/read/sizes.hpp"
#include "generator/read/unroll.hpp"
#include "generator/read/unrolling.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

namespace {

/// `kepler` of `kepler.toml`.
std::string_view name_of(const EmbeddedFile& file) {
    return file.name.substr(0, file.name.rfind('.'));
}

std::vector<std::string> parameter_names(const WrittenOutScene& scene) {
    std::vector<std::string> names;
    for (const Parameter& parameter : scene.parameters) names.push_back(parameter.name);
    return names;
}

[[noreturn]] void refuse_unknown(const Given& given) {
    const std::string& name = given->text;
    std::vector<std::string_view> names;
    for (const EmbeddedFile& file : embedded_scenes()) names.push_back(name_of(file));
    throw InputError(
        fmt::format("there is no scene and no file `{}`", name), whole(given),
        did_you_mean(name, names, "`hvi-gen list scenes` shows those that come with the program"));
}

Scene embedded_scene(const EmbeddedFile& file) {
    return indexed_scene_from_toml({std::string(file.name), std::string(file.text)});
}

Scene found(const Given& name_or_file) {
    const std::string& name = name_or_file->text;
    for (const EmbeddedFile& file : embedded_scenes()) {
        if (name_of(file) != name) continue;
        Scene scene = embedded_scene(file);
        scene.origin = name;
        return scene;
    }
    std::error_code ignored;
    const auto status = std::filesystem::status(name, ignored);
    if (status.type() == std::filesystem::file_type::not_found) refuse_unknown(name_or_file);
    return indexed_scene_from_file(name);
}

}  // namespace

const MechanicalFunction& function_of(const WrittenOutScene& scene) {
    return std::visit([](const auto& of) -> const MechanicalFunction& { return of; },
                      scene.mechanics);
}

MechanicalFunction& function_of(WrittenOutScene& scene) {
    return std::visit([](auto& of) -> MechanicalFunction& { return of; }, scene.mechanics);
}

std::vector<std::string> variables(const WrittenOutScene& scene) {
    return std::visit([](const auto& of) { return variables(of); }, scene.mechanics);
}

std::string_view name_of_function(const WrittenOutScene& scene) {
    return std::holds_alternative<Hamiltonian>(scene.mechanics) ? "the Hamiltonian"
                                                                : "the Lagrangian";
}

const Hamiltonian& hamiltonian_of(const WrittenOutScene& scene) {
    if (const auto* H = std::get_if<Hamiltonian>(&scene.mechanics)) return *H;
    throw MathError("here a Hamiltonian is wanted, and the scene has a Lagrangian",
                    whole(function_of(scene).source), "`hvi-gen scheme` prints its Hamiltonian");
}

WrittenOutScene scene_from_toml(const Source& file) {
    return unrolled(indexed_scene_from_toml(file));
}

WrittenOutScene scene_from_file(const std::filesystem::path& path) {
    return unrolled(indexed_scene_from_file(path));
}

Scene find_indexed_scene(const Given& name_or_file, const std::vector<Parameter>& values) {
    Scene written = found(name_or_file);
    for (const Parameter& value : values) static_cast<void>(assign(written, value));
    return written;
}

WrittenOutScene find_scene(const Given& name_or_file, const std::vector<Parameter>& values) {
    return written_out(find_indexed_scene(name_or_file, values), name_or_file,
                       "here sums are written out; `stepper`, `run` and `report` take scenes of "
                       "any size, without --accuracy");
}

std::vector<SceneEntry> scenes() {
    std::vector<SceneEntry> entries;
    for (const EmbeddedFile& file : embedded_scenes()) {
        const Scene scene = embedded_scene(file);
        entries.push_back({name_of(file), scene.description, degrees_of_freedom(scene)});
    }
    std::sort(entries.begin(), entries.end(), [](const SceneEntry& left, const SceneEntry& right) {
        return left.name < right.name;
    });
    return entries;
}

NamedExpression expression_of_parameters(const WrittenOutScene& scene, std::string name,
                                         std::shared_ptr<const Source> text) {
    Expression read = unrolled(parse_indexed_expression(text), function_of(scene).sizes);
    check_functions(read, text, "this");
    const std::vector<std::string> names = parameter_names(scene);
    walk(read, [&](const Expression& part) {
        const bool is_known = part.kind != Expression::Kind::symbol || is_constant(part.name) ||
                              contains(names, part.name);
        if (!is_known)
            throw InputError(fmt::format("the scene has no parameter `{}`", part.name),
                             Place{text, part.range},
                             did_you_mean(part.name, {names.begin(), names.end()},
                                          "it may depend on parameters, pi and e"));
        return true;
    });
    Place place{text, {0, text->text.size()}};
    return {std::move(name), std::move(read), std::move(place)};
}

void check_together(const Method& method, const WrittenOutScene& scene) {
    check_together(method, variables(scene), name_of_function(scene));
}

void set_parameter(Method& method, WrittenOutScene& scene, Parameter parameter) {
    std::vector<std::string> names = parameter_names(scene);
    const std::vector<std::string> of_method = parameter_names(method);
    const bool in_scene = contains(names, parameter.name);
    const bool in_method = contains(of_method, parameter.name);
    if (!in_scene && !in_method && function_of(scene).sizes.count(parameter.name) == 0) {
        names.insert(names.end(), of_method.begin(), of_method.end());
        refuse_parameter(parameter, variables(scene), name_of_function(scene), names);
    }
    if (in_scene) assign(scene.parameters, parameter);
    MechanicalFunction& function = function_of(scene);
    if (contains(parameter_names(function.expression, variables(scene)), parameter.name))
        assign(function.parameters, parameter);
    if (in_method) set_parameter(method, std::move(parameter));
}

}  // namespace hvi::gen

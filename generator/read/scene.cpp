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

namespace hvi::gen {

namespace {

/// `kepler` of `kepler.toml`.
std::string_view name_of(const EmbeddedFile& file) {
    return file.name.substr(0, file.name.rfind('.'));
}

std::vector<std::string> parameter_names(const SceneData& scene) {
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

Hamiltonian& function_of(Scene& scene) { return scene.hamiltonian; }
Lagrangian& function_of(LagrangianScene& scene) { return scene.lagrangian; }

/// `owner` is what messages call what has the variables.
template <class AScene>
void set_parameter_of(Method& method, AScene& scene, Parameter parameter, std::string_view owner) {
    std::vector<std::string> names = parameter_names(scene);
    const std::vector<std::string> of_method = parameter_names(method);
    const bool in_scene = contains(names, parameter.name);
    const bool in_method = contains(of_method, parameter.name);
    if (!in_scene && !in_method) {
        names.insert(names.end(), of_method.begin(), of_method.end());
        refuse_parameter(parameter, variables(function_of(scene)), owner, names);
    }
    if (in_scene) assign(scene.parameters, parameter);
    if (contains(parameter_names(function_of(scene)), parameter.name))
        assign(function_of(scene).parameters, parameter);
    if (in_method) set_parameter(method, std::move(parameter));
}

/// NOTE: it is to come that (4.14) is stepped; what takes steps takes a Hamiltonian until then.
Scene with_hamiltonian(AnyScene scene) {
    if (auto* found = std::get_if<Scene>(&scene)) return std::move(*found);
    const auto& given = std::get<LagrangianScene>(scene);
    throw MathError("the steps of a Lagrangian are to come: here a Hamiltonian is wanted",
                    whole(given.lagrangian.source),
                    "`hvi-gen scheme --lagrangian` prints its equations (4.14), and `hvi-gen "
                    "scheme` those of its Hamiltonian");
}

AnyScene embedded_scene(const EmbeddedFile& file) {
    return any_scene_from_toml({std::string(file.name), std::string(file.text)});
}

}  // namespace

AnyScene find_any_scene(const Given& name_or_file) {
    const std::string& name = name_or_file->text;
    const auto placed = [&](AnyScene scene) {
        std::visit([&](SceneData& data) { data.place = whole(name_or_file); }, scene);
        return scene;
    };
    for (const EmbeddedFile& file : embedded_scenes()) {
        if (name_of(file) != name) continue;
        AnyScene scene = embedded_scene(file);
        std::visit([&](auto& found) { function_of(found).origin = name; }, scene);
        return placed(std::move(scene));
    }
    std::error_code ignored;
    const auto status = std::filesystem::status(name, ignored);
    if (status.type() == std::filesystem::file_type::not_found) refuse_unknown(name_or_file);
    return placed(any_scene_from_file(name));
}

Scene find_scene(const Given& name_or_file) {
    return with_hamiltonian(find_any_scene(name_or_file));
}

Scene scene_from_toml(const Source& file) { return with_hamiltonian(any_scene_from_toml(file)); }

std::vector<SceneEntry> scenes() {
    std::vector<SceneEntry> entries;
    for (const EmbeddedFile& file : embedded_scenes()) {
        const AnyScene scene = embedded_scene(file);
        const auto description = [](const SceneData& data) { return data.description; };
        entries.push_back({name_of(file), std::visit(description, scene)});
    }
    std::sort(entries.begin(), entries.end(), [](const SceneEntry& left, const SceneEntry& right) {
        return left.name < right.name;
    });
    return entries;
}

NamedExpression expression_of_parameters(const Scene& scene, std::string name,
                                         std::shared_ptr<const Source> text) {
    Expression read = parse_indexed_expression(text);
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

void set_parameter(Method& method, Scene& scene, Parameter parameter) {
    set_parameter_of(method, scene, std::move(parameter), "the Hamiltonian");
}

void set_parameter(Method& method, LagrangianScene& scene, Parameter parameter) {
    set_parameter_of(method, scene, std::move(parameter), "the Lagrangian");
}

}  // namespace hvi::gen

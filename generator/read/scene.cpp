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

std::vector<std::string> parameter_names(const Scene& scene) {
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

}  // namespace

Scene find_scene(const Given& name_or_file) {
    const std::string& name = name_or_file->text;
    for (const EmbeddedFile& file : embedded_scenes()) {
        if (name_of(file) != name) continue;
        Scene scene = scene_from_toml({std::string(file.name), std::string(file.text)});
        scene.hamiltonian.origin = name;
        scene.place = whole(name_or_file);
        return scene;
    }
    std::error_code ignored;
    const auto status = std::filesystem::status(name, ignored);
    if (status.type() == std::filesystem::file_type::not_found) refuse_unknown(name_or_file);
    Scene scene = scene_from_file(name);
    scene.place = whole(name_or_file);
    return scene;
}

std::vector<SceneEntry> scenes() {
    std::vector<SceneEntry> entries;
    for (const EmbeddedFile& file : embedded_scenes()) {
        const Scene scene = scene_from_toml({std::string(file.name), std::string(file.text)});
        entries.push_back({name_of(file), scene.description});
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
    std::vector<std::string> names = parameter_names(scene);
    const std::vector<std::string> of_method = parameter_names(method);
    const bool in_scene = contains(names, parameter.name);
    const bool in_method = contains(of_method, parameter.name);
    if (!in_scene && !in_method) {
        names.insert(names.end(), of_method.begin(), of_method.end());
        refuse_parameter(parameter, scene.hamiltonian, names);
    }
    if (in_scene) assign(scene.parameters, parameter);
    if (contains(parameter_names(scene.hamiltonian), parameter.name))
        assign(scene.hamiltonian.parameters, parameter);
    if (in_method) set_parameter(method, std::move(parameter));
}

}  // namespace hvi::gen

// Scenes by name, and the values of their parameters.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "generator/read/embedded.hpp"
#include "generator/read/hamiltonian.hpp"
#include "generator/read/names.hpp"
#include "generator/read/nearest.hpp"
#include "generator/read/sizes.hpp"
#include "generator/read/toml_file.hpp"

namespace hvi::gen {

namespace {

/// `kepler` of `kepler.toml`.
std::string_view name_of(const EmbeddedFile& file) {
    return file.name.substr(0, file.name.rfind('.'));
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
    return scene_from_toml({std::string(file.name), std::string(file.text)});
}

/// Returns null where no scene of this name comes with the program.
const EmbeddedFile* find_embedded(std::string_view name) {
    for (const EmbeddedFile& file : embedded_scenes())
        if (name_of(file) == name) return &file;
    return nullptr;
}

void check_is_there(const Given& file) {
    std::error_code ignored;
    const auto status = std::filesystem::status(file->text, ignored);
    if (status.type() == std::filesystem::file_type::not_found) refuse_unknown(file);
}

Scene found(const Given& name_or_file) {
    const std::string& name = name_or_file->text;
    if (const EmbeddedFile* file = find_embedded(name)) {
        Scene scene = embedded_scene(*file);
        scene.origin = name;
        return scene;
    }
    check_is_there(name_or_file);
    return scene_from_file(name);
}

}  // namespace

std::string_view name_of_function(const Scene& scene) {
    return scene.side == Side::hamiltonian ? "the Hamiltonian" : "the Lagrangian";
}

void refuse_rotations(const Scene& scene, std::string_view what) {
    if (scene.rotations.texts.empty()) { return; }
    throw InputError(fmt::format("{} is not built for scenes with rotations", what),
                     whole(scene.function.source), "`stepper`, `run` and `report` take these");
}

void refuse_scale(const Scene& scene, std::string_view what) {
    if (!scene.scale) { return; }
    throw InputError(fmt::format("{} is not built for scenes with a scale of the time", what),
                     scene.scale->place, "`stepper`, `module`, `run` and `report` take these");
}

const std::string& title(const Scene& scene) {
    return scene.name.empty() ? scene.origin : scene.name;
}

Scene find_scene(const Given& name_or_file, const std::vector<Parameter>& values) {
    Scene scene = found(name_or_file);
    scene.place = whole(name_or_file);
    for (const Parameter& value : values) { static_cast<void>(assign(scene, value)); }
    return scene;
}

std::string scene_text(const Given& name_or_file) {
    if (const EmbeddedFile* file = find_embedded(name_or_file->text))
        return std::string(file->text);
    check_is_there(name_or_file);
    return toml_source(name_or_file->text).text;
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

// ---- of --hamiltonian ----

namespace {

/// Makes names without indices, as if the whole text declared each.
NameTexts texts_of(const std::vector<std::string>& names, const Place& place) {
    NameTexts result{{}, place};
    for (const std::string& name : names) {
        result.texts.push_back({{{name, {}, place.range}}, place.source});
    }
    return result;
}

}  // namespace

Scene scene_from_hamiltonian(const std::shared_ptr<const Source>& expression,
                             const std::shared_ptr<const Source>& coordinates,
                             const std::shared_ptr<const Source>& momenta,
                             const std::vector<Parameter>& values) {
    const Hamiltonian H = hamiltonian_from_text(expression, coordinates, momenta, values);
    Scene scene;
    scene.function = parse_indexed_expression(expression);
    scene.coordinates = texts_of(H.coordinates, whole(coordinates ? coordinates : expression));
    scene.conjugates = texts_of(H.momenta, whole(momenta ? momenta : expression));
    scene.origin = H.origin;
    for (const auto& [name, size] : H.sizes) {
        scene.parameters.push_back({name,
                                    IndexedExpression{Expression::integer(size), expression},
                                    whole(expression),
                                    {}});
    }
    for (const std::string& name : parameter_names(H)) {
        scene.parameters.push_back({name, NoValue{}, whole(expression), {}});
    }
    for (const Parameter& value : values) { static_cast<void>(assign(scene, value)); }
    return scene;
}

// ---- sizes and values ----

namespace {

std::size_t count(const NameTexts& names, const WholeNumbers& known) {
    constexpr std::size_t most_in_family = 1'000'000'000'000;
    std::size_t total = 0;
    for (const NameTexts::Text& text : names.texts) {
        for (const Name& name : text.names) {
            std::size_t count = 1;
            for (const IndexBounds& bounds : name.bounds) {
                const auto [first, last] = interval(bounds, text.source, known);
                const auto extent = static_cast<std::size_t>(last - first + 1);
                if (count > most_in_family / extent) {
                    throw InputError("there are more of these than any memory holds",
                                     Place{text.source, name.range});
                }
                count *= extent;
            }
            total += count;
        }
    }
    return total;
}

}  // namespace

std::size_t degrees_of_freedom(const Scene& scene) {
    const WholeNumbers known = sizes(scene);
    return count(scene.coordinates, known) +
           rotations_of_space.tangent * count(scene.rotations, known);
}

Index index_of_value(const ValueList& list, std::size_t k) {
    Index index(list.extents.size());
    for (std::size_t d = index.size(); d-- > 0; k /= list.extents[d]) {
        index[d] = static_cast<long>(k % list.extents[d]) + 1;
    }
    return index;
}

namespace {

bool assign(IndexedValue& value, const Parameter& parameter) {
    const IndexedExpression given{parameter.value, parameter.source};
    if (auto* list = std::get_if<ValueList>(&value.value)) {
        for (std::size_t k = 0; k < list->values.size(); ++k) {
            if (indexed_name(value.name, index_of_value(*list, k)) != parameter.name) { continue; }
            list->values[k] = given;
            return true;
        }
        return false;
    }
    if (std::holds_alternative<ValueFile>(value.value)) {
        if (without_index(parameter.name) != value.name) { return false; }
        throw InputError(fmt::format("the values of `{}` stand in a file", value.name),
                         parameter.place, "change them there");
    }
    if (parameter.name != value.name) { return false; }
    value.value = given;
    return true;
}

std::vector<std::string> parameter_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const IndexedValue& value : scene.parameters) {
        const auto* list = std::get_if<ValueList>(&value.value);
        if (list == nullptr) { names.push_back(value.name); }
        for (std::size_t k = 0; list != nullptr && k < list->values.size(); ++k) {
            names.push_back(indexed_name(value.name, index_of_value(*list, k)));
        }
    }
    return names;
}

/// Returns variables; those with an index by the names of their families where `with_families`.
std::vector<std::string> variable_names(const Scene& scene, bool with_families) {
    std::vector<std::string> names;
    for (const NameTexts* texts :
         {&scene.coordinates, &scene.rotations, &scene.conjugates, &scene.angular_momenta}) {
        for (const NameTexts::Text& text : texts->texts) {
            for (const Name& name : text.names) {
                if (with_families || name.bounds.empty()) { names.push_back(name.stem); }
            }
        }
    }
    return names;
}

}  // namespace

bool assign(Scene& scene, const Parameter& parameter) {
    return std::any_of(scene.parameters.begin(), scene.parameters.end(),
                       [&](IndexedValue& value) { return assign(value, parameter); });
}

void check_together(const Method& method, const Scene& scene) {
    check_together(method, variable_names(scene, false), name_of_function(scene));
}

void set_parameter(Method& method, Scene& scene, Parameter parameter) {
    const std::vector<std::string> of_method = parameter_names(method);
    const bool in_method = contains(of_method, parameter.name);
    const bool in_scene = assign(scene, parameter);
    if (!in_scene && !in_method) {
        std::vector<std::string> variables = variable_names(scene, true);
        if (contains(variables, std::string(without_index(parameter.name)))) {
            variables.push_back(parameter.name);
        }
        std::vector<std::string> names = parameter_names(scene);
        names.insert(names.end(), of_method.begin(), of_method.end());
        refuse_parameter(parameter, variables, name_of_function(scene), names);
    }
    if (in_scene && in_method) { scene.fixed.insert(parameter.name); }
    if (in_method) { set_parameter(method, std::move(parameter)); }
}

}  // namespace hvi::gen

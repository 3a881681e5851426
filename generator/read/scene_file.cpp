// Scene files: from TOML to a scene with the place of every word.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "generator/read/file.hpp"
#include "generator/read/names.hpp"
#include "generator/read/rotation_value.hpp"
#include "generator/read/scene_reader.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t most_invariants = 64;

/// Returns the name of a file without its folders and its ending, as plain as a name must be.
std::string name_of_file(const std::string& path) {
    std::string name = std::filesystem::path(path).stem().string().substr(0, 64);
    std::replace_if(
        name.begin(), name.end(),
        [](char c) {
            const bool plain = ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') ||
                               ('0' <= c && c <= '9') ||
                               std::string_view("-_.+").find(c) != std::string_view::npos;
            return !plain;
        },
        '-');
    return name.empty() ? "scene" : name;
}

}  // namespace

const toml::node& SceneReader::required(std::string_view key, std::string_view example) const {
    if (const toml::node* node = file_.table().get(key)) return *node;
    const auto name = std::make_shared<const Source>(Source{"file", source_.name});
    throw InputError(fmt::format("the scene has no `{}`", key), Place{name, {0, name->text.size()}},
                     fmt::format("add {}", example));
}

/// Returns null where the file has no such section.
const toml::table* SceneReader::section(std::string_view key, std::string_view example) const {
    const toml::node* node = file_.table().get(key);
    if (node == nullptr) return nullptr;
    if (const auto* table = node->as_table()) return table;
    throw InputError(fmt::format("`{}` is no section", key), file_.place(*node),
                     fmt::format("write a section [{}] with lines such as {}", key, example));
}

std::string SceneReader::description() const {
    const toml::node* node = file_.table().get("description");
    if (node == nullptr) return {};
    const auto* text = node->as_string();
    const auto is_printable = [](char c) { return ' ' <= c && c <= '~'; };
    if (text == nullptr || !std::all_of(text->get().begin(), text->get().end(), is_printable))
        throw InputError("this is no description", file_.place(*node),
                         "it is a text of one line in printable ASCII");
    return text->get();
}

/// Reads the names in a text, or in the texts of an array.
NameTexts SceneReader::names(std::string_view key, std::string_view example) const {
    const toml::node& node = required(key, fmt::format("a line such as {} = {}", key, example));
    NameTexts all{{}, file_.place(node)};
    const auto append = [&](const toml::node& text) {
        if (!text.is_string())
            throw InputError("a text with names is wanted here", file_.place(text),
                             fmt::format("write for example {} = {}", key, example));
        const auto source = file_.source(text, file_.text(text));
        all.texts.push_back({parse_names(source), source});
    };
    const auto* array = node.as_array();
    if (array == nullptr) {
        append(node);
        all.place = whole(all.texts.front().source);
        return all;
    }
    if (array->empty()) throw InputError("the list is empty", file_.place(node));
    for (const toml::node& text : *array) append(text);
    return all;
}

IndexedExpression SceneReader::expression(const toml::node& node) const {
    return parse_indexed_expression(file_.source(node, file_.text(node)), own_);
}

NamedIndexed SceneReader::named(std::string name, const toml::node& node) const {
    IndexedExpression read = expression(node);
    Place place = whole(read.source);
    return {std::move(name), std::move(read), std::move(place)};
}

void SceneReader::check_absent(std::string_view key, std::string_view other, std::string_view fault,
                               std::string_view help) const {
    const auto entry = file_.table().find(key);
    if (entry == file_.table().end()) return;
    throw InputError(fmt::format("`{}` {} `{}`", key, fault, other),
                     file_.place(entry->first.source()), std::string(help));
}

/// Throws InputError where the file mixes keys of a Hamiltonian with keys of a Lagrangian.
void SceneReader::check_mechanics() const {
    if (file_.table().contains("lagrangian")) {
        check_absent("hamiltonian", "lagrangian", "stands beside",
                     "a scene has one of the two; the other follows from it");
        check_absent("momenta", "lagrangian", "stands beside",
                     "a Lagrangian has velocities; momenta follow from it, p = dL/dv");
    } else {
        check_absent("velocities", "lagrangian", "stands without",
                     "a Hamiltonian has momenta: write momenta = [...]");
    }
}

/// NOTE: a body that only turns has rotations alone.
void SceneReader::read_variables(Scene& scene) const {
    const bool has_lagrangian = file_.table().contains("lagrangian");
    const bool has_rotations = file_.table().contains("rotations");
    if (has_lagrangian && has_rotations)
        check_absent("rotations", "lagrangian", "stands beside",
                     "rotations are built for Hamiltonians: H(q, R, p, L)");
    if (has_rotations) {
        scene.rotations = names("rotations", "[\"R\"]");
        scene.angular_momenta = names("angular_momenta", "[\"L\"]");
    } else {
        check_absent("angular_momenta", "rotations", "stands without",
                     "write rotations = [\"R\"] too");
    }
    const bool only_turns = has_rotations && !file_.table().contains("coordinates") &&
                            !file_.table().contains("momenta");
    if (only_turns) return;
    scene.coordinates = names("coordinates", "[\"x\", \"y\"]");
    scene.conjugates = has_lagrangian ? names("velocities", "[\"vx\", \"vy\"]")
                                      : names("momenta", "[\"px\", \"py\"]");
}

void SceneReader::read_mechanics(Scene& scene) {
    check_mechanics();
    const bool has_lagrangian = file_.table().contains("lagrangian");
    scene.side = has_lagrangian ? Side::lagrangian : Side::hamiltonian;
    const toml::node& node =
        has_lagrangian ? *file_.table().get("lagrangian")
                       : required("hamiltonian", "a line such as hamiltonian = \"p^2/2 - cos(q)\"");
    read_variables(scene);
    for (const NameTexts::Text& text : scene.rotations.texts)
        for (const Name& name : text.names) rotations_.push_back(name.stem);
    scene.function = expression(node);
    scene.origin = quoted_file_name(source_.name);
    scene.directory = directory();
}

/// Reads `x`, or `"u[i,j]"` with its indices, which are names. NOTE: `x[1]` is one name.
RuleName SceneReader::rule_name(const toml::key& key) const {
    const std::string name(key.str());
    const std::size_t bracket = name.find('[');
    if (bracket == std::string::npos || is_indexed_name(name)) return {name, {}};
    Place place = file_.place(key.source());
    const std::string_view text = std::string_view(place.source->text).substr(place.range.begin);
    if (text.front() == '"' || text.front() == '\'') {
        ++place.range.begin;
        --place.range.end;
    }
    return parse_rule_name(place.source, place.range);
}

/// Whether the name is a rotation, or one of several: `R`, `R[2]`.
bool SceneReader::is_of_rotation(std::string_view name) const {
    return contains(rotations_, std::string(without_index(name)));
}

IndexedValue SceneReader::value(const TomlEntry& entry) const {
    const auto& [key, node] = entry;
    RuleName name = rule_name(*key);
    IndexedValue result{std::move(name.stem), {}, file_.place(key->source()), file_.place(*node)};
    const auto* array = node->as_array();
    if (is_of_rotation(result.name) && array == nullptr &&
        (node->is_table() || name.indices.empty()))
        result.value = RotationValue{rotation_in(*node, file_, own_).entries, name.indices};
    else if (const auto* table = node->as_table())
        std::visit([&](auto&& values) { result.value = std::forward<decltype(values)>(values); },
                   values_in(column_file(*table)));
    else if (!name.indices.empty())
        result.value = ValueRule{std::move(name.indices), expression(*node)};
    else if (array != nullptr)
        result.value = list(*array);
    else
        result.value = expression(*node);
    return result;
}

/// Reads `{file = "start.csv", column = "x"}`. The path is relative to the scene's directory.
ColumnFile SceneReader::column_file(const toml::table& table) const {
    file_.check_keys(table, "table of values", {"file", "column"});
    const auto text = [&](std::string_view key) -> std::optional<std::string> {
        const toml::node* node = table.get(key);
        if (node == nullptr) return {};
        if (node->is_string()) return file_.text(*node);
        throw InputError("a text is wanted here", file_.place(*node));
    };
    const auto path = text("file");
    if (!path)
        throw InputError("there is no file", file_.place(table),
                         "write {file = \"start.csv\", column = \"x\"}");
    return {directory(), *path, text("column"), file_.place(table)};
}

ValueList SceneReader::list(const toml::array& array) const {
    ValueList list;
    const toml::array* inner = &array;
    while (inner != nullptr) {
        list.extents.push_back(inner->size());
        inner = inner->empty() ? nullptr : inner->front().as_array();
    }
    append(list, array, 0);
    return list;
}

/// Appends the values of a row, or of a matrix, whose rows are equally long.
void SceneReader::append(ValueList& list, const toml::array& array, std::size_t depth) const {
    const bool is_row = depth + 1 == list.extents.size();
    if (array.size() != list.extents[depth])
        throw InputError(fmt::format("this row has {} value{}, and the first one {}", array.size(),
                                     array.size() == 1 ? "" : "s", list.extents[depth]),
                         file_.place(array), "all rows are equally long");
    for (const toml::node& each : array) {
        const auto* row = each.as_array();
        if (is_row) {
            list.values.push_back(expression(each));
        } else if (row == nullptr) {
            throw InputError("a row is wanted here, as the first one is", file_.place(each));
        } else {
            append(list, *row, depth + 1);
        }
    }
}

std::vector<IndexedValue> SceneReader::parameters() const {
    std::vector<IndexedValue> list;
    const toml::table* table = section("parameters", "mu = 1");
    if (table == nullptr) return list;
    for (const TomlEntry& entry : in_order(*table)) {
        check_parameter_name(std::string(entry.first->str()), file_.place(entry.first->source()));
        list.push_back(value(entry));
        const auto* several = std::get_if<ValueList>(&list.back().value);
        if (several != nullptr && several->values.empty())
            throw InputError("the list is empty", list.back().place_of_value);
    }
    return list;
}

/// Reads `V = {header = "potential.hpp", arguments = 1}`.
OwnFunction SceneReader::own_function(const TomlEntry& entry) const {
    const auto& [key, node] = entry;
    constexpr const char* help = "write V = {header = \"potential.hpp\", arguments = 1}";
    OwnFunction function{std::string(key->str()), 1, {}, file_.place(key->source())};
    check_own_name(function.name, function.place);
    const toml::table* table = node->as_table();
    if (table == nullptr)
        throw InputError("a header and a number of arguments are wanted here", file_.place(*node),
                         help);
    file_.check_keys(*table, "function", {"header", "arguments"});
    const toml::node* header = table->get("header");
    if (header == nullptr || !header->is_string())
        throw InputError("the path of a header is wanted here",
                         file_.place(header == nullptr ? *node : *header), help);
    function.header = file_.text(*header);
    check_own_header(function.header, file_.place(*header));
    const toml::node* arguments = table->get("arguments");
    const auto* count = arguments == nullptr ? nullptr : arguments->as_integer();
    if (count == nullptr || count->get() < 1 || count->get() > long(most_own_arguments))
        throw InputError(
            fmt::format("`arguments` is a whole number from 1 to {}", most_own_arguments),
            file_.place(arguments == nullptr ? *node : *arguments), help);
    function.arguments = static_cast<std::size_t>(count->get());
    return function;
}

OwnFunctions SceneReader::own_functions() const {
    OwnFunctions own;
    const toml::table* table =
        section("functions", "V = {header = \"potential.hpp\", arguments = 1}");
    if (table == nullptr) return own;
    if (file_.table().contains("lagrangian"))
        check_absent("functions", "lagrangian", "stands beside",
                     "functions of your own are built for Hamiltonians");
    const std::filesystem::path directory = std::filesystem::path(source_.name).parent_path();
    for (const TomlEntry& entry : in_order(*table)) {
        own.functions.push_back(own_function(entry));
        const toml::node& header = *entry.second->as_table()->get("header");
        add_own_header(own, directory, own.functions.back().header, file_.place(header));
    }
    return own;
}

/// NOTE: indices of sums are looked at where they are read.
void SceneReader::check_apart(const Scene& scene) const {
    const auto check = [&](std::string_view name, const Place& place) {
        hvi::gen::check_apart(scene.own, name, place);
    };
    for (const NameTexts* names :
         {&scene.coordinates, &scene.conjugates, &scene.rotations, &scene.angular_momenta})
        for (const NameTexts::Text& text : names->texts)
            for (const Name& name : text.names) check(name.stem, {text.source, name.range});
    for (const IndexedValue& parameter : scene.parameters) check(parameter.name, parameter.place);
    for (const Definition& definition : scene.definitions) check(definition.name, definition.place);
    for (const NamedIndexed& invariant : scene.invariants)
        check(invariant.name, invariant.place_of_name);
    for (const IndexedField& field : scene.fields) check(field.name, field.place);
}

std::vector<Definition> SceneReader::definitions() const {
    std::vector<Definition> list;
    const toml::table* table = section("definitions", "r = \"sqrt(x^2 + y^2)\"");
    if (table == nullptr) return list;
    for (const auto& [key, node] : in_order(*table)) {
        RuleName name = rule_name(*key);
        Place place = file_.place(key->source());
        check_parameter_name(name.stem, place, "a definition");
        list.push_back(
            {std::move(name.stem), std::move(name.indices), expression(*node), std::move(place)});
    }
    return list;
}

/// Reads `"x*py - y*px"`, a vector, or `{value = "x*py - y*px", approximate = true}`. Each
/// component of a vector is an invariant: J_1, J_2, ...
void SceneReader::add_invariant(Scene& scene, const TomlEntry& entry) const {
    const toml::key& key = *entry.first;
    const toml::node& node = *entry.second;
    const auto* table = node.as_table();
    const toml::node& value = table == nullptr ? node : value_of_invariant(*table);
    const bool is_approximate = table != nullptr && (*table)["approximate"].value_or(false);
    const auto add = [&](const std::string& name, const toml::node& text) {
        NamedIndexed& invariant = scene.invariants.emplace_back(named(name, text));
        if (scene.invariants.size() > most_invariants)
            throw InputError(fmt::format("there are more than {} invariants", most_invariants),
                             file_.place(key.source()));
        invariant.place_of_name = file_.place(key.source());
        if (is_approximate) scene.approximate.insert(name);
    };
    const std::string name(key.str());
    const auto* vector = value.as_array();
    if (vector == nullptr) return add(name, value);
    if (vector->empty())
        throw InputError("the list is empty", file_.place(value),
                         "write the components of a vector");
    for (std::size_t k = 0; k < vector->size(); ++k)
        add(fmt::format("{}_{}", name, k + 1), *vector->get(k));
}

const toml::node& SceneReader::value_of_invariant(const toml::table& table) const {
    file_.check_keys(table, "table of an invariant", {"value", "approximate"});
    const toml::node* value = table.get("value");
    const toml::node* approximate = table.get("approximate");
    if (value == nullptr)
        throw InputError("there is no value", file_.place(table),
                         "write {value = \"x*py - y*px\", approximate = true}");
    if (approximate != nullptr && !approximate->is_boolean())
        throw InputError("true or false is wanted here", file_.place(*approximate));
    return *value;
}

void SceneReader::read_invariants(Scene& scene) const {
    const toml::table* table = section("invariants", "momentum = \"px1 + px2\"");
    if (table == nullptr) return;
    for (const TomlEntry& entry : in_order(*table)) add_invariant(scene, entry);
}

/// Reads `coordinates = "jacobi"`, which makes the parts itself.
SplitChoice SceneReader::orbit_coordinates(const toml::table& split) const {
    const toml::node& node = *split.get("coordinates");
    const std::string word = file_.text(node);
    file_.check_keys(split, "section [split] with `coordinates`, which make the parts",
                     {"coordinates"});
    for (const SplitChoice choice : {SplitChoice::jacobi, SplitChoice::heliocentric})
        if (word == word_of(choice)) return choice;
    throw InputError(fmt::format("there are no coordinates `{}`", word), file_.place(node),
                     "coordinates: jacobi, heliocentric");
}

/// Reads `A = "p^2/2"`, `B = "-cos(q)"`.
SplitOfScene SceneReader::split() const {
    constexpr std::size_t most_parts = 64;
    const toml::table* table = section("split", "A = \"p^2/2\"");
    if (table == nullptr) return {};
    check_absent("lagrangian", "split", "stands beside", "parts are of a Hamiltonian");
    if (table->contains("coordinates")) return orbit_coordinates(*table);
    IndexedSplit split{{}, file_.place(*table)};
    const toml::node* small_steps = table->get("small_steps");
    for (const auto& [key, node] : in_order(*table)) {
        if (node == small_steps) continue;
        const std::string name(key->str());
        check_parameter_name(name, file_.place(key->source()), "a part");
        split.parts.push_back(named(name, *node));
    }
    if (split.parts.empty() || split.parts.size() > most_parts)
        throw InputError(fmt::format("a splitting has from 1 to {} parts", most_parts), split.place,
                         "write parts of H, as A = \"p^2/2\" and B = \"-cos(q)\"");
    if (small_steps != nullptr) read_small_steps(*small_steps, split);
    return split;
}

std::vector<IndexedField> SceneReader::fields() const {
    std::vector<IndexedField> list;
    const toml::table* table = section("symmetries", "turn = {x = \"-y\", y = \"x\"}");
    if (table == nullptr) return list;
    for (const auto& [key, node] : in_order(*table)) {
        const auto* components = node->as_table();
        if (components == nullptr || components->empty())
            throw InputError("this is no vector field", file_.place(*node),
                             "write how the coordinates move: {x = \"-y\", y = \"x\"}");
        list.push_back({std::string(key->str()), values(*components), file_.place(key->source())});
    }
    return list;
}

ValueTable SceneReader::values(const toml::table& table) const {
    ValueTable values{{}, file_.place(table)};
    for (const TomlEntry& entry : in_order(table)) values.values.push_back(value(entry));
    return values;
}

IndexedRun SceneReader::run() const {
    IndexedRun wishes;
    const toml::table* table = section("run", "step = \"1/10\"");
    if (table == nullptr) return wishes;
    file_.check_keys(*table, "section [run]", {"method", "step", "until"});
    if (const toml::node* node = table->get("method")) {
        if (!node->is_string())
            throw InputError("the method is not a text", file_.place(*node),
                             "write for example method = \"gauss:4\"");
        wishes.method = file_.source(*node, file_.text(*node));
        static_cast<void>(named_method(wishes.method));
    }
    if (const toml::node* node = table->get("step")) wishes.step = named("step", *node);
    if (const toml::node* node = table->get("until")) wishes.until = named("until", *node);
    return wishes;
}

/// Throws InputError for keys that are not supported yet.
void SceneReader::refuse_to_come() const {
    for (const std::string_view key :
         {"boundary", "guess", "ode", "state", "control", "cost", "end_cost"}) {
        const auto entry = file_.table().find(key);
        if (entry == file_.table().end()) continue;
        const bool is_section = entry->second.is_table();
        throw InputError(fmt::format("{} is to come", is_section ? fmt::format("[{}]", key)
                                                                 : fmt::format("`{}`", key)),
                         file_.place(entry->first.source()), "it is planned, and not built yet");
    }
}

Scene SceneReader::read() {
    refuse_to_come();
    file_.check_keys(file_.table(), "scene",
                     {"name",       "description", "coordinates",     "momenta",
                      "velocities", "rotations",   "angular_momenta", "hamiltonian",
                      "lagrangian", "parameters",  "functions",       "definitions",
                      "invariants", "symmetries",  "events",          "split",
                      "time",       "initial",     "exact",           "run"});
    Scene scene;
    scene.name = file_.name();
    if (scene.name.empty()) scene.name = name_of_file(source_.name);
    scene.description = description();
    scene.text = source_.text;
    scene.own = own_functions();
    own_ = scene.own.arguments();
    read_mechanics(scene);
    scene.parameters = parameters();
    scene.definitions = definitions();
    read_invariants(scene);
    scene.fields = fields();
    scene.events = events();
    scene.split = split();
    read_time(scene);
    static_cast<void>(required("initial", "a section [initial] with lines such as x = 0"));
    scene.initial = values(*section("initial", "x = 0"));
    if (const toml::table* table = section("exact", "q = \"cos(t)\"")) scene.exact = values(*table);
    scene.run = run();
    check_apart(scene);
    return scene;
}

Scene scene_from_toml(const Source& file) { return SceneReader(file).read(); }

Scene scene_from_file(const std::filesystem::path& path) {
    return scene_from_toml(toml_source(path));
}

}  // namespace hvi::gen

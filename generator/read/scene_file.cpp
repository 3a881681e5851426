// Scene files: from TOML to what a scene is, with the place of every word.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "generator/read/check.hpp"
#include "generator/read/file.hpp"
#include "generator/read/names.hpp"
#include "generator/read/nearest.hpp"
#include "generator/read/scene.hpp"
#include "generator/read/toml_file.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t most_invariants = 64;
constexpr std::size_t most_words_of_scene =
    300'000;  ///< of all expressions, with their sums expanded

/// What may stand in an expression besides parameters, pi and e.
struct SceneRules {
    std::string_view subject;  ///< what messages call it
    bool variables = false;
    bool time = false;
    std::string_view help;  ///< for a symbol that resembles no other
};

constexpr std::string_view made_of_parameters = "it is made of numbers, parameters, pi and e";
constexpr SceneRules hamiltonian_rules{"the Hamiltonian", true, true,
                                       "give it a value: add it to [parameters]"};
constexpr SceneRules lagrangian_rules{"the Lagrangian", true, true,
                                      "give it a value: add it to [parameters]"};
constexpr SceneRules invariant_rules{"an invariant", true, false, "add it to [parameters]"};
constexpr SceneRules initial_rules{"an initial value", false, false, made_of_parameters};
constexpr SceneRules exact_rules{"an exact solution", false, true,
                                 "it is made of numbers, parameters, pi, e and the time `t`"};
constexpr SceneRules step_rules{"the step size", false, false, made_of_parameters};
constexpr SceneRules until_rules{"the time at the end", false, false, made_of_parameters};

using Entry = std::pair<const toml::key*, const toml::node*>;

/// What a table has, as it stands in the file. NOTE: toml++ sorts by key.
std::vector<Entry> in_order(const toml::table& table) {
    std::vector<Entry> entries;
    for (const auto& [key, node] : table) entries.emplace_back(&key, &node);
    std::sort(entries.begin(), entries.end(), [](const Entry& left, const Entry& right) {
        return left.first->source().begin < right.first->source().begin;
    });
    return entries;
}

std::string indexed(std::string_view name, std::string_view index) {
    return fmt::format("{}[{}]", name, index);
}

/// The name of a file without its folders and its ending, as plain as a name must be.
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

class SceneReader {
public:
    explicit SceneReader(const Source& source) : source_(source), file_(source) {}

    [[nodiscard]] Scene read();

private:
    [[nodiscard]] const toml::node& required(std::string_view key, std::string_view example) const;
    [[nodiscard]] const toml::table* section(std::string_view key, std::string_view example) const;
    [[nodiscard]] std::string description() const;
    [[nodiscard]] NameList names(std::string_view key, std::string_view example) const;
    [[nodiscard]] NamedExpression expression(std::string name, const toml::node& node,
                                             const SceneRules& rules);
    void check_words(const Expression& expression, const std::shared_ptr<const Source>& source,
                     const SceneRules& rules);
    void check_mechanics() const;
    void check_absent(std::string_view key, std::string_view other, std::string_view fault,
                      std::string_view help) const;
    [[nodiscard]] Hamiltonian hamiltonian();
    [[nodiscard]] Lagrangian lagrangian();
    void read_data(Scene& scene, const SceneRules& rules, const Expression& function,
                   const std::shared_ptr<const Source>& source);
    [[nodiscard]] std::vector<Parameter> parameters();
    void add_parameter(std::vector<Parameter>& list, DeclaredName name, const toml::node& value);
    [[nodiscard]] std::vector<NamedExpression> invariants();
    [[nodiscard]] std::vector<NamedExpression> values(const toml::table& table,
                                                      const SceneRules& rules);
    [[noreturn]] void refuse_variable(const std::string& name, const Place& place) const;
    void add_values(std::map<std::string, NamedExpression>& found, const Entry& entry,
                    const SceneRules& rules);
    [[nodiscard]] RunWishes run();

    const Source& source_;
    TomlFile file_;
    std::vector<std::string> variables_;
    Vocabulary words_;  ///< variables, then parameters too
    std::size_t word_count_ = 0;
};

const toml::node& SceneReader::required(std::string_view key, std::string_view example) const {
    if (const toml::node* node = file_.table().get(key)) return *node;
    const auto name = std::make_shared<const Source>(Source{"file", source_.name});
    throw InputError(fmt::format("the scene has no `{}`", key), Place{name, {0, name->text.size()}},
                     fmt::format("add {}", example));
}

/// Null where there is none.
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

/// The names in a text, or in those of an array.
NameList SceneReader::names(std::string_view key, std::string_view example) const {
    const toml::node& node = required(key, fmt::format("a line such as {} = {}", key, example));
    const auto in_text = [&](const toml::node& text) {
        if (!text.is_string())
            throw InputError("a text with names is wanted here", file_.place(text),
                             fmt::format("write for example {} = {}", key, example));
        return names_in(file_.source(text, file_.text(text)));
    };
    const auto* array = node.as_array();
    if (array == nullptr) return in_text(node);
    if (array->empty()) throw InputError("the list is empty", file_.place(node));
    NameList all{{}, file_.place(node)};
    for (const toml::node& text : *array) {
        NameList some = in_text(text);
        all.names.insert(all.names.end(), some.names.begin(), some.names.end());
        if (all.names.size() > most_degrees_of_freedom) break;  // which is refused
    }
    return all;
}

NamedExpression SceneReader::expression(std::string name, const toml::node& node,
                                        const SceneRules& rules) {
    const auto source = file_.source(node, file_.text(node));
    Expression read = parse_indexed_expression(source);
    check_words(read, source, rules);
    return {std::move(name), std::move(read), {source, {0, source->text.size()}}};
}

void SceneReader::check_words(const Expression& expression,
                              const std::shared_ptr<const Source>& source,
                              const SceneRules& rules) {
    check_functions(expression, source, rules.subject);
    const auto check = [&](const std::string& symbol, const Place& place) {
        if (is_constant(symbol) || (symbol == "t" && rules.time)) return;
        if (symbol == "t")
            throw InputError(fmt::format("{} cannot depend on the time `t`", rules.subject), place);
        check_symbol_name(symbol, place);
        words_.check(symbol, place, std::string(rules.help));
        if (!rules.variables && !words_.is("a parameter", without_index(symbol)))
            throw InputError(
                fmt::format("{} cannot depend on the variable `{}`", rules.subject, symbol), place,
                std::string(rules.help));
    };
    walk(expression, [&](const Expression& part) {
        if (part.kind == Expression::Kind::symbol) check(part.name, {source, part.range});
        ++word_count_;
        return true;
    });
    if (word_count_ > most_words_of_scene)
        throw InputError(fmt::format("the expressions of the scene have more than {} words",
                                     most_words_of_scene),
                         Place{source, {0, source->text.size()}});
}

void SceneReader::check_absent(std::string_view key, std::string_view other, std::string_view fault,
                               std::string_view help) const {
    const auto entry = file_.table().find(key);
    if (entry == file_.table().end()) return;
    throw InputError(fmt::format("`{}` {} `{}`", key, fault, other),
                     file_.place(entry->first.source()), std::string(help));
}

/// Whether there is one of H and L, with the variables of it.
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

/// NOTE: its symbols are looked at once the parameters are known.
Hamiltonian SceneReader::hamiltonian() {
    const toml::node& node =
        required("hamiltonian", "a line such as hamiltonian = \"p^2/2 - cos(q)\"");
    const NameList coordinates = names("coordinates", "[\"x\", \"y\"]");
    const NameList momenta = names("momenta", "[\"px\", \"py\"]");
    words_ = declared_variables(coordinates, momenta);
    Hamiltonian H = hamiltonian_of(file_.source(node, file_.text(node)), coordinates, momenta);
    H.origin = quoted_file_name(source_.name);
    return H;
}

/// NOTE: the same.
Lagrangian SceneReader::lagrangian() {
    const toml::node& node = *file_.table().get("lagrangian");
    const NameList coordinates = names("coordinates", "[\"x\", \"y\"]");
    const NameList velocities = names("velocities", "[\"vx\", \"vy\"]");
    words_ = declared_variables(coordinates, velocities, words_of_velocities);
    Lagrangian L = lagrangian_of(file_.source(node, file_.text(node)), coordinates, velocities);
    L.origin = quoted_file_name(source_.name);
    return L;
}

void SceneReader::add_parameter(std::vector<Parameter>& list, DeclaredName name,
                                const toml::node& value) {
    words_.declare(name, "a parameter");
    if (list.size() == most_parameters)
        throw InputError(fmt::format("there are more than {} parameters", most_parameters),
                         name.place);
    const auto source = file_.source(value, file_.text(value));
    Parameter parameter{std::move(name.name), {}, std::move(name.place)};
    read_value(parameter, source, {0, source->text.size()});
    list.push_back(std::move(parameter));
}

std::vector<Parameter> SceneReader::parameters() {
    std::vector<Parameter> list;
    const toml::table* table = section("parameters", "mu = 1");
    if (table == nullptr) return list;
    for (const auto& [key, node] : in_order(*table)) {
        const std::string name(key->str());
        const Place place = file_.place(key->source());
        check_parameter_name(name, place);
        const auto* array = node->as_array();
        if (array == nullptr) {
            add_parameter(list, {name, place}, *node);
            continue;
        }
        if (array->empty()) throw InputError("the list is empty", file_.place(*node));
        std::size_t index = 0;
        for (const toml::node& value : *array)
            add_parameter(list, {indexed(name, std::to_string(++index)), place}, value);
    }
    return list;
}

std::vector<NamedExpression> SceneReader::invariants() {
    std::vector<NamedExpression> list;
    const toml::table* table = section("invariants", "momentum = \"px1 + px2\"");
    if (table == nullptr) return list;
    Vocabulary names = words_;
    for (const auto& [key, node] : in_order(*table)) {
        const DeclaredName name{std::string(key->str()), file_.place(key->source())};
        check_parameter_name(name.name, name.place, "an invariant");
        names.declare(name, "an invariant");
        if (list.size() == most_invariants)
            throw InputError(fmt::format("there are more than {} invariants", most_invariants),
                             name.place);
        list.push_back(expression(name.name, *node, invariant_rules));
    }
    return list;
}

[[noreturn]] void SceneReader::refuse_variable(const std::string& name, const Place& place) const {
    const std::string stem(without_index(name));
    if (words_.contains(name) && name != stem)
        throw InputError(fmt::format("the value of `{}` stands among those of `{}`", name, stem),
                         place, fmt::format("write {} = [...], with all values", stem));
    std::vector<std::string_view> names;
    for (const std::string& variable : variables_)
        if (names.empty() || names.back() != without_index(variable))
            names.push_back(without_index(variable));
    throw InputError(
        fmt::format("`{}` is no variable", name), place,
        did_you_mean(name, names, fmt::format("the variables are {}", fmt::join(names, ", "))));
}

/// The value of a variable, or those of x[1], x[2], ... by ascending index.
void SceneReader::add_values(std::map<std::string, NamedExpression>& found, const Entry& entry,
                             const SceneRules& rules) {
    const auto& [key, node] = entry;
    const std::string name(key->str());
    std::vector<std::string> indices = words_.indices(name);
    if (indices.empty() || words_.is("a parameter", name))
        refuse_variable(name, file_.place(key->source()));
    if (indices.front().empty()) {
        found.emplace(name, expression(name, *node, rules));
        return;
    }
    const auto* array = node->as_array();
    const std::size_t given = array == nullptr ? 1 : array->size();
    if (array == nullptr || given != indices.size())
        throw InputError(fmt::format("`{}` has {} {}, and here {} {} value{}", name, indices.size(),
                                     indices.size() == 1 ? "index" : "indices",
                                     given == 1 ? "is" : "are", given, given == 1 ? "" : "s"),
                         file_.place(*node), "write the values for all indices as a list");
    std::sort(indices.begin(), indices.end(), [](const auto& left, const auto& right) {
        return std::stol(left) < std::stol(right);
    });
    for (std::size_t k = 0; k < given; ++k) {
        const std::string each = indexed(name, indices[k]);
        found.emplace(each, expression(each, *array->get(k), rules));
    }
}

/// One for each variable: those of the coordinates, then of the others.
std::vector<NamedExpression> SceneReader::values(const toml::table& table,
                                                 const SceneRules& rules) {
    std::map<std::string, NamedExpression> found;
    for (const Entry& entry : in_order(table)) add_values(found, entry, rules);
    std::vector<NamedExpression> list;
    for (const std::string& name : variables_) {
        const auto position = found.find(name);
        if (position == found.end())
            throw InputError(fmt::format("{} is missing: that of `{}`", rules.subject, name),
                             file_.place(table),
                             fmt::format("each of {} has one", fmt::join(variables_, ", ")));
        list.push_back(std::move(position->second));
    }
    return list;
}

RunWishes SceneReader::run() {
    RunWishes wishes;
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
    if (const toml::node* node = table->get("step"))
        wishes.step = expression("step", *node, step_rules);
    if (const toml::node* node = table->get("until"))
        wishes.until = expression("until", *node, until_rules);
    return wishes;
}

/// What follows once the variables are known, which are those of `function`, H or L.
void SceneReader::read_data(Scene& scene, const SceneRules& rules, const Expression& function,
                            const std::shared_ptr<const Source>& source) {
    scene.parameters = parameters();
    check_words(function, source, rules);
    scene.invariants = invariants();
    static_cast<void>(required("initial", "a section [initial] with lines such as x = 0"));
    scene.initial = values(*section("initial", "x = 0"), initial_rules);
    if (const toml::table* table = section("exact", "q = \"cos(t)\""))
        scene.exact = values(*table, exact_rules);
    scene.run = run();
}

Scene SceneReader::read() {
    file_.check_keys(file_.table(), "scene",
                     {"name", "description", "coordinates", "momenta", "velocities", "hamiltonian",
                      "lagrangian", "parameters", "invariants", "initial", "exact", "run"});
    check_mechanics();
    Scene scene;
    scene.name = file_.name();
    if (scene.name.empty()) scene.name = name_of_file(source_.name);
    scene.description = description();
    if (file_.table().contains("lagrangian")) {
        Lagrangian L = lagrangian();
        variables_ = variables(L);
        read_data(scene, lagrangian_rules, L.expression, L.source);
        scene.mechanics = std::move(L);
        return scene;
    }
    Hamiltonian H = hamiltonian();
    variables_ = variables(H);
    read_data(scene, hamiltonian_rules, H.expression, H.source);
    scene.mechanics = std::move(H);
    return scene;
}

}  // namespace

Scene scene_from_toml(const Source& file) { return SceneReader(file).read(); }

Scene scene_from_file(const std::filesystem::path& path) {
    return scene_from_toml(toml_source(path));
}

}  // namespace hvi::gen

// From a scene as it is written to one without indices.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "generator/read/column_file.hpp"
#include "generator/read/names.hpp"
#include "generator/read/nearest.hpp"
#include "generator/read/put_in.hpp"
#include "generator/read/scene.hpp"
#include "generator/read/sizes.hpp"

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
    bool own_functions = false;
    std::string_view help;  ///< for a symbol that resembles no other
};

constexpr std::string_view made_of_parameters = "it is made of numbers, parameters, pi and e";
constexpr SceneRules hamiltonian_rules{"the Hamiltonian", true, true, true,
                                       "give it a value: add it to [parameters]"};
constexpr SceneRules lagrangian_rules{"the Lagrangian", true, true, false,
                                      "give it a value: add it to [parameters]"};
constexpr SceneRules parameter_rules{"the value of a parameter", false, false, false,
                                     made_of_parameters};
constexpr SceneRules invariant_rules{"an invariant", true, false, true, "add it to [parameters]"};
constexpr SceneRules field_rules{"a vector field", true, false, false, "add it to [parameters]"};
constexpr SceneRules initial_rules{"an initial value", false, false, false, made_of_parameters};
constexpr SceneRules exact_rules{"an exact solution", false, true, false,
                                 "it is made of numbers, parameters, pi, e and the time `t`"};
constexpr SceneRules step_rules{"the step size", false, false, false, made_of_parameters};
constexpr SceneRules until_rules{"the time at the end", false, false, false, made_of_parameters};

/// The index of the k-th value of a list: 1, 2, ..., or of a matrix 1,1, 1,2, ...
Index index_of_value(const ValueList& list, std::size_t k) {
    Index index(list.extents.size());
    for (std::size_t d = index.size(); d-- > 0; k /= list.extents[d]) {
        index[d] = static_cast<long>(k % list.extents[d]) + 1;
    }
    return index;
}

/// How many values each component of the indices has.
std::vector<std::size_t> extents(const std::vector<Index>& indices) {
    std::vector<std::size_t> result;
    for (std::size_t d = 0; d < indices.front().size(); ++d) {
        std::set<long> values;
        for (const Index& index : indices) { values.insert(index[d]); }
        result.push_back(values.size());
    }
    return result;
}

[[noreturn]] void refuse_count(const IndexedValue& value, std::size_t wanted, std::size_t given) {
    throw InputError(fmt::format("`{}` has {} {}, and here {} {} value{}", value.name, wanted,
                                 wanted == 1 ? "index" : "indices", given == 1 ? "is" : "are",
                                 given, given == 1 ? "" : "s"),
                     value.place_of_value, "write the values for all indices as a list");
}

/// Throws InputError at the first of too many names. NOTE: a list is one, however long it is.
void check_count(const std::vector<IndexedValue>& parameters) {
    if (parameters.size() <= most_parameters) { return; }
    throw InputError(fmt::format("there are more than {} parameters", most_parameters),
                     parameters[most_parameters].place, "those with an index are one: m[1], m[2]");
}

[[noreturn]] void refuse_words(const Place& place) {
    throw InputError(
        fmt::format("the expressions of the scene have more than {} words", most_words_of_scene),
        place);
}

class SceneUnrolling {
public:
    explicit SceneUnrolling(const Scene& written) : written_(written), sizes_(sizes(written)) {}

    [[nodiscard]] WrittenOutScene operator()();
    [[nodiscard]] WrittenOutScene without_motion();

private:
    void declare_variables(const VariableNames& names);
    void define();
    void set_mechanics(WrittenOutScene& scene);

    [[nodiscard]] NamedExpression expression(std::string name, const IndexedExpression& written,
                                             const SceneRules& rules,
                                             const WholeNumbers& indices = {});
    void check_words(const Expression& expression, const std::shared_ptr<const Source>& source,
                     const SceneRules& rules);

    [[nodiscard]] std::vector<Parameter> parameters();
    [[nodiscard]] ValueList values_of(const IndexedValue& value) const;
    void add_parameter(std::vector<Parameter>& list, const IndexedValue& value, std::string name,
                       const IndexedExpression& written);
    [[nodiscard]] std::vector<NamedExpression> invariants();
    [[nodiscard]] std::vector<VectorField> fields();
    void check_component(const NamedExpression& component, const Place& place) const;

    using Values = std::map<std::string, NamedExpression>;
    [[nodiscard]] std::vector<NamedExpression> values(const ValueTable& table,
                                                      const SceneRules& rules);
    void add_values(Values& found, const IndexedValue& value, const SceneRules& rules);
    void add_list(Values& found, const IndexedValue& value, const ValueList& list,
                  const std::vector<Index>& indices, const SceneRules& rules);
    void add_rule(Values& found, const IndexedValue& value, const ValueRule& rule,
                  const std::vector<Index>& indices, const SceneRules& rules);
    void put(Values& found, const IndexedValue& value, const std::string& name,
             const IndexedExpression& written, const SceneRules& rules,
             const WholeNumbers& indices = {});
    [[nodiscard]] bool is_momentum_of_body(const std::string& name) const;
    void add_momentum_of_body(Values& found, const IndexedValue& value, const SceneRules& rules);
    void add_rotation(Values& found, const IndexedValue& value, const RotationValue& rotation,
                      const SceneRules& rules);
    [[noreturn]] void refuse_variable(const std::string& name, const Place& place) const;
    [[nodiscard]] RunWishes run();

    const Scene& written_;
    WholeNumbers sizes_;
    Definitions definitions_;
    std::vector<std::string> variables_;
    std::vector<RotationNames> rotations_;
    Vocabulary words_;  ///< variables, then parameters too
    std::size_t word_count_ = 0;
};

void SceneUnrolling::declare_variables(const VariableNames& names) {
    const bool has_velocities = written_.side == Side::lagrangian;
    words_ = has_velocities
                 ? declared_variables(names.coordinates, names.conjugates, words_of_velocities)
                 : declared_variables(names);
}

/// The definitions, each with those above it put in.
void SceneUnrolling::define() {
    for (const Definition& definition : written_.definitions) {
        if (!words_.indices(definition.name).empty()) {
            throw InputError(
                fmt::format("`{}` is a variable or a parameter already", definition.name),
                definition.place);
        }
        definitions_.add(definition);
    }
}

NamedExpression SceneUnrolling::expression(std::string name, const IndexedExpression& written,
                                           const SceneRules& rules, const WholeNumbers& indices) {
    WholeNumbers known = indices;
    known.insert(sizes_.begin(), sizes_.end());
    Expression read = unrolled(definitions_.put_in(written), known);
    check_words(read, written.source, rules);
    return {std::move(name), std::move(read), whole(written.source)};
}

void SceneUnrolling::check_words(const Expression& expression,
                                 const std::shared_ptr<const Source>& source,
                                 const SceneRules& rules) {
    check_functions(expression, source, rules.subject);
    if (!rules.own_functions) { refuse_own_functions(expression, source, rules.subject); }
    const auto check = [&](const std::string& symbol, const Place& place) {
        if (is_constant(symbol) || (symbol == "t" && rules.time)) { return; }
        if (symbol == "t") {
            throw InputError(fmt::format("{} cannot depend on the time `t`", rules.subject), place);
        }
        check_symbol_name(symbol, place);
        words_.check(symbol, place, std::string(rules.help));
        if (!rules.variables && !words_.is("a parameter", without_index(symbol))) {
            throw InputError(
                fmt::format("{} cannot depend on the variable `{}`", rules.subject, symbol), place,
                std::string(rules.help));
        }
    };
    walk(expression, [&](const Expression& part) {
        if (part.kind == Expression::Kind::symbol) { check(part.name, {source, part.range}); }
        ++word_count_;
        return true;
    });
    if (word_count_ > most_words_of_scene) { refuse_words(whole(source)); }
}

// ---- parameters ----

void SceneUnrolling::add_parameter(std::vector<Parameter>& list, const IndexedValue& value,
                                   std::string name, const IndexedExpression& written) {
    words_.declare({name, value.place}, "a parameter");
    list.push_back({std::move(name), unrolled(written, sizes_), value.place, written.source});
}

/// Values of a list, also where they stand in a file.
ValueList SceneUnrolling::values_of(const IndexedValue& value) const {
    const auto* file = std::get_if<ValueFile>(&value.value);
    if (file == nullptr) { return std::get<ValueList>(value.value); }
    if (count(*file) > most_words_of_scene) { refuse_words(value.place_of_value); }
    return all_values_in({written_.directory, file->path, file->column, value.place_of_value});
}

/// Those that are no sizes.
std::vector<Parameter> SceneUnrolling::parameters() {
    check_count(written_.parameters);
    std::vector<Parameter> list;
    for (const IndexedValue& value : written_.parameters) {
        if (sizes_.count(value.name) != 0) {
            words_.declare({value.name, value.place}, "a parameter");
            continue;
        }
        if (const auto* one = std::get_if<IndexedExpression>(&value.value)) {
            add_parameter(list, value, value.name, *one);
        } else {
            const ValueList several = values_of(value);
            for (std::size_t k = 0; k < several.values.size(); ++k) {
                add_parameter(list, value, indexed_name(value.name, index_of_value(several, k)),
                              several.values[k]);
            }
        }
    }
    for (const Parameter& parameter : list) {
        check_words(parameter.value, parameter.source, parameter_rules);
    }
    resolve(list);
    return list;
}

// ---- H, or L ----

void SceneUnrolling::set_mechanics(WrittenOutScene& scene) {
    const VariableNames names{
        unrolled(written_.coordinates, sizes_), unrolled(written_.conjugates, sizes_),
        unrolled(written_.rotations, sizes_), unrolled(written_.angular_momenta, sizes_)};
    declare_variables(names);
    scene.parameters = parameters();
    define();
    const std::shared_ptr<const Source>& source = written_.function.source;
    const bool is_lagrangian = written_.side == Side::lagrangian;
    Expression function =
        expression("", written_.function, is_lagrangian ? lagrangian_rules : hamiltonian_rules)
            .expression;
    if (is_lagrangian) {
        scene.mechanics =
            lagrangian_of(std::move(function), source, names.coordinates, names.conjugates);
    } else {
        scene.mechanics = hamiltonian_of(std::move(function), source, names);
    }
    variables_ = variables(scene);
    rotations_ = function_of(scene).rotations;
    function_of(scene).origin = written_.origin;
    function_of(scene).sizes = sizes_;
}

std::vector<NamedExpression> SceneUnrolling::invariants() {
    std::vector<NamedExpression> list;
    Vocabulary names = words_;
    for (const NamedIndexed& invariant : written_.invariants) {
        const Place& place = invariant.place_of_name;
        check_parameter_name(invariant.name, place, "an invariant");
        names.declare({invariant.name, place}, "an invariant");
        if (list.size() == most_invariants) {
            throw InputError(fmt::format("there are more than {} invariants", most_invariants),
                             place);
        }
        list.push_back(expression(invariant.name, invariant.expression, invariant_rules));
    }
    return list;
}

/// Throws InputError for what is not a function of the coordinates, moving one.
void SceneUnrolling::check_component(const NamedExpression& component, const Place& place) const {
    const auto coordinates = variables_.begin();
    const auto conjugates = coordinates + static_cast<std::ptrdiff_t>(variables_.size() / 2);
    const auto is_coordinate = [&](const std::string& name) {
        return std::find(coordinates, conjugates, name) != conjugates;
    };
    if (!is_coordinate(component.name)) {
        throw InputError(fmt::format("`{}` is no coordinate", component.name), place,
                         "a vector field moves the coordinates; what follows them follows");
    }
    walk(component.expression, [&](const Expression& part) {
        const bool is_other =
            part.kind == Expression::Kind::symbol && words_.contains(part.name) &&
            std::find(conjugates, variables_.end(), part.name) != variables_.end();
        if (is_other) {
            throw InputError("a vector field is one of the coordinates alone",
                             Place{component.place.source, part.range});
        }
        return true;
    });
}

std::vector<VectorField> SceneUnrolling::fields() {
    std::vector<VectorField> list;
    Vocabulary names = words_;
    for (const NamedIndexed& invariant : written_.invariants) {
        names.declare({invariant.name, invariant.place_of_name}, "an invariant");
    }
    for (const IndexedField& written : written_.fields) {
        check_parameter_name(written.name, written.place, "a symmetry");
        names.declare({written.name, written.place}, "a symmetry");
        VectorField& field = list.emplace_back();
        field.name = written.name;
        field.place = written.place;
        Values found;
        for (const IndexedValue& value : written.components.values) {
            const Values before = found;
            add_values(found, value, field_rules);
            for (const auto& [name, component] : found) {
                if (before.count(name) == 0) { check_component(component, value.place); }
            }
        }
        for (const std::string& name : variables_) {
            const auto component = found.find(name);
            if (component != found.end()) { field.components.push_back(component->second); }
        }
    }
    return list;
}

// ---- initial values, and exact ones ----

[[noreturn]] void SceneUnrolling::refuse_variable(const std::string& name,
                                                  const Place& place) const {
    const std::string stem(without_index(name));
    if (words_.contains(name) && name != stem) {
        throw InputError(fmt::format("the value of `{}` stands among those of `{}`", name, stem),
                         place, fmt::format("write {} = [...], with all values", stem));
    }
    std::vector<std::string_view> names;
    for (const std::string& variable : variables_) {
        if (names.empty() || names.back() != without_index(variable)) {
            names.push_back(without_index(variable));
        }
    }
    throw InputError(fmt::format("`{}` is no variable", name), place,
                     did_you_mean(name, names, fmt::format("the variables are {}", listed(names))));
}

/// The value of one variable.
void SceneUnrolling::put(Values& found, const IndexedValue& value, const std::string& name,
                         const IndexedExpression& written, const SceneRules& rules,
                         const WholeNumbers& indices) {
    const bool is_new = found.emplace(name, expression(name, written, rules, indices)).second;
    if (is_new) { return; }
    throw InputError(fmt::format("`{}` is given values twice", value.name), value.place);
}

void SceneUnrolling::add_list(Values& found, const IndexedValue& value, const ValueList& list,
                              const std::vector<Index>& indices, const SceneRules& rules) {
    const std::size_t given = list.values.size();
    if (given != indices.size()) { refuse_count(value, indices.size(), given); }
    if (list.extents.size() > 1 && list.extents != extents(indices)) {
        throw InputError(fmt::format("the indices of `{}` run over {} values, and these over {}",
                                     value.name, fmt::join(extents(indices), " times "),
                                     fmt::join(list.extents, " times ")),
                         value.place_of_value);
    }
    for (std::size_t k = 0; k < given; ++k) {
        put(found, value, indexed_name(value.name, indices[k]), list.values[k], rules);
    }
}

void SceneUnrolling::add_rule(Values& found, const IndexedValue& value, const ValueRule& rule,
                              const std::vector<Index>& indices, const SceneRules& rules) {
    const std::size_t dimension = indices.front().size();
    if (rule.indices.size() != dimension) {
        throw InputError(fmt::format("`{}` has {} ind{}, and here it has {}", value.name, dimension,
                                     dimension == 1 ? "ex" : "ices", rule.indices.size()),
                         value.place);
    }
    for (const Index& index : indices) {
        WholeNumbers known;
        for (std::size_t d = 0; d < dimension; ++d) { known[rule.indices[d]] = index[d]; }
        put(found, value, indexed_name(value.name, index), rule.value, rules, known);
    }
}

/// Of R, or of all rotations R[1], R[2], ..., or of one of them.
void SceneUnrolling::add_rotation(Values& found, const IndexedValue& value,
                                  const RotationValue& rotation, const SceneRules& rules) {
    bool is_known = false;
    for (const RotationNames& names : rotations_) {
        const bool is_one = names.rotation == value.name;
        if (!is_one && without_index(names.rotation) != value.name) { continue; }
        is_known = true;
        const std::vector<std::string> entries = entries_of(names.rotation);
        for (std::size_t k = 0; k < entries.size(); ++k) {
            put(found, value, entries[k], rotation.entries[k], rules);
        }
    }
    if (!is_known) { refuse_variable(value.name, value.place); }
}

/// Whether it is the angular momentum of one of several bodies: `L[2]`.
bool SceneUnrolling::is_momentum_of_body(const std::string& name) const {
    return is_indexed_name(name) &&
           std::any_of(rotations_.begin(), rotations_.end(),
                       [&](const RotationNames& names) { return names.momentum == name; });
}

/// Its three components, of a list.
void SceneUnrolling::add_momentum_of_body(Values& found, const IndexedValue& value,
                                          const SceneRules& rules) {
    const std::vector<std::string> components = components_of(value.name);
    const auto* list = std::get_if<ValueList>(&value.value);
    if (list == nullptr || list->values.size() != components.size()) {
        throw InputError(fmt::format("`{}` has three components", value.name), value.place_of_value,
                         "write for example [0, 0, 1]");
    }
    for (std::size_t k = 0; k < components.size(); ++k) {
        put(found, value, components[k], list->values[k], rules);
    }
}

/// The value of a variable, or those of x[1], x[2], ... by ascending index.
void SceneUnrolling::add_values(Values& found, const IndexedValue& value, const SceneRules& rules) {
    if (const auto* rotation = std::get_if<RotationValue>(&value.value)) {
        add_rotation(found, value, *rotation, rules);
        return;
    }
    if (is_momentum_of_body(value.name)) {
        add_momentum_of_body(found, value, rules);
        return;
    }
    const std::vector<Index> indices = words_.indices(value.name);
    if (indices.empty() || words_.is("a parameter", value.name)) {
        refuse_variable(value.name, value.place);
    }
    const bool has_index = !indices.front().empty();
    if (const auto* rule = std::get_if<ValueRule>(&value.value)) {
        add_rule(found, value, *rule, indices, rules);
    } else if (const auto* one = std::get_if<IndexedExpression>(&value.value)) {
        if (has_index) { refuse_count(value, indices.size(), 1); }
        put(found, value, value.name, *one, rules);
    } else if (has_index) {
        if (const auto* file = std::get_if<ValueFile>(&value.value)) {
            refuse_count(value, indices.size(), count(*file));
        }
        add_list(found, value, std::get<ValueList>(value.value), indices, rules);
    } else {
        throw InputError("a text or a number is wanted here", value.place_of_value,
                         "write for example \"1/2\"");
    }
}

/// One for each variable: those of the coordinates, then of the others.
std::vector<NamedExpression> SceneUnrolling::values(const ValueTable& table,
                                                    const SceneRules& rules) {
    Values found;
    for (const IndexedValue& value : table.values) { add_values(found, value, rules); }
    std::vector<NamedExpression> list;
    for (const std::string& name : variables_) {
        const auto position = found.find(name);
        if (position == found.end()) {
            throw InputError(fmt::format("{} is missing: that of `{}`", rules.subject, name),
                             table.place, fmt::format("each of {} has one", listed(variables_)));
        }
        list.push_back(std::move(position->second));
    }
    return list;
}

RunWishes SceneUnrolling::run() {
    const IndexedRun& written = written_.run;
    RunWishes wishes;
    wishes.method = written.method;
    if (written.step) { wishes.step = expression("step", written.step->expression, step_rules); }
    if (written.until) {
        wishes.until = expression("until", written.until->expression, until_rules);
    }
    return wishes;
}

WrittenOutScene SceneUnrolling::operator()() {
    WrittenOutScene scene;
    scene.name = written_.name;
    scene.description = written_.description;
    set_mechanics(scene);
    scene.own = written_.own;
    scene.invariants = invariants();
    scene.approximate = written_.approximate;
    scene.fields = fields();
    scene.initial = values(written_.initial, initial_rules);
    if (written_.exact) { scene.exact = values(*written_.exact, exact_rules); }
    scene.run = run();
    return scene;
}

WrittenOutScene SceneUnrolling::without_motion() {
    WrittenOutScene scene;
    scene.name = written_.name;
    scene.description = written_.description;
    scene.parameters = parameters();
    function_of(scene).sizes = sizes_;
    function_of(scene).origin = written_.origin;
    scene.run = run();
    return scene;
}

}  // namespace

WrittenOutScene unrolled(const Scene& scene) { return SceneUnrolling(scene)(); }

WrittenOutScene without_motion(Scene scene) {
    std::erase_if(scene.parameters, [](const IndexedValue& parameter) {
        return std::holds_alternative<ValueList>(parameter.value) ||
               std::holds_alternative<ValueFile>(parameter.value);
    });
    return SceneUnrolling(scene).without_motion();
}

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
    return count(scene.coordinates, known) + 3 * count(scene.rotations, known);
}

bool assign(Scene& scene, const Parameter& parameter) {
    const std::string stem(without_index(parameter.name));
    for (IndexedValue& value : scene.parameters) {
        if (value.name != stem) { continue; }
        const IndexedExpression given{parameter.value, parameter.source};
        if (auto* one = std::get_if<IndexedExpression>(&value.value)) {
            if (parameter.name != stem) { return false; }
            *one = given;
            return true;
        }
        if (std::holds_alternative<ValueFile>(value.value)) {
            throw InputError(fmt::format("the values of `{}` stand in a file", stem),
                             parameter.place, "change them there");
        }
        auto& list = std::get<ValueList>(value.value);
        for (std::size_t k = 0; k < list.values.size(); ++k) {
            if (indexed_name(stem, index_of_value(list, k)) != parameter.name) { continue; }
            list.values[k] = given;
            return true;
        }
    }
    return false;
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/scene_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "generator/read/names.hpp"
#include "generator/read/nearest.hpp"

namespace hvi::gen {

namespace {

/// Returns the number of values of each component of the indices.
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

}  // namespace

[[noreturn]] void SceneValues::refuse_variable(const std::string& name, const Place& place) const {
    const std::string stem(without_index(name));
    if (words_.names().contains(name) && name != stem) {
        throw InputError(fmt::format("the value of `{}` stands among those of `{}`", name, stem),
                         place, fmt::format("write {} = [...], with all values", stem));
    }
    std::vector<std::string_view> names;
    for (const std::string& variable : variables_.names) {
        if (names.empty() || names.back() != without_index(variable)) {
            names.push_back(without_index(variable));
        }
    }
    throw InputError(fmt::format("`{}` is no variable", name), place,
                     did_you_mean(name, names, fmt::format("the variables are {}", listed(names))));
}

/// Sets the value of one variable.
void SceneValues::put(const IndexedValue& value, const std::string& name,
                      const IndexedExpression& written, const WholeNumbers& indices) {
    const bool is_new =
        found_.emplace(name, words_.expression(name, written, rules_, indices)).second;
    if (is_new) { return; }
    throw InputError(fmt::format("`{}` is given values twice", value.name), value.place);
}

void SceneValues::add_list(const IndexedValue& value, const ValueList& list,
                           const std::vector<Index>& indices) {
    const std::size_t given = list.values.size();
    if (given != indices.size()) { refuse_count(value, indices.size(), given); }
    if (list.extents.size() > 1 && list.extents != extents(indices)) {
        throw InputError(fmt::format("the indices of `{}` run over {} values, and these over {}",
                                     value.name, fmt::join(extents(indices), " times "),
                                     fmt::join(list.extents, " times ")),
                         value.place_of_value);
    }
    for (std::size_t k = 0; k < given; ++k) {
        put(value, indexed_name(value.name, indices[k]), list.values[k]);
    }
}

void SceneValues::add_rule(const IndexedValue& value, const ValueRule& rule,
                           const std::vector<Index>& indices) {
    const std::size_t dimension = indices.front().size();
    check_dimension(value.name, dimension, rule.indices.size(), value.place);
    for (const Index& index : indices) {
        WholeNumbers known;
        for (std::size_t d = 0; d < dimension; ++d) { known[rule.indices[d]] = index[d]; }
        put(value, indexed_name(value.name, index), rule.value, known);
    }
}

/// Returns the values that the indices of a rule have for one of the bodies.
WholeNumbers indices_of_body(const IndexedValue& value, const RotationValue& rotation,
                             const std::string& name) {
    const Index index = index_of(name);
    if (rotation.indices.empty()) { return {}; }
    check_dimension(value.name, index.size(), rotation.indices.size(), value.place);
    WholeNumbers known;
    for (std::size_t d = 0; d < index.size(); ++d) { known[rotation.indices[d]] = index[d]; }
    return known;
}

/// Adds the values of R, or of all rotations R[1], R[2], ..., or of one of them.
void SceneValues::add_rotation(const IndexedValue& value, const RotationValue& rotation) {
    bool is_known = false;
    for (const RotationNames& names : variables_.rotations) {
        const bool is_one = names.rotation == value.name;
        if (!is_one && without_index(names.rotation) != value.name) { continue; }
        is_known = true;
        const std::vector<std::string> entries = entries_of(names.rotation);
        const WholeNumbers known = indices_of_body(value, rotation, names.rotation);
        for (std::size_t k = 0; k < entries.size(); ++k) {
            put(value, entries[k], rotation.entries[k], known);
        }
    }
    if (!is_known) { refuse_variable(value.name, value.place); }
}

/// Whether the name is the angular momentum of one of several bodies: `L[2]`.
bool SceneValues::is_momentum_of_body(const std::string& name) const {
    return is_indexed_name(name) &&
           std::any_of(variables_.rotations.begin(), variables_.rotations.end(),
                       [&](const RotationNames& names) { return names.momentum == name; });
}

/// Adds the three components of an angular momentum, from a list.
void SceneValues::add_momentum_of_body(const IndexedValue& value) {
    const std::vector<std::string> components = components_of(value.name);
    const auto* list = std::get_if<ValueList>(&value.value);
    if (list == nullptr || list->values.size() != components.size()) {
        throw InputError(fmt::format("`{}` has three components", value.name), value.place_of_value,
                         "write for example [0, 0, 1]");
    }
    for (std::size_t k = 0; k < components.size(); ++k) {
        put(value, components[k], list->values[k]);
    }
}

/// Adds the value of a variable, or the values of x[1], x[2], ... by ascending index.
void SceneValues::add(const IndexedValue& value) {
    if (const auto* rotation = std::get_if<RotationValue>(&value.value)) {
        add_rotation(value, *rotation);
        return;
    }
    if (is_momentum_of_body(value.name)) {
        add_momentum_of_body(value);
        return;
    }
    const std::vector<Index> indices = words_.names().indices(value.name);
    if (indices.empty() || words_.names().is("a parameter", value.name)) {
        refuse_variable(value.name, value.place);
    }
    const bool has_index = !indices.front().empty();
    if (const auto* rule = std::get_if<ValueRule>(&value.value)) {
        add_rule(value, *rule, indices);
    } else if (const auto* one = std::get_if<IndexedExpression>(&value.value)) {
        if (has_index) { refuse_count(value, indices.size(), 1); }
        put(value, value.name, *one);
    } else if (has_index) {
        if (const auto* file = std::get_if<ValueFile>(&value.value)) {
            refuse_count(value, indices.size(), count(*file));
        }
        add_list(value, std::get<ValueList>(value.value), indices);
    } else {
        throw InputError("a text or a number is wanted here", value.place_of_value,
                         "write for example \"1/2\"");
    }
}

std::vector<NamedExpression> values(const ValueTable& table, SceneWords& words,
                                    const SceneVariables& variables, const SceneRules& rules) {
    SceneValues given(words, variables, rules);
    for (const IndexedValue& value : table.values) { given.add(value); }
    std::vector<NamedExpression> list;
    for (const std::string& name : variables.names) {
        const auto position = given.found().find(name);
        if (position == given.found().end()) {
            throw InputError(fmt::format("{} is missing: that of `{}`", rules.subject, name),
                             table.place,
                             fmt::format("each of {} has one", listed(variables.names)));
        }
        list.push_back(position->second);
    }
    return list;
}

}  // namespace hvi::gen

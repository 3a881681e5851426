// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/scene_words.hpp"

#include <fmt/format.h>

#include <set>
#include <utility>

#include "generator/read/column_file.hpp"
#include "generator/read/names.hpp"
#include "generator/read/sizes.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t most_words_of_scene =
    300'000;  ///< words in all expressions, with their sums expanded

/// Throws InputError at the first of too many names. NOTE: a list counts as one, however long it
/// is.
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

}  // namespace

SceneWords::SceneWords(const Scene& written)
    : written_(written), sizes_(hvi::gen::sizes(written)) {}

void SceneWords::declare_variables(const VariableNames& names) {
    const bool has_velocities = written_.side == Side::lagrangian;
    names_ = has_velocities
                 ? declared_variables(names.coordinates, names.conjugates, words_of_velocities)
                 : declared_variables(names);
}

void SceneWords::declare_stems() {
    const auto declare = [&](const NameTexts& texts, std::string_view subject) {
        for (const NameTexts::Text& text : texts.texts) {
            for (const Name& name : text.names) {
                if (names_.is(subject, name.stem)) { continue; }
                names_.declare({name.stem, {text.source, name.range}}, subject);
            }
        }
    };
    declare(written_.coordinates, "a coordinate");
    declare(written_.conjugates, subject_of_conjugates(written_));
    declare(written_.rotations, "a rotation");
    declare(written_.angular_momenta, "an angular momentum");
}

void SceneWords::define() {
    for (const Definition& definition : written_.definitions) {
        check_definition(definition, names_);
        definitions_.add(definition);
    }
}

NamedExpression SceneWords::expression(std::string name, const IndexedExpression& written,
                                       const SceneRules& rules, const WholeNumbers& indices) {
    WholeNumbers known = indices;
    known.insert(sizes_.begin(), sizes_.end());
    const IndexedExpression put = definitions_.put_in(written);
    std::set<std::string> numbers;
    for (const auto& [each, value] : known) { numbers.insert(each); }
    check_words(put, rules, names_, std::move(numbers));
    Expression read = unrolled(put, known);
    check_indices(read, written.source);
    return {std::move(name), std::move(read), whole(written.source)};
}

/// Throws InputError for an index that a name does not have, and for too many words in all.
void SceneWords::check_indices(const Expression& expression,
                               const std::shared_ptr<const Source>& source) {
    walk(expression, [&](const Expression& part) {
        if (part.kind == Expression::Kind::symbol) {
            names_.check_index(part.name, {source, part.range});
        }
        ++word_count_;
        return true;
    });
    if (word_count_ > most_words_of_scene) { refuse_words(whole(source)); }
}

void SceneWords::add_parameter(std::vector<Parameter>& list, const IndexedValue& value,
                               std::string name, const IndexedExpression& written) {
    names_.declare({name, value.place}, "a parameter");
    list.push_back({std::move(name), unrolled(written, sizes_), value.place, written.source});
}

/// Returns the values of a list, reading them where they stand in a file.
ValueList SceneWords::values_of(const IndexedValue& value) const {
    const auto* file = std::get_if<ValueFile>(&value.value);
    if (file == nullptr) { return std::get<ValueList>(value.value); }
    if (count(*file) > most_words_of_scene) { refuse_words(value.place_of_value); }
    return all_values_in({written_.directory, file->path, file->column, value.place_of_value});
}

void SceneWords::add_parameters(std::vector<Parameter>& list, const IndexedValue& value) {
    if (std::holds_alternative<NoValue>(value.value)) {
        names_.declare({value.name, value.place}, "a parameter");
        list.push_back({value.name, {}, {}});
    } else if (const auto* one = std::get_if<IndexedExpression>(&value.value)) {
        add_parameter(list, value, value.name, *one);
    } else {
        const ValueList several = values_of(value);
        for (std::size_t k = 0; k < several.values.size(); ++k) {
            add_parameter(list, value, indexed_name(value.name, index_of_value(several, k)),
                          several.values[k]);
        }
    }
}

std::vector<Parameter> SceneWords::declare_parameters(bool files) {
    check_count(written_.parameters);
    std::vector<Parameter> list;
    for (const IndexedValue& value : written_.parameters) {
        if (sizes_.count(value.name) != 0) {
            names_.declare({value.name, value.place}, "a parameter");
        } else if (files || !std::holds_alternative<ValueFile>(value.value)) {
            add_parameters(list, value);
        }
    }
    for (const Parameter& parameter : list) {
        if (has_value(parameter)) {
            check_words({parameter.value, parameter.source}, parameter_rules, names_, {});
            check_indices(parameter.value, parameter.source);
        }
    }
    resolve(list);
    return list;
}

}  // namespace hvi::gen

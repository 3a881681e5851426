// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/sizes.hpp"

#include <fmt/format.h>

#include <set>

#include "generator/read/names.hpp"

namespace hvi::gen {

namespace {

using Kind = Expression::Kind;
using NameSet = std::set<std::string>;

void insert_symbols(const Expression& index, const NameSet& bound, NameSet& names) {
    walk(index, [&](const Expression& part) {
        if (part.kind == Expression::Kind::symbol && bound.count(part.name) == 0) {
            names.insert(part.name);
        }
        return true;
    });
}

/// Adds the names that stand in indices and in bounds of sums and are no indices themselves.
void insert_structural(const Expression& expression, NameSet bound, NameSet& names) {
    if (expression.kind == Expression::Kind::element) {
        for (const Expression& index : expression.arguments) {
            insert_symbols(index, bound, names);
        }
        return;
    }
    if (expression.kind == Expression::Kind::sum_over) {
        insert_symbols(expression.arguments[0], bound, names);
        insert_symbols(expression.arguments[1], bound, names);
        bound.insert(expression.name);
        insert_structural(expression.arguments[2], std::move(bound), names);
        return;
    }
    for (const Expression& argument : expression.arguments) {
        insert_structural(argument, bound, names);
    }
}

void insert_structural(const NameTexts& written, NameSet& names) {
    for (const NameTexts::Text& text : written.texts) {
        for (const Name& name : text.names) {
            for (const IndexBounds& bounds : name.bounds) {
                insert_symbols(bounds.first, {}, names);
                insert_symbols(bounds.last, {}, names);
            }
        }
    }
}

void insert_structural(const ValueTable& table, NameSet& names) {
    for (const IndexedValue& value : table.values) {
        if (const auto* one = std::get_if<IndexedExpression>(&value.value)) {
            insert_structural(one->written, {}, names);
        } else if (const auto* rule = std::get_if<ValueRule>(&value.value)) {
            insert_structural(rule->value.written, {rule->indices.begin(), rule->indices.end()},
                              names);
        } else if (const auto* list = std::get_if<ValueList>(&value.value)) {
            for (const IndexedExpression& each : list->values) {
                insert_structural(each.written, {}, names);
            }
        } else if (const auto* rotation = std::get_if<RotationValue>(&value.value)) {
            for (const IndexedExpression& each : rotation->entries) {
                insert_structural(each.written,
                                  {rotation->indices.begin(), rotation->indices.end()}, names);
            }
        }
    }
}

NameSet structural_names(const Scene& scene) {
    NameSet names;
    insert_structural(scene.coordinates, names);
    insert_structural(scene.conjugates, names);
    insert_structural(scene.rotations, names);
    insert_structural(scene.angular_momenta, names);
    insert_structural(scene.function.written, {}, names);
    for (const Definition& definition : scene.definitions) {
        insert_structural(definition.value.written,
                          {definition.indices.begin(), definition.indices.end()}, names);
    }
    for (const NamedIndexed& invariant : scene.invariants) {
        insert_structural(invariant.expression.written, {}, names);
    }
    for (const IndexedField& field : scene.fields) { insert_structural(field.components, names); }
    if (const auto* split = std::get_if<IndexedSplit>(&scene.split)) {
        for (const NamedIndexed& part : split->parts) {
            insert_structural(part.expression.written, {}, names);
        }
    }
    if (scene.initial) { insert_structural(*scene.initial, names); }
    if (scene.exact) { insert_structural(*scene.exact, names); }
    return names;
}

/// Finds the values of some parameters, and of the parameters in these values.
class Sizes {
public:
    using Values = std::map<std::string, IndexedExpression>;

    explicit Sizes(Values values) : values_(std::move(values)) {}

    [[nodiscard]] WholeNumbers of(const NameSet& names) && {
        for (const std::string& name : names) { find(name); }
        return std::move(known_);
    }

private:
    /// NOTE: a name that is no parameter, or whose value depends on itself, stays unknown, and is
    /// refused where it stands.
    void find(const std::string& name) {
        const auto position = values_.find(name);
        if (position == values_.end() || !begun_.insert(name).second) { return; }
        const IndexedExpression& value = position->second;
        NameSet others;
        insert_symbols(value.written, {}, others);
        for (const std::string& other : others) { find(other); }
        known_[name] = whole_number(value.written, value.source, known_);
    }

    Values values_;
    NameSet begun_;
    WholeNumbers known_;
};

}  // namespace

WholeNumbers sizes(const Scene& scene) {
    Sizes::Values values;
    for (const IndexedValue& parameter : scene.parameters) {
        const auto* value = std::get_if<IndexedExpression>(&parameter.value);
        if (value != nullptr) { values.emplace(parameter.name, *value); }
    }
    return Sizes(std::move(values)).of(structural_names(scene));
}

WholeNumbers sizes(const IndexedExpression& expression, const std::vector<NameTexts>& names,
                   const std::vector<Parameter>& values) {
    NameSet structural;
    insert_structural(expression.written, {}, structural);
    for (const NameTexts& texts : names) { insert_structural(texts, structural); }
    Sizes::Values known;
    for (const Parameter& value : values) {
        known.emplace(value.name, IndexedExpression{value.value, value.source});
    }
    return Sizes(std::move(known)).of(structural);
}

}  // namespace hvi::gen

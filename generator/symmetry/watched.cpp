// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symmetry/watched.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "generator/read/names.hpp"
#include "generator/read/vocabulary.hpp"
#include "generator/support/warning.hpp"
#include "generator/support/work.hpp"
#include "generator/symmetry/families.hpp"
#include "generator/symmetry/written_out.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t most_searched = 24;         ///< degrees of freedom
constexpr std::size_t most_beside_rotations = 3;  ///< coordinates: two bodies take seconds
constexpr std::size_t most_added = 16;

/// Whether a momentum map is a single momentum, which the table of a run has anyway.
bool is_momentum(const SceneSymmetries& found, std::size_t number) {
    const std::vector<Expression>& generator = found.affine.basis[number].generator;
    const Expression zero = Expression::integer(0);
    std::size_t moving = 0;
    for (const Expression& component : generator)
        if (!(component == zero)) moving += component.kind == Expression::Kind::number ? 1 : 2;
    return moving == 1;
}

bool is_invariant(const WrittenOutScene& scene, const Expression& map) {
    return std::any_of(
        scene.invariants.begin(), scene.invariants.end(), [&](const NamedExpression& invariant) {
            return std::visit(
                [&](const auto& mechanics) {
                    return are_proportional(mechanics, {map, nullptr},
                                            {invariant.expression, invariant.place.source});
                },
                scene.mechanics);
        });
}

bool has_name(const Scene& scene, const std::string& name) {
    const auto is_it = [&](const auto& named) { return named.name == name; };
    const auto has_variable = [&](const NameTexts& texts) {
        return std::any_of(texts.texts.begin(), texts.texts.end(), [&](const auto& text) {
            return std::any_of(text.names.begin(), text.names.end(),
                               [&](const Name& each) { return each.stem == name; });
        });
    };
    return std::any_of(scene.invariants.begin(), scene.invariants.end(), is_it) ||
           std::any_of(scene.parameters.begin(), scene.parameters.end(), is_it) ||
           std::any_of(scene.definitions.begin(), scene.definitions.end(), is_it) ||
           std::any_of(scene.own.functions.begin(), scene.own.functions.end(), is_it) ||
           has_variable(scene.coordinates) || has_variable(scene.conjugates) ||
           has_variable(scene.rotations) || has_variable(scene.angular_momenta);
}

/// Replaces symbols with an index by elements: x[3].
Expression with_elements(const Expression& expression) {
    if (expression.kind == Expression::Kind::symbol && is_indexed_name(expression.name)) {
        std::vector<Expression> indices;
        for (const long index : index_of(expression.name))
            indices.push_back(Expression::integer(index));
        return Expression::element(std::string(without_index(expression.name)), std::move(indices));
    }
    Expression result = expression;
    for (Expression& argument : result.arguments) argument = with_elements(argument);
    return result;
}

void add(Scene& scene, const ConservedQuantity& quantity) {
    const auto source =
        std::make_shared<const Source>(Source{quantity.name, to_text(quantity.expression)});
    const Place place = whole(source);
    scene.invariants.push_back(
        {quantity.name, {with_elements(quantity.expression), source}, place, place});
}

/// Adds the momentum maps that no invariant tells, under the names that `symmetries` shows.
void add_momentum_maps(Scene& scene, SceneSymmetries& found) {
    std::size_t added = 0;
    for (ConservedQuantity& map : found.momentum_maps) {
        if (map.is_said || added == most_added) continue;
        ++added;
        while (has_name(scene, map.name)) map.name += "_";
        add(scene, map);
    }
}

/// NOTE: a field and an invariant with one name would be one quantity told twice.
void add_fields(Scene& scene, const SceneSymmetries& found) {
    for (const ConservedQuantity& field : found.fields) add(scene, field);
    scene.fields.clear();
}

void warn_of(const ConservedQuantity& invariant) {
    if (invariant.finding.conserved != Vanishing::refuted || invariant.is_approximate) return;
    const bool is_field = invariant.kind == ConservedQuantity::Kind::field;
    if (is_field)
        warn("`" + invariant.name + "` is no symmetry: the bracket of its momentum map with H is " +
             to_text(invariant.finding.bracket));
    else
        warn("the invariant `" + invariant.name + "`: " + not_zero(invariant), help_for_not_zero);
}

/// Returns the result of `find` within the work that a run has for it; empty where that is not
/// enough.
template <class Find>
auto within_a_second(Find find) -> std::optional<decltype(find())> {
    const WorkLimit limit(work_of_a_second);
    try {
        return find();
    } catch (const WorkLimitReached&) { return {}; }
}

/// Looks for symmetries by `find`, which may be refused, or take too long.
template <class Find>
Watched look(Scene& scene, Find find) {
    Watched result;
    try {
        result.found = within_a_second(find);
    } catch (const NoLoops&) {
        throw;
    } catch (const InputError&) {  // nothing is known of functions of the user's own
        return result;
    } catch (const MathError&) { return result; }
    if (!result.found) {
        result.left_out = symmetry_work_is_spent;
        return result;
    }
    for (const ConservedQuantity& invariant : result.found->invariants) warn_of(invariant);
    for (const ConservedQuantity& field : result.found->fields) warn_of(field);
    add_fields(scene, *result.found);
    add_momentum_maps(scene, *result.found);
    return result;
}

Watched left_out(const char* why) { return {{}, why, {}}; }

Watched watch_written_out(Scene& scene, const WrittenOutScene& written) {
    const std::size_t degrees = function_of(written).degrees_of_freedom();
    if (degrees > most_searched) return left_out("there are more than 24 degrees of freedom");
    const std::size_t turns = function_of(written).rotations.size();
    if (turns > 0 && degrees > 3 * turns + most_beside_rotations)
        return left_out("of several bodies it takes seconds");
    return look(scene, [&] {
        SceneSymmetries found = symmetries_of(written);
        for (std::size_t i = 0; i < found.momentum_maps.size(); ++i) {
            ConservedQuantity& map = found.momentum_maps[i];
            map.is_said = is_momentum(found, i) || is_invariant(written, map.expression);
        }
        return found;
    });
}

}  // namespace

std::optional<SceneSymmetries> symmetries_within_a_second(const Scene& scene,
                                                          const UnrollWish& wish) {
    return within_a_second([&] { return find_symmetries(scene, wish); });
}

Watched watch(Scene& scene, const UnrollWish& wish) {
    Watched result = by_unrolling(
        scene, wish,
        [&](const UnrollDecision&) {
            return look(scene, [&] { return symmetries_of_families(scene); });
        },
        [&](const WrittenOutScene& written, const UnrollDecision&) {
            return watch_written_out(scene, written);
        });
    if (!result.found || !result.found->depends_on_time) result.names.emplace_back("energy");
    for (const NamedIndexed& invariant : scene.invariants) result.names.push_back(invariant.name);
    return result;
}

std::vector<Statement> Watched::statements(const KeepingFacts& method) const {
    if (!found) return {};
    std::vector<Statement> all = hvi::gen::statements(*found, method);
    std::erase_if(all, [&](const Statement& statement) {
        return std::find(names.begin(), names.end(), statement.name) == names.end();
    });
    return all;
}

}  // namespace hvi::gen

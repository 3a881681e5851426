// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symmetry/watched.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "generator/support/warning.hpp"
#include "generator/support/work.hpp"
#include "generator/symmetry/families.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t most_searched = 24;         ///< degrees of freedom
constexpr std::size_t most_beside_rotations = 3;  ///< coordinates: of two bodies it takes seconds
constexpr std::size_t most_added = 16;

/// Whether it is a single momentum, which a table of a run has anyway.
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

bool has_name(const WrittenOutScene& scene, const std::string& name) {
    const auto is_it = [&](const auto& named) { return named.name == name; };
    const std::vector<std::string> names = variables(scene);
    return std::any_of(scene.invariants.begin(), scene.invariants.end(), is_it) ||
           std::any_of(scene.parameters.begin(), scene.parameters.end(), is_it) ||
           std::find(names.begin(), names.end(), name) != names.end();
}

void add_momentum_maps(WrittenOutScene& scene, SceneSymmetries& found) {
    std::size_t added = 0;
    for (std::size_t i = 0; i < found.momentum_maps.size() && added < most_added; ++i) {
        ConservedQuantity& map = found.momentum_maps[i];
        map.is_said = is_momentum(found, i) || is_invariant(scene, map.expression);
        if (map.is_said) continue;
        map.name = "momentum_map_" + std::to_string(++added);
        while (has_name(scene, map.name)) map.name += "_";
        const auto source =
            std::make_shared<const Source>(Source{map.name, to_text(map.expression)});
        scene.invariants.push_back({map.name, map.expression, whole(source)});
    }
}

void add_fields(WrittenOutScene& scene, const SceneSymmetries& found) {
    for (const ConservedQuantity& field : found.fields) {
        const auto source =
            std::make_shared<const Source>(Source{field.name, to_text(field.expression)});
        scene.invariants.push_back({field.name, field.expression, whole(source)});
    }
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

/// What is done with the work that a run has for it; empty where that is not enough.
template <class Find>
auto within_a_second(Find find) -> std::optional<decltype(find())> {
    const WorkLimit limit(work_of_a_second);
    try {
        return find();
    } catch (const WorkLimitReached&) { return {}; }
}

/// What both kinds of scenes have: a search that may be refused, or take too long. `add` gives what
/// the scene's invariants are with what is found.
template <class AnyScene, class Add>
void look(AnyScene& scene, Watched& result, Add add) {
    const auto search = [&] {
        result.found = find_symmetries(scene);
        return add();
    };
    try {
        if (auto invariants = within_a_second(search)) {
            for (const ConservedQuantity& invariant : result.found->invariants) warn_of(invariant);
            for (const ConservedQuantity& field : result.found->fields) warn_of(field);
            scene.invariants = *std::move(invariants);
        } else {
            result.found.reset();
            result.left_out = symmetry_work_is_spent;
        }
    } catch (const InputError&) {  // of functions of the user's own nothing is known
    } catch (const MathError&) {}
    if (!result.found || !result.found->depends_on_time) result.names.emplace_back("energy");
    for (const auto& invariant : scene.invariants) result.names.push_back(invariant.name);
}

}  // namespace

std::optional<SceneSymmetries> symmetries_within_a_second(const WrittenOutScene& scene) {
    return within_a_second([&] { return find_symmetries(scene); });
}

std::optional<SceneSymmetries> symmetries_within_a_second(const Scene& scene) {
    return within_a_second([&] { return find_symmetries(scene); });
}

Watched watch(WrittenOutScene& scene) {
    Watched result;
    if (function_of(scene).degrees_of_freedom() > most_searched) {
        result.left_out = "there are more than 24 degrees of freedom";
        return result;
    }
    const std::size_t turns = function_of(scene).rotations.size();
    if (turns > 0 && function_of(scene).degrees_of_freedom() > 3 * turns + most_beside_rotations) {
        result.left_out = "of several bodies it takes seconds";
        return result;
    }
    look(scene, result, [&] {
        WrittenOutScene with_more = scene;
        add_fields(with_more, *result.found);
        add_momentum_maps(with_more, *result.found);
        return with_more.invariants;
    });
    return result;
}

Watched watch(Scene& scene) {
    Watched result;
    look(scene, result, [&] {
        auto invariants = scene.invariants;
        std::size_t added = 0;
        for (ConservedQuantity& map : result.found->momentum_maps) {
            if (map.is_said || added == most_added) continue;
            map.name = "momentum_map_" + std::to_string(++added);
            const auto is_it = [&](const auto& named) { return named.name == map.name; };
            while (std::any_of(invariants.begin(), invariants.end(), is_it) ||
                   std::any_of(scene.parameters.begin(), scene.parameters.end(), is_it))
                map.name += "_";
            const auto source =
                std::make_shared<const Source>(Source{map.name, to_text(map.expression)});
            invariants.push_back(
                {map.name, {map.expression, source}, whole(source), whole(source)});
        }
        return invariants;
    });
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

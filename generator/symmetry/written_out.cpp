// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symmetry/written_out.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>
#include <variant>

#include "generator/expr/places.hpp"
#include "generator/hamiltonian/body_symmetries.hpp"
#include "generator/hamiltonian/fibre_rank.hpp"
#include "generator/hamiltonian/gradient.hpp"
#include "generator/hamiltonian/legendre.hpp"
#include "generator/read/names.hpp"

namespace hvi::gen {

namespace {

/// The largest mass matrix of a Lagrangian that is inverted.
constexpr std::size_t most_inverted = 3;

/// Expressions for some of the symbols.
using Meanings = std::map<std::string, Expression>;

Expression put_in(const Expression& expression, const Meanings& meanings) {
    if (expression.kind == Expression::Kind::symbol) {
        const auto found = meanings.find(expression.name);
        return found == meanings.end() ? expression : found->second;
    }
    std::vector<Expression> arguments;
    for (const Expression& argument : expression.arguments)
        arguments.push_back(put_in(argument, meanings));
    return with_arguments(expression, std::move(arguments));
}

/// A scene in q and p.
struct OfMomenta {
    Hamiltonian hamiltonian;
    Meanings velocities;  ///< velocities of a Lagrangian, as dH/dp
};

/// Returns nothing where the H of a Lagrangian is not known, or would be too long.
std::optional<OfMomenta> of_momenta(const WrittenOutScene& scene) {
    if (const auto* hamiltonian = std::get_if<Hamiltonian>(&scene.mechanics))
        return OfMomenta{with_values(*hamiltonian, scene), {}};
    const auto& lagrangian = std::get<Lagrangian>(scene.mechanics);
    const bool is_asked_for =
        !scene.invariants.empty() || !scene.fields.empty() || is_quadratic(lagrangian);
    if (!is_asked_for || lagrangian.degrees_of_freedom() > most_inverted) return {};
    try {
        Lagrangian general = lagrangian;
        general.parameters.clear();
        OfMomenta result{legendre_transform(general), {}};
        const Gradient slopes = gradient(result.hamiltonian);
        for (std::size_t i = 0; i < lagrangian.velocities.size(); ++i)
            result.velocities[lagrangian.velocities[i]] = slopes.by_momenta[i];
        result.hamiltonian = with_values(std::move(result.hamiltonian), scene);
        return result;
    } catch (const MathError&) { return {}; }
}

/// Returns the finding for p (C q + d): its bracket with H vanishes as H does not change along it.
QuantityFinding of_momentum_map(const AffineSymmetry& symmetry) {
    QuantityFinding finding;
    finding.conserved = Vanishing::proved;
    finding.bracket = Expression::integer(0);
    finding.is_momentum_map = true;
    bool moves = false;
    for (const Expression& component : symmetry.generator)
        walk(component, [&](const Expression& part) {
            moves = moves || part.kind == Expression::Kind::symbol;
            return true;
        });
    finding.quadratic = {.is_linear = !moves, .has_squares = false, .squares_stay = true};
    return finding;
}

void set_momentum_maps(SceneSymmetries& result) {
    for (const AffineSymmetry& symmetry : result.affine.basis) {
        ConservedQuantity& map = result.momentum_maps.emplace_back();
        map.kind = ConservedQuantity::Kind::momentum_map;
        map.name = "J" + std::to_string(result.momentum_maps.size());
        map.expression = symmetry.momentum_map;
        map.finding = of_momentum_map(symmetry);
    }
}

/// Returns p xi(q), (5.4), with dL/dv for p on the Lagrangian side.
Expression momentum_map(const VectorField& field, const WrittenOutScene& scene) {
    const std::vector<std::string>& coordinates = function_of(scene).coordinates;
    const auto* lagrangian = std::get_if<Lagrangian>(&scene.mechanics);
    std::vector<Expression> momenta;
    if (lagrangian != nullptr)
        momenta = gradient(*lagrangian).by_velocities;
    else
        for (const std::string& name : std::get<Hamiltonian>(scene.mechanics).momenta)
            momenta.push_back(Expression::symbol(name));
    std::vector<Expression> terms;
    for (const NamedExpression& component : field.components) {
        const auto place = std::find(coordinates.begin(), coordinates.end(), component.name);
        const auto i = static_cast<std::size_t>(place - coordinates.begin());
        terms.push_back(Expression::product({component.expression, momenta[i]}));
    }
    return without_places(Expression::sum(std::move(terms)));
}

/// Adds the quantities that the scene claims to be conserved.
void set_said(SceneSymmetries& result, const WrittenOutScene& scene) {
    using Kind = ConservedQuantity::Kind;
    for (const NamedExpression& invariant : scene.invariants)
        result.invariants.push_back({Kind::invariant,
                                     invariant.name,
                                     invariant.expression,
                                     {},
                                     invariant.place,
                                     false,
                                     scene.approximate.count(invariant.name) != 0});
    for (const VectorField& field : scene.fields)
        result.fields.push_back(
            {Kind::field, field.name, momentum_map(field, scene), {}, field.place});
}

/// NOTE: momentum maps come first: invariants may be combinations of them.
void set_findings(SceneSymmetries& result, const OfMomenta& motion) {
    std::vector<Quantity> quantities;
    std::vector<ConservedQuantity*> targets;
    for (ConservedQuantity& map : result.momentum_maps) {
        quantities.push_back({put_in(map.expression, motion.velocities), nullptr});
        targets.push_back(nullptr);
    }
    for (ConservedQuantity& invariant : result.invariants) {
        quantities.push_back(
            {put_in(invariant.expression, motion.velocities), invariant.place.source});
        targets.push_back(&invariant);
    }
    for (ConservedQuantity& field : result.fields) {
        quantities.push_back({put_in(field.expression, motion.velocities), field.place.source});
        targets.push_back(&field);
    }
    if (!result.depends_on_time) {
        result.energy = ConservedQuantity{
            ConservedQuantity::Kind::energy, "energy", motion.hamiltonian.expression, {}, {}};
        quantities.push_back({motion.hamiltonian.expression, motion.hamiltonian.source});
        targets.push_back(&*result.energy);
    }
    const std::vector<QuantityFinding> found = findings(motion.hamiltonian, quantities);
    for (std::size_t i = 0; i < found.size(); ++i)
        if (targets[i] != nullptr) targets[i]->finding = found[i];
}

}  // namespace

namespace {

/// Finds whether invariants of rotating bodies are conserved, and whether they are momentum maps.
void set_findings_of_bodies(SceneSymmetries& result, const Hamiltonian& hamiltonian) {
    std::vector<Expression> maps;
    for (const ConservedQuantity& map : result.momentum_maps) maps.push_back(map.expression);
    std::vector<Quantity> quantities;
    for (const ConservedQuantity& invariant : result.invariants)
        quantities.push_back({invariant.expression, invariant.place.source});
    const std::vector<QuantityFinding> found = body_findings(hamiltonian, quantities, maps);
    for (std::size_t i = 0; i < found.size(); ++i) result.invariants[i].finding = found[i];
}

void look_at_bodies(SceneSymmetries& result, const WrittenOutScene& scene) {
    const Hamiltonian H = with_values(hamiltonian_of(scene), scene);
    result.rotations = H.rotations.size();
    result.affine = body_symmetries(H);
    result.rank = fibre_rank(H);
    set_momentum_maps(result);
    set_said(result, scene);
    set_findings_of_bodies(result, H);
}

}  // namespace

SceneSymmetries symmetries_of(const WrittenOutScene& scene) {
    const MechanicalFunction& function = function_of(scene);
    if (function.degrees_of_freedom() > most_degrees_of_symmetries)
        throw MathError(fmt::format("symmetries of more than {} degrees of freedom are looked for "
                                    "where sums stay loops",
                                    most_degrees_of_symmetries),
                        whole(function.source), "equations without loops are too many to solve");
    SceneSymmetries result;
    result.name = scene.name.empty() ? function_of(scene).origin : scene.name;
    result.coordinates = function_of(scene).coordinates;
    result.degrees_of_freedom = function_of(scene).degrees_of_freedom();
    result.depends_on_time = depends_on_time(function_of(scene).expression);
    if (std::holds_alternative<Lagrangian>(scene.mechanics)) result.side = Side::lagrangian;
    if (!function_of(scene).rotations.empty()) {
        look_at_bodies(result, scene);
        return result;
    }
    result.affine = std::visit(
        [&](const auto& mechanics) { return affine_symmetries(with_values(mechanics, scene)); },
        scene.mechanics);
    result.rank =
        std::visit([&](const auto& mechanics) { return fibre_rank(with_values(mechanics, scene)); },
                   scene.mechanics);
    set_momentum_maps(result);
    set_said(result, scene);
    if (const auto motion = of_momenta(scene)) set_findings(result, *motion);
    return result;
}

}  // namespace hvi::gen

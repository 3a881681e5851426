// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/named_system.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "generator/lower/accesses.hpp"
#include "generator/lower/lower.hpp"
#include "generator/lower/slopes.hpp"

namespace hvi::gen {
namespace {

/// A system, and the values of symbols in its expressions.
struct NamedSystem {
    System system;
    Symbols symbols;

    Node input(const std::string& name, Role role) {
        const Scaled node = system.graph.input(name, role);
        symbols[name] = node;
        return node.node;
    }

    /// Adds the numbers of a family, with their names as inputs.
    void add(FamilyKind kind, SystemFamily family, const std::vector<std::string>& names) {
        const bool is_q = kind == FamilyKind::coordinate;
        std::vector<SystemFamily>& families = is_q ? system.coordinates : system.conjugates;
        for (std::size_t k = 0; k < names.size(); ++k) {
            const Node node = input(names[k], is_q ? Role::coordinate : Role::conjugate);
            system.accesses.push_back({kind, families.size(), {}, node, k});
        }
        families.push_back(std::move(family));
    }

    /// Adds numbers by their names, then the numbers of rotations.
    void add(FamilyKind kind, const std::vector<std::string>& names,
             const std::vector<RotationNames>& rotations) {
        const bool is_q = kind == FamilyKind::coordinate;
        const Space& space = is_q ? rotations_of_space : angular_momenta;
        const std::size_t numbers = names.size() - space.point * rotations.size();
        for (std::size_t k = 0; k < numbers; ++k) { add(kind, {names[k]}, {names[k]}); }
        for (const RotationNames& each : rotations) {
            const std::string& name = is_q ? each.rotation : each.momentum;
            add(kind, {name, {}, space}, is_q ? entries_of(name) : components_of(name));
        }
    }
};

void add_variables(NamedSystem& result, const Hamiltonian& hamiltonian) {
    result.add(FamilyKind::coordinate, hamiltonian.coordinates, hamiltonian.rotations);
    result.add(FamilyKind::conjugate, hamiltonian.momenta, hamiltonian.rotations);
}

void add_variables(NamedSystem& result, const Lagrangian& lagrangian) {
    result.system.side = Side::lagrangian;
    result.system.momenta = momentum_names(lagrangian);
    result.add(FamilyKind::coordinate, lagrangian.coordinates, {});
    result.add(FamilyKind::conjugate, lagrangian.velocities, {});
}

/// Adds turns of the rotations as accesses, which derivatives are taken by.
void add_turns(System& system) {
    for (std::size_t f = flat_coordinates(system); f < system.coordinates.size(); ++f) {
        for (std::size_t axis = 0; axis < system.coordinates[f].space.tangent; ++axis) {
            system.accesses.push_back({FamilyKind::turn, f, {}, 0, axis});
        }
    }
}

/// Returns a value as a sum without loops.
SystemSum term(const System& system, const Scaled& value) {
    return {{}, value, accesses_in(system, {value}), {}, {}};
}

template <class Function>
NamedSystem lowered(const Function& function, const std::vector<std::string>& parameters) {
    NamedSystem result;
    System& system = result.system;
    system.expression = function.expression;
    add_variables(result, function);
    if (depends_on_time(function)) { system.time = result.input("t", Role::time); }
    for (const std::string& name : parameters) { result.input(name, Role::parameter); }
    for (const Parameter& fixed : function.parameters) {
        result.symbols[fixed.name] = lower(system.graph, fixed.value, {}, fixed.place.source);
    }
    const Scaled value = lower(system.graph, function.expression, result.symbols, function.source);
    add_turns(system);
    system.sums = {differentiated(system, {{}, value, {}, {}, {}})};
    return result;
}

std::vector<SystemValue> values(NamedSystem& into,
                                const std::vector<NamedExpression>& expressions) {
    std::vector<SystemValue> result;
    for (const NamedExpression& each : expressions) {
        const Scaled value =
            lower(into.system.graph, each.expression, into.symbols, each.place.source);
        result.push_back({each.name, each.expression, {term(into.system, value)}});
    }
    return result;
}

/// Returns the initial values of each family; empty where there are no expressions.
std::vector<SystemStart> starts(NamedSystem& into,
                                const std::vector<NamedExpression>& expressions) {
    std::vector<SystemStart> result;
    if (expressions.empty()) { return result; }
    std::size_t next = 0;
    for (const auto* families : {&into.system.coordinates, &into.system.conjugates}) {
        for (const SystemFamily& family : *families) {
            std::vector<Scaled> numbers;
            for (std::size_t k = 0; k < family.space.point; ++k, ++next) {
                const NamedExpression& each = expressions.at(next);
                numbers.push_back(
                    lower(into.system.graph, each.expression, into.symbols, each.place.source));
            }
            if (numbers.size() == 1) {
                result.push_back({SystemStart::Rule{{}, numbers.front()}});
            } else {
                result.push_back({SystemStart::List{std::move(numbers)}});
            }
        }
    }
    return result;
}

}  // namespace

System named_system(const Hamiltonian& hamiltonian, const std::vector<std::string>& parameters) {
    return lowered(hamiltonian, parameters).system;
}

System named_system(const WrittenOutScene& scene) {
    const std::vector<Parameter>& fixed = function_of(scene).parameters;
    std::vector<Parameter> parameters = scene.parameters;
    std::erase_if(parameters, [&](const Parameter& parameter) {
        return std::any_of(fixed.begin(), fixed.end(),
                           [&](const Parameter& other) { return other.name == parameter.name; });
    });
    std::vector<std::string> names;
    for (const Parameter& parameter : parameters) { names.push_back(parameter.name); }
    NamedSystem result =
        std::visit([&](const auto& function) { return lowered(function, names); }, scene.mechanics);
    System& system = result.system;
    system.name = scene.name;
    system.description = scene.description;
    system.own_headers = scene.own.includes();
    for (const auto& [name, value] : function_of(scene).sizes) {
        system.sizes.push_back({name, value});
    }
    for (const Parameter& parameter : parameters) {
        system.parameters.push_back(
            {parameter.name, parameter.value, result.symbols.at(parameter.name).node});
    }
    if (scene.scaled) {
        const Scaled energy =
            lower(system.graph, scene.scaled->energy, result.symbols, function_of(scene).source);
        system.scaled = scene.scaled;
        system.energy = {term(system, energy)};
    }
    system.initial = starts(result, scene.initial);
    system.invariants = values(result, scene.invariants);
    return std::move(system);
}

}  // namespace hvi::gen

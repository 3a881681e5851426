// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/system.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "generator/lower/derivative.hpp"
#include "generator/lower/lower.hpp"
#include "generator/lower/structure.hpp"
#include "generator/lower/turns.hpp"

namespace hvi::gen {
namespace {

/// A system, and what the symbols of its expressions stand for.
struct NamedSystem {
    System system;
    Symbols symbols;

    Node input(const std::string& name, Role role) {
        const Scaled node = system.graph.input(name, role);
        symbols[name] = node;
        return node.node;
    }
};

void add_gradient(System& system) {
    std::vector<Node> variables = system.q;
    variables.insert(variables.end(), system.conjugates.begin(), system.conjugates.end());
    const std::vector<Scaled> slopes = gradient(system.graph, system.function, variables);
    const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(system.q.size());
    system.by_q = by_turns(system, {slopes.begin(), middle});
    system.by_conjugates.assign(middle, slopes.end());
}

void set_variables(System& system, const Hamiltonian& hamiltonian) {
    system.momenta = hamiltonian.momenta;
    for (const RotationNames& names : hamiltonian.rotations) {
        system.rotations.push_back({names.rotation, names.momentum});
    }
}

void set_variables(System& system, const Lagrangian& lagrangian) {
    system.side = Side::lagrangian;
    system.momenta = momentum_names(lagrangian);
    system.velocities = lagrangian.velocities;
}

/// H, or v dL/dv - L.
Scaled energy(System& system) {
    if (system.side == Side::hamiltonian) { return system.function; }
    std::vector<Scaled> terms{system.graph.times({-1, 1}, system.function)};
    for (std::size_t k = 0; k < system.conjugates.size(); ++k) {
        terms.push_back(
            system.graph.product({{1, 1}, system.conjugates[k]}, system.by_conjugates[k]));
    }
    return system.graph.sum(std::move(terms));
}

template <class Function>
NamedSystem named_system(const Function& function, const std::vector<std::string>& parameters) {
    NamedSystem result;
    System& system = result.system;
    system.expression = function.expression;
    system.coordinates = function.coordinates;
    set_variables(system, function);
    const bool has_velocities = system.side == Side::lagrangian;
    for (const std::string& name : system.coordinates) {
        system.q.push_back(result.input(name, Role::coordinate));
    }
    for (const std::string& name : has_velocities ? system.velocities : system.momenta) {
        system.conjugates.push_back(result.input(name, Role::conjugate));
    }
    if (depends_on_time(function)) { system.time = result.input("t", Role::time); }
    for (const std::string& name : parameters) { result.input(name, Role::parameter); }
    for (const Parameter& fixed : function.parameters) {
        result.symbols[fixed.name] = lower(system.graph, fixed.value, {}, fixed.place.source);
    }
    system.function = lower(system.graph, function.expression, result.symbols, function.source);
    add_gradient(system);
    system.hessian = hessian(system);
    // NOTE: no step for an L, or of rotations, takes anything of that.
    if (system.side == Side::hamiltonian && system.rotations.empty()) {
        system.structure = structure(system);
    }
    system.energy = energy(system);
    return result;
}

std::vector<SystemValue> values(NamedSystem& into,
                                const std::vector<NamedExpression>& expressions) {
    std::vector<SystemValue> result;
    for (const NamedExpression& each : expressions) {
        result.push_back(
            {each.name, each.expression,
             lower(into.system.graph, each.expression, into.symbols, each.place.source)});
    }
    return result;
}

LinearPart linear_part(const ConstantTerms& constant) {
    if (const auto* components = std::get_if<std::vector<LinearStiffness>>(&constant)) {
        StiffComponents stiff;
        for (const LinearStiffness& linear : *components) {
            stiff.components.push_back(linear.component);
        }
        return stiff;
    }
    return std::holds_alternative<Hessian>(constant) ? LinearPart{CoupledConstants{}}
                                                     : LinearPart{};
}

}  // namespace

System system_of(const Hamiltonian& hamiltonian, const std::vector<std::string>& parameters) {
    System system = named_system(hamiltonian, parameters).system;
    verify(system);
    return system;
}

System system_of(const Scene& scene) {
    const std::vector<Parameter>& fixed = function_of(scene).parameters;
    std::vector<Parameter> parameters = scene.parameters;
    std::erase_if(parameters, [&](const Parameter& parameter) {
        return std::any_of(fixed.begin(), fixed.end(),
                           [&](const Parameter& other) { return other.name == parameter.name; });
    });
    std::vector<std::string> names;
    for (const Parameter& parameter : parameters) { names.push_back(parameter.name); }
    NamedSystem result = std::visit(
        [&](const auto& function) { return named_system(function, names); }, scene.mechanics);
    System& system = result.system;
    system.name = scene.name;
    system.description = scene.description;
    system.own_headers = scene.own.includes();
    for (const Parameter& parameter : parameters) {
        system.parameters.push_back(
            {parameter.name, parameter.value, result.symbols.at(parameter.name).node});
    }
    system.initial = values(result, scene.initial);
    system.invariants = values(result, scene.invariants);
    verify(system);
    return std::move(system);
}

SystemProperties properties(const System& system, const GradientKernels& gradients) {
    return {
        .side = system.side,
        .is_separable = system.structure.is_separable,
        .depends_on_time = system.time.has_value(),
        .kinetic_is_quadratic = system.structure.kinetic_is_quadratic,
        .has_diagonal_mass = system.structure.has_diagonal_mass,
        .has_linear_map = system.structure.has_linear_map,
        .is_degenerate = system.rotations.empty() && is_degenerate(system.hessian),
        .degrees_of_freedom = system.degrees_of_freedom(),
        .rotations = system.rotations.size(),
        .linear = linear_part(system.structure.constant),
        .costs = evaluation_costs(system, gradients),
        .shared_slopes = gradients.shared.size(),
    };
}

}  // namespace hvi::gen

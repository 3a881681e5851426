// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/system.hpp"

#include <utility>
#include <variant>

#include "generator/lower/energy.hpp"
#include "generator/lower/loop_legendre.hpp"
#include "generator/lower/loop_system.hpp"
#include "generator/lower/named_system.hpp"
#include "generator/lower/sites.hpp"
#include "generator/lower/structure.hpp"
#include "generator/lower/totals.hpp"

namespace hvi::gen {
namespace {

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

System passed(System system, const std::vector<SystemPass>& passes) {
    for (const SystemPass& pass : passes) { system = pass(std::move(system)); }
    return system;
}

/// Returns the system with all findings. NOTE: no later stage changes the system.
System with_all_found(System system) {
    system = passed(std::move(system),
                    {with_energy, with_slopes_through_totals, with_sites, with_structure});
    verify(system);
    return system;
}

}  // namespace

System system_of(const Hamiltonian& hamiltonian, const std::vector<std::string>& parameters) {
    return with_all_found(named_system(hamiltonian, parameters));
}

System system_of(const WrittenOutScene& scene, const std::vector<SystemPass>& passes) {
    return with_all_found(passed(named_system(scene), passes));
}

System system_of(const Scene& scene, const std::vector<SystemPass>& passes) {
    System system = loop_system(scene);
    if (scene.side == Side::lagrangian) {
        system = legendre_transform(std::move(system), whole(scene.function.source));
    }
    return with_all_found(passed(std::move(system), passes));
}

SystemProperties properties(const System& system) {
    const Structure& found = system.structure;
    SystemProperties result{
        .side = system.side,
        .is_separable = found.is_separable,
        .depends_on_time = system.time.has_value(),
        .kinetic_is_quadratic = found.kinetic_is_quadratic,
        .has_diagonal_mass = found.has_diagonal_mass,
        .has_linear_map = found.has_linear_map,
        .degrees_of_freedom = system.degrees_of_freedom(),
        .rotations = bodies_of(system),
        .linear = linear_part(found.constant),
        .container = system.is_written_out() ? Container::arrays : Container::vectors,
        .parts = system.parts ? system.parts->parts.size() : 0,
        .small_steps = system.parts ? system.parts->small_steps : SmallSteps{},
        .clock = system.parts ? system.parts->clock : std::nullopt,
        .is_lattice = system.sites.has_value(),
        .hessian = found.hessian,
    };
    if (const auto* second = std::get_if<Hessian>(&system.second)) {
        result.is_degenerate = result.rotations == 0 && is_degenerate(*second);
    }
    return result;
}

SystemProperties properties(const System& system, const GradientKernels& gradients) {
    SystemProperties result = properties(system);
    result.costs = evaluation_costs(system, gradients);
    result.shared_slopes = gradients.shared.size();
    return result;
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/hamiltonian_scene.hpp"

#include <cstddef>
#include <map>
#include <utility>

#include "generator/hamiltonian/gradient.hpp"
#include "generator/hamiltonian/legendre.hpp"

namespace hvi::gen {

namespace {

using Replacements = std::map<std::string, Expression>;

/// Returns the expressions of H for the velocities: dH/dp.
Replacements velocities_of(const Lagrangian& L, const Hamiltonian& H) {
    const std::vector<Expression> by_momenta = gradient(H).by_momenta;
    Replacements result;
    for (std::size_t k = 0; k < L.velocities.size(); ++k) result[L.velocities[k]] = by_momenta[k];
    return result;
}

/// Replaces the initial velocities by momenta.
void begin_with_momenta(std::vector<NamedExpression>& initial, const Lagrangian& L,
                        const Hamiltonian& H) {
    if (initial.empty()) return;
    Replacements start;
    for (const NamedExpression& each : initial) start[each.name] = each.expression;
    const std::vector<Expression> momenta = gradient(L).by_velocities;
    const std::size_t n = momenta.size();
    for (std::size_t k = 0; k < n; ++k) {
        NamedExpression& p = initial.at(n + k);
        p.name = H.momenta[k];
        p.expression = replaced(momenta[k], start);
    }
}

}  // namespace

WrittenOutScene with_hamiltonian(WrittenOutScene scene) {
    const auto* of_scene = std::get_if<Lagrangian>(&scene.mechanics);
    if (of_scene == nullptr) return scene;
    const Lagrangian L = *of_scene;
    Hamiltonian H = legendre_transform(L);
    H.sizes = L.sizes;
    const Replacements velocities = velocities_of(L, H);
    const auto replace = [&](NamedExpression& each) {
        each.expression = replaced(each.expression, velocities);
    };
    for (NamedExpression& invariant : scene.invariants) replace(invariant);
    for (SceneEvent& event : scene.events) {
        if (!event.set.empty())
            throw InputError("events of a Lagrangian set nothing", event.set.front().place,
                             "write the Hamiltonian, which `hvi-gen scheme` prints");
        replace(event.zero);
    }
    if (scene.scale) replace(scene.scale->expression);
    begin_with_momenta(scene.initial, L, H);
    scene.exact.clear();
    scene.mechanics = std::move(H);
    return scene;
}

}  // namespace hvi::gen

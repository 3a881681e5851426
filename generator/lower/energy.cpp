// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/energy.hpp"

#include <utility>

#include "generator/lower/accesses.hpp"

namespace hvi::gen {

namespace {

/// Returns v dL/dv - L.
Scaled energy_of_L(System& system) {
    std::vector<Scaled> terms{system.graph.times({-1, 1}, function_of(system))};
    const std::vector<Node> v = conjugate_nodes(system);
    const std::vector<Scaled> momenta = by_conjugates(system);
    for (std::size_t k = 0; k < v.size(); ++k) {
        terms.push_back(system.graph.product({{1, 1}, v[k]}, momenta[k]));
    }
    return system.graph.sum(std::move(terms));
}

}  // namespace

System with_energy(System system) {
    if (!system.energy.empty()) { return system; }  // energy of a pass that has made another H
    system.energy = system.sums;
    if (system.side == Side::lagrangian) {
        const Scaled value = energy_of_L(system);
        system.energy = {{{}, value, accesses_in(system, {value}), {}, {}}};
    }
    return system;
}

}  // namespace hvi::gen

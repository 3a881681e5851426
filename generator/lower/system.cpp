// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/system.hpp"

#include "generator/lower/derivative.hpp"

namespace hvi::gen {

SystemGraph system_graph(const Hamiltonian& hamiltonian,
                         const std::vector<std::string>& parameters) {
    SystemGraph system;
    const auto input = [&](const std::string& name, Role role) {
        const Scaled node = system.graph.input(name, role);
        system.symbols[name] = node;
        return node.node;
    };
    for (const std::string& name : hamiltonian.coordinates) {
        system.q.push_back(input(name, Role::coordinate));
    }
    for (const std::string& name : hamiltonian.momenta) {
        system.p.push_back(input(name, Role::momentum));
    }
    if (depends_on_time(hamiltonian)) { system.time = input("t", Role::time); }
    for (const std::string& name : parameters) { input(name, Role::parameter); }
    for (const Parameter& fixed : hamiltonian.parameters) {
        system.symbols[fixed.name] = lower(system.graph, fixed.value, {}, fixed.place.source);
    }
    system.hamiltonian =
        lower(system.graph, hamiltonian.expression, system.symbols, hamiltonian.source);

    std::vector<Node> variables = system.q;
    variables.insert(variables.end(), system.p.begin(), system.p.end());
    const std::vector<Scaled> slopes = gradient(system.graph, system.hamiltonian, variables);
    const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(system.q.size());
    system.dHdq.assign(slopes.begin(), middle);
    system.dHdp.assign(middle, slopes.end());
    return system;
}

}  // namespace hvi::gen

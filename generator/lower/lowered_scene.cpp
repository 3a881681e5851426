// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/lowered_scene.hpp"

#include <utility>

namespace hvi::gen {

LoweredScene lowered(const Scene& scene) {
    std::vector<std::string> parameters;
    for (const Parameter& parameter : scene.parameters) { parameters.push_back(parameter.name); }

    LoweredScene result;
    result.scene = scene;
    result.system = system_graph(scene.hamiltonian, parameters);
    result.structure = structure(result.system);
    const auto all = [&](const std::vector<NamedExpression>& expressions) {
        std::vector<Scaled> values;
        for (const NamedExpression& each : expressions) {
            values.push_back(lower(result.system.graph, each.expression, result.system.symbols));
        }
        return values;
    };
    result.initial = all(scene.initial);
    result.invariants = all(scene.invariants);
    return result;
}

}  // namespace hvi::gen

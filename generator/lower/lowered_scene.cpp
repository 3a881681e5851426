// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/lowered_scene.hpp"

#include <algorithm>
#include <utility>

namespace hvi::gen {

LoweredScene lowered(const Scene& scene) {
    LoweredScene result;
    result.scene = scene;
    const std::vector<Parameter>& fixed = scene.hamiltonian.parameters;
    std::erase_if(result.scene.parameters, [&](const Parameter& parameter) {
        return std::any_of(fixed.begin(), fixed.end(),
                           [&](const Parameter& other) { return other.name == parameter.name; });
    });
    std::vector<std::string> parameters;
    for (const Parameter& parameter : result.scene.parameters) {
        parameters.push_back(parameter.name);
    }
    result.system = system_graph(scene.hamiltonian, parameters);
    result.structure = structure(result.system);
    const auto all = [&](const std::vector<NamedExpression>& expressions) {
        std::vector<Scaled> values;
        for (const NamedExpression& each : expressions) {
            values.push_back(lower(result.system.graph, each.expression, result.system.symbols,
                                   each.place.source));
        }
        return values;
    };
    result.initial = all(scene.initial);
    result.invariants = all(scene.invariants);
    result.gradients = gradient_kernels(result.system);
    verify(result);
    return result;
}

}  // namespace hvi::gen

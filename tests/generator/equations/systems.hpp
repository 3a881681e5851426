// Methods and Hamiltonians from text, and one step by numbers, for the tests of their equations.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/equations/step_equations.hpp"
#include "generator/exact/methods/galerkin.hpp"
#include "tests/generator/hamiltonian/dual.hpp"
#include "tests/generator/read/refusal.hpp"

namespace hvi::gen {

inline Method method(const std::string& name) { return named_method(source(name, "--method")); }

inline Method method(const std::string& basis, const std::string& nodes) {
    return method_from_text(source(basis, "--basis"), source(nodes, "--nodes"));
}

inline Hamiltonian hamiltonian(const std::string& text) {
    return hamiltonian_from_text(source(text, "--hamiltonian"));
}

inline Hamiltonian hamiltonian(const std::string& text, const std::string& coordinates,
                               const std::string& momenta) {
    return hamiltonian_from_text(source(text, "--hamiltonian"), source(coordinates),
                                 source(momenta));
}

/// Returns values for free symbols: h, the parameters and the variables at the beginning of a step.
inline Point some_point(const Hamiltonian& H) {
    Point point{{"h", {0.05L}}};
    Real value = 0.3L;
    for (const std::string& name : variables(H)) point[name] = {value += 0.17L};
    for (const std::string& name : parameter_names(H)) point[name] = {value += 0.11L};
    return point;
}

/// Returns the variables at the end of the step by the equations. The equations of the stages are
/// evaluated repeatedly until nothing changes.
inline std::map<std::string, Real> solved(const StageEquations& equations, Point point) {
    const Point start = point;
    for (const Equation& stage : equations.stages) point[stage.left] = {0.4L};
    for (int round = 0; round < 200; ++round)
        for (const Equation& stage : equations.stages)
            point[stage.left] = evaluate(stage.right, point);
    std::map<std::string, Real> result;
    for (const Equation& update : equations.update)
        result[update.left] = evaluate(update.right, point).value;
    return result;
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/start.hpp"

#include "generator/exact/value_at.hpp"

namespace hvi::gen {

namespace {

/// NOTE: the place of a parameter is that of all it says, and its value has no text of its own.
Ball value_of(const Parameter& parameter) {
    try {
        return value_at(parameter.value, {}, nullptr);
    } catch (const MathError& error) {
        throw MathError("`" + parameter.name + "` has no value: " + error.what(), parameter.place);
    }
}

}  // namespace

void check_start(const Scene& scene) {
    if (scene.initial.empty()) { return; }
    SymbolValues values;
    for (const Parameter& parameter : scene.parameters) {
        values[parameter.name] = value_of(parameter);
    }
    SymbolValues at_start = values;
    at_start["t"] = Ball();
    for (const NamedExpression& initial : scene.initial) {
        at_start[initial.name] = value_at(initial.expression, values, initial.place.source);
    }
    (void)value_at(scene.hamiltonian.expression, at_start, scene.hamiltonian.source);
    for (const NamedExpression& invariant : scene.invariants) {
        (void)value_at(invariant.expression, at_start, invariant.place.source);
    }
}

}  // namespace hvi::gen

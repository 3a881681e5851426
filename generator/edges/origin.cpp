// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/edges/origin.hpp"

#include "generator/expr/own_functions.hpp"
#include "generator/hamiltonian/gradient.hpp"
#include "generator/scene/start.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

Origin origin_of(const WrittenOutScene& scene) {
    if (!std::holds_alternative<Hamiltonian>(scene.mechanics)) return Origin::other;
    if (!hamiltonian_of(scene).rotations.empty()) return Origin::singular;
    if (own_call_in(hamiltonian_of(scene).expression) != nullptr) return Origin::other;
    SymbolValues values = parameter_values(scene);
    for (const auto* names : {&hamiltonian_of(scene).coordinates, &hamiltonian_of(scene).momenta})
        for (const std::string& name : *names) values[name] = Ball();
    values["t"] = Ball();
    const Gradient derivatives = gradient(hamiltonian_of(scene));
    Origin origin = Origin::rest;
    for (const auto* parts : {&derivatives.by_coordinates, &derivatives.by_momenta})
        for (const Expression& part : *parts) {
            try {
                const Ball value = value_at(part, values, nullptr);
                if (arb_is_zero(value.get()) == 0) origin = Origin::other;
            } catch (const MathError&) { return Origin::singular; }
        }
    return origin;
}

}  // namespace hvi::gen

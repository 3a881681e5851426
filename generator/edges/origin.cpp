// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/edges/origin.hpp"

#include "generator/expr/own_functions.hpp"
#include "generator/hamiltonian/gradient.hpp"
#include "generator/scene/start.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

Origin origin_of(const Scene& scene) {
    if (scene.side == Side::lagrangian) return Origin::other;
    const WrittenOutScene written = unrolled(scene);
    const Hamiltonian& H = hamiltonian_of(written);
    if (!H.rotations.empty()) return Origin::singular;
    if (own_call_in(H.expression) != nullptr) return Origin::other;
    SymbolValues values = parameter_values(written);
    for (const auto* names : {&H.coordinates, &H.momenta})
        for (const std::string& name : *names) values[name] = Ball();
    values["t"] = Ball();
    const Gradient derivatives = gradient(H);
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

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ir/properties.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/expr/space.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

std::string_view text(HessianForm form) {
    switch (form) {
    case HessianForm::dense: return "dense";
    case HessianForm::band: return "band";
    case HessianForm::sparse: return "sparse";
    case HessianForm::products: return "products";
    case HessianForm::none: return "none";
    }
    HVI_CHECK(false);
    return {};
}

std::string text(const LinearPart& part) {
    const auto* stiff = std::get_if<StiffComponents>(&part);
    if (stiff == nullptr) { return exists(part) ? "linear part: coupled\n" : ""; }
    return fmt::format("linear part: components {}\n", fmt::join(stiff->components, " "));
}

}  // namespace

std::string_view to_text(Container container) {
    switch (container) {
    case Container::of_user: return "the user's";
    case Container::arrays: return "arrays";
    case Container::vectors: return "of any size";
    }
    HVI_CHECK(false);
    return {};
}

std::string dump(const SystemProperties& system) {
    std::string result =
        fmt::format("side: {}\ndegrees of freedom: {}\nrotations: {}\nvectors: {}\nd2H/dq2: {}\n",
                    system.side == Side::hamiltonian ? 'H' : 'L', system.degrees_of_freedom,
                    system.rotations, to_text(system.container), text(system.hessian));
    const auto add = [&](bool holds, std::string_view what) {
        if (holds) { result += fmt::format("found: {}\n", what); }
    };
    add(system.is_separable, "T(p) + U(q)");
    add(system.depends_on_time, "the time");
    add(system.kinetic_is_quadratic, "T is quadratic");
    add(system.has_diagonal_mass, "K is diagonal");
    add(system.has_linear_map, "steps are linear maps");
    add(system.is_degenerate, "d2H/dp2 has a row of zeros");
    add(system.is_lattice, "a lattice");
    if (system.parts > 0) { result += fmt::format("parts: {}\n", system.parts); }
    if (system.clock) { result += fmt::format("clock: part {}\n", *system.clock + 1); }
    if (const SmallSteps& small = system.small_steps; small.exist()) {
        result += fmt::format("fast parts: {}, in {} small steps\n", small.parts, small.count);
    }
    const EvaluationCosts& costs = system.costs;
    return result + text(system.linear) +
           fmt::format("costs: dH/dq {}, dH/dp at q {}, both {}, second {}{}\nshared: {}\n",
                       costs.by_q, costs.by_p_at_q, costs.joint, costs.second,
                       costs.has_calls ? ", with calls" : "", system.shared_slopes);
}

void verify(const SystemProperties& system) {
    HVI_CHECK(!system.kinetic_is_quadratic || system.is_separable);
    HVI_CHECK(!system.has_diagonal_mass || system.kinetic_is_quadratic);
    HVI_CHECK(!system.has_linear_map || !system.depends_on_time);
    HVI_CHECK(!system.is_lattice || system.container == Container::vectors);
    HVI_CHECK(system.degrees_of_freedom == 0 ||
              rotations_of_space.tangent * system.rotations <= system.degrees_of_freedom);
    HVI_CHECK(!system.small_steps.exist() || system.small_steps.parts < system.parts);
    HVI_CHECK(!system.clock || (system.depends_on_time && *system.clock < system.parts));
    HVI_CHECK(system.rotations == 0 || system.side == Side::hamiltonian);
    const auto* stiff = std::get_if<StiffComponents>(&system.linear);
    HVI_CHECK(stiff == nullptr ||
              std::all_of(stiff->components.begin(), stiff->components.end(),
                          [&](std::size_t k) { return k < system.degrees_of_freedom; }));
}

}  // namespace hvi::gen

// One step of the general Galerkin form for a quadratic Hamiltonian, in closed form.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/linear/one_step_map.hpp"

namespace hvi::gen {

/// The map (q_0, p_0) -> (q_1, p_1) of (4.6) with the step h = ground.parameter("h"), as that of a
/// tableau. Precondition: the numbers of the rule and of H are on the field of `ground`, and have
/// closed forms. Throws MathError where d2H/dp2 is singular, and TooLarge where the map would be too
/// long to compute.
[[nodiscard]] LinearMap one_step_map(const GalerkinRule& rule, const QuadraticForm& H,
                                     const Ground& ground);

}  // namespace hvi::gen

// One step of a method for a quadratic Hamiltonian, in closed form.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>

#include "generator/exact/methods/tableau.hpp"
#include "generator/exact/numbers/ground.hpp"
#include "generator/linear/quadratic_form.hpp"

namespace hvi::gen {

/// x -> matrix x + offset.
struct LinearMap {
    NumberMatrix matrix;
    NumberVector offset;
};

/// The map (q_0, p_0) -> (q_1, p_1) of (4.18) with the step h = ground.parameter("h"): rational
/// functions of h and of what is free in H and in the tableau, each in lowest terms. Where square
/// roots or sines remain in them the denominator is free of these, as in every closed form.
/// Precondition: the tableau and H are on the field of `ground`. Throws MathError where a
/// coefficient of the method or of H has no closed form, and where the map would be too long to
/// compute: with many coupled degrees of freedom, or with many parameters.
[[nodiscard]] LinearMap one_step_map(const Tableau& tableau, const QuadraticForm& H,
                                     const Ground& ground);

/// Of degrees of freedom that are not coupled each has a map of its own, and they are put together.
[[nodiscard]] LinearMap
by_uncoupled_parts(const QuadraticForm& H,
                   const std::function<LinearMap(const QuadraticForm&)>& map_of);

}  // namespace hvi::gen

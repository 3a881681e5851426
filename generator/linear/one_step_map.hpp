// One step of a method for a quadratic Hamiltonian, in closed form.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/exact/numbers/ground.hpp"
#include "generator/linear/quadratic_form.hpp"

namespace hvi::gen {

/// The map x -> matrix x + offset.
struct LinearMap {
    NumberMatrix matrix;
    NumberVector offset;
};

/// Returns the map (q_0, p_0) -> (q_1, p_1) of (4.18), or of (4.6), with the step h =
/// ground.parameter("h"). Its entries are rational functions of h and of the free parameters of H
/// and of the method, each in lowest terms. Where square roots or sines remain in them the
/// denominator is free of these, as in every closed form. Precondition: the method and H are on the
/// field of `ground`. Throws MathError where a coefficient of the method or of H has no closed
/// form, where the map would be too long to compute, with many coupled degrees of freedom, or with
/// many parameters, and for a rule where d2H/dp2 is singular; TooLarge for a rule of too many
/// stages.
[[nodiscard]] LinearMap one_step_map(const Tableau& tableau, const QuadraticForm& H,
                                     const Ground& ground);
[[nodiscard]] LinearMap one_step_map(const GalerkinRule& rule, const QuadraticForm& H,
                                     const Ground& ground);

}  // namespace hvi::gen

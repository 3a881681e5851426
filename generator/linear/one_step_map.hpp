// One step of a method for a quadratic Hamiltonian, in closed form.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/ground.hpp"
#include "generator/linear/quadratic_form.hpp"

namespace hvi::gen {

/// x -> matrix x + offset.
struct LinearMap {
    NumberMatrix matrix;
    NumberVector offset;
};

/// The map of (4.18) with the step h = ground.parameter("h"), in lowest terms: rational functions
/// of h and of what is free in H and in the tableau. Precondition: the tableau and H are on the
/// field of `ground`. Throws MathError where coefficients have no closed form.
[[nodiscard]] LinearMap one_step_map(const Tableau& tableau, const QuadraticForm& H,
                                     const Ground& ground);

}  // namespace hvi::gen

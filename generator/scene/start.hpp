// The start of a scene, and its known later states.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/exact/numbers/ground.hpp"
#include "generator/read/written_out_scene.hpp"
#include "generator/scene/value_at.hpp"

namespace hvi::gen {

/// Returns the value of a parameter of a scene. Throws MathError, with its place, where it has
/// none, and InputError as evaluate_number() does for numbers of an absurd size.
[[nodiscard]] Number exact_value(const Parameter& parameter, const Ground& ground);

/// Returns the values of all parameters. Throws MathError, with its place, where one has no value.
[[nodiscard]] SymbolValues parameter_values(const WrittenOutScene& scene);

/// Checks the start. Throws as exact_value() does; MathError, with its place, where the value of a
/// parameter or an initial value is provably beyond the range of coefficients, or where an initial
/// value, or H or an invariant at the start, is provably no real number: the root of a negative
/// number, a division by a mass of zero, two bodies at one place; and as check_rotations() does.
/// Checks only parameters where the scene has no initial data.
void check_start(const WrittenOutScene& scene);

/// Returns coordinates, then momenta or velocities, of the scene's [exact] at a time, good to the
/// last bit or two. Throws MathError, with its place, where there is no value. Precondition: the
/// scene has [exact].
[[nodiscard]] std::vector<double> exact_state(const WrittenOutScene& scene, double time);

}  // namespace hvi::gen

// The equations (4.18) of one step for a Hamiltonian whose sums stay loops.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/equations/loop_gradient.hpp"
#include "generator/equations/stage_equations.hpp"
#include "generator/equations/step_title.hpp"
#include "generator/read/scene.hpp"

namespace hvi::gen {

/// The equations with loops. An equation for an element with any index, `x[k]`, holds for all of
/// its family. Sizes are among the parameters that have values, and stay names. In stages and
/// update `dH_dx[k](X_1,P_1)` is a call of that name: the derivative by x[k] at values X_1 of all x
/// and P_1 of all p.
struct LoopEquations : StepTitle {
    Expression hamiltonian;  ///< sums are kept
    std::vector<SystemFamily> coordinates, momenta;
    StageEquations stages;
    LoopGradient gradient;
};

/// Returns `dH_dx[k]` for the element with the first of these indices.
[[nodiscard]] std::string slope_name(const SystemFamily& family,
                                     const std::vector<std::string>& indices);

/// Writes the equations of the stages with the exact coefficients of the method, and the
/// derivatives of H. `values` are the values of parameters that have one. Throws as system_of() and
/// derive_any() do, and NoLoops for what loop_gradient() refuses and for the general Galerkin form.
[[nodiscard]] LoopEquations loop_equations(const Method& method, Scene scene,
                                           const std::vector<Parameter>& values);

}  // namespace hvi::gen

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

/// An equation for an element with any index, `x[k]`, stands for all of its family. Sizes are among
/// the parameters that have values, and stay names. In stages and update `dH_dx[k](X_1,P_1)` is a
/// call of that name: the derivative by x[k] where all x are X_1 and all p are P_1.
struct LoopEquations : StepTitle {
    Expression hamiltonian;  ///< with its sums
    std::vector<SystemFamily> coordinates, momenta;
    StageEquations stages;
    LoopGradient gradient;
};

/// `dH_dx[k]`, of the element with the first of these indices.
[[nodiscard]] std::string slope_name(const SystemFamily& family,
                                     const std::vector<std::string>& indices);

/// The equations of the stages with the exact coefficients of the method, and the derivatives of H.
/// `values` are those of the parameters that have one. Throws what system_of() and derive_any()
/// throw, and NoLoops for what loop_gradient() refuses and for the general Galerkin form.
[[nodiscard]] LoopEquations loop_equations(const Method& method, Scene scene,
                                           const std::vector<Parameter>& values);

}  // namespace hvi::gen

// The plan of a step from a method: unknowns, evaluations, and omissions.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/one_step_method.hpp"
#include "generator/ir/properties.hpp"
#include "generator/ir/step.hpp"

namespace hvi::gen {

/// Wishes for computation side by side, where a scene gives H.
enum class Lanes {
    automatic,  ///< stages, where they can be
    stages,     ///< the stages of a step
    ensemble,   ///< trajectories that take the same steps
    gpu,        ///< nothing: a trajectory is a thread of a GPU
    none,
};

/// Wishes of the user for a step. The step says what becomes of them.
struct StepWishes {
    Solver solver = Solver::of_user;
    int sweeps = 0;  ///< of Solver::sweeps
    Lanes lanes = Lanes::none;
    bool curve = false;   ///< curve of a step, which needs its slopes
    bool action = false;  ///< action of the steps, a sum over positions, momenta and slopes

    [[nodiscard]] bool needs_slopes() const { return curve || action; }
};

/// Returns the plan of a step. Throws InputError when the method has free parameters in places that
/// parametric() refuses. The method and the result are verified.
[[nodiscard]] Step plan(const OneStepMethod& method, const SystemProperties& system,
                        const StepWishes& wishes = {});

}  // namespace hvi::gen

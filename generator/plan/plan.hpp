// From a method to a step: what is solved for, what is evaluated, what is left out.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/one_step_method.hpp"
#include "generator/ir/properties.hpp"
#include "generator/ir/step.hpp"

namespace hvi::gen {

/// What is wished to be computed side by side, where a scene says what H is.
enum class Lanes {
    automatic,  ///< stages, where they can be
    stages,     ///< the stages of a step
    ensemble,   ///< trajectories of the same parameters and steps
    none,
};

/// What the user wants of a step. What becomes of it the step says.
struct StepWishes {
    Solver solver = Solver::of_user;
    Lanes lanes = Lanes::none;
    bool curve = false;   ///< of a step: it is made of the slopes
    bool action = false;  ///< of the steps: it is a sum over positions, momenta and slopes

    [[nodiscard]] bool needs_slopes() const { return curve || action; }
};

/// Throws InputError when the method has free parameters in places that parametric() refuses. The
/// method and the result are verified.
[[nodiscard]] Step plan(const OneStepMethod& method, const SystemProperties& system,
                        const StepWishes& wishes = {});

}  // namespace hvi::gen

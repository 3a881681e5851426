// From a tableau to a step: what is solved for, what is evaluated, what is left out.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/exact/methods/composition.hpp"
#include "generator/exact/methods/tableau.hpp"
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
    bool curve = false;                           ///< the stages of a step are asked for
    std::optional<Composition> composition = {};  ///< a step is made of several of the method
    std::optional<Place> method = {};             ///< where it was given, for errors
};

/// Throws InputError when the tableau has free parameters in places that parametric() refuses.
/// Precondition: a composed method has none. The result is verified.
[[nodiscard]] Step plan(const Tableau& tableau, const SystemProperties& system,
                        const StepWishes& wishes = {});

}  // namespace hvi::gen

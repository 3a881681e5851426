// From a method and a scene to a stepper: the whole way.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

#include "generator/exact/methods/composition.hpp"
#include "generator/exact/methods/tableau.hpp"
#include "generator/lower/lowered_scene.hpp"
#include "generator/plan/scheme.hpp"
#include "generator/read/scene.hpp"

namespace hvi::gen {

/// What a stepper of a scene is to be like.
struct StepperWishes {
    Solver solver = Solver::automatic;
    Lanes lanes = Lanes::automatic;
    bool energy = false;       ///< as a member
    bool invariants = false;   ///< the same
    bool evaluations = false;  ///< of dH/dq, counted, the same
    bool float128 = false;     ///< among the numbers that it computes in
    bool dense = false;        ///< the curve of a step, the same
    std::optional<std::string> class_name =
        {};  ///< checked by check_class_name(); else from the names
    std::optional<Composition> composition = {};  ///< a step is made of several of the method
};

/// A stepper, and what was found on the way to it.
struct SceneStepper {
    Tableau tableau;
    std::string method_name;  ///< `stormer-verlet-yoshida:6`; empty where the method has no name
    LoweredScene lowered;
    Scheme scheme;
    std::string class_name;
    std::string header;
};

/// The command line `hvi-gen stepper ...` that writes the same header is quoted in it. Throws
/// InputError and MathError: for a scene that cannot start, an invariant that cannot be a member, a
/// solver that is not built for this H, and as the derivation of the method does. Preconditions:
/// those of lower().
[[nodiscard]] SceneStepper scene_stepper(const Method& method, const Scene& scene,
                                         const StepperWishes& wishes);

}  // namespace hvi::gen

// A scene whose expressions are one graph.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/lower/joint_gradient.hpp"
#include "generator/lower/structure.hpp"
#include "generator/lower/system.hpp"
#include "generator/read/scene.hpp"

namespace hvi::gen {

/// What steppers, diagnostics and the start of a run are made of.
struct LoweredScene {
    Scene scene;         ///< without the parameters that are fixed
    SystemGraph system;  ///< the graph of everything here
    Structure structure;
    GradientKernels gradients;
    std::vector<Scaled> initial;     ///< coordinates, then momenta, of the parameters; or empty
    std::vector<Scaled> invariants;  ///< in the order of the scene
};

/// Throws InputError as lower() does. Preconditions: those of lower().
[[nodiscard]] LoweredScene lowered(const Scene& scene);

}  // namespace hvi::gen

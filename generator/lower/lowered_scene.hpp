// A scene whose expressions are one graph.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
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

/// Throws InputError as lower() does. Preconditions: those of lower(). The result is verified.
[[nodiscard]] LoweredScene lowered(const Scene& scene);

/// Stable text, for people and tests: what each node computes, `#7: product #3 #4`, and which nodes
/// are H, its derivatives, the initial data and the invariants.
[[nodiscard]] std::string dump(const LoweredScene& lowered);

/// Stops the program (HVI_CHECK) where the record contradicts itself: a node that needs a later one
/// or depends on something else than its arguments, tables of other sizes than the scene.
void verify(const LoweredScene& lowered);

/// Whether the texts are.
[[nodiscard]] bool operator==(const LoweredScene& left, const LoweredScene& right);

}  // namespace hvi::gen

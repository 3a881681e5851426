// What the command line says of METHOD and SCENE, read.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/cli/options.hpp"
#include "generator/read/coefficients.hpp"
#include "generator/read/indexed_scene.hpp"
#include "generator/read/scene.hpp"

namespace hvi::gen {

/// Reads the method, and gives its parameters their values.
[[nodiscard]] Method method_of(const MethodOptions& options);

/// Reads a tableau in place of a method, and gives its parameters the same values.
[[nodiscard]] Coefficients coefficients_of(const std::filesystem::path& file,
                                           const MethodOptions& options);

/// A method, and H or L, read; the parameters of both have their values.
struct MethodAndSystem {
    Method method;
    std::variant<Hamiltonian, Lagrangian> system;
};
[[nodiscard]] MethodAndSystem read_system(const MethodOptions& options,
                                          const SystemOptions& system);

/// A method and a scene, read. A parameter that the method has too is fixed to its value; the
/// values of the others are defaults. Of --hamiltonian each needs one by --param, and the scene
/// then has neither a name nor initial data. A method that is not given is that of the scene's
/// [run].
struct MethodAndScene {
    Method method;
    Scene scene;
};
[[nodiscard]] MethodAndScene read_scene(const MethodOptions& options, const SystemOptions& system);

/// Whether a scene is named that has more degrees of freedom than are written out.
[[nodiscard]] bool is_large(const SystemOptions& system, const MethodOptions& options);

/// A method, and such a scene as it is written. Each parameter that has a value is one of the
/// scene.
struct MethodAndLargeScene {
    Method method;
    IndexedScene scene;
};
[[nodiscard]] MethodAndLargeScene read_large_scene(const MethodOptions& options,
                                                   const SystemOptions& system);

}  // namespace hvi::gen

// What the command line says of METHOD and SCENE, read.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <variant>

#include "generator/cli/options.hpp"
#include "generator/read/coefficients.hpp"
#include "generator/read/scene.hpp"
#include "generator/read/unrolling.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// Reads the method, and gives its parameters their values.
[[nodiscard]] Method method_of(const MethodOptions& options);

/// Reads a tableau in place of a method, and gives its parameters the same values.
[[nodiscard]] Coefficients coefficients_of(const std::filesystem::path& file,
                                           const MethodOptions& options);

/// A scene whose sums stay loops, and the values that the command line gives; it has them already.
struct LargeSystem {
    Scene scene;
    std::vector<Parameter> values;
};

/// A method, and H or L, read; the parameters of both have their values.
struct MethodAndSystem {
    Method method;
    std::variant<Hamiltonian, Lagrangian, LargeSystem> system;
};
[[nodiscard]] MethodAndSystem read_system(const MethodOptions& options,
                                          const SystemOptions& system);

/// A method and a scene, read. A parameter that the method has too is fixed to its value; the
/// values of the others are defaults. Of --hamiltonian each needs one by --param, and the scene
/// then has neither a name nor initial data. A method that is not given is that of the scene's
/// [run].
struct MethodAndScene {
    Method method;
    WrittenOutScene scene;
    UnrollDecision unrolling = {};
};
[[nodiscard]] MethodAndScene read_scene(const MethodOptions& options, const SystemOptions& system);

/// A method, and a scene whose sums stay loops, as it is written. Its parameters have their values,
/// and so have those of the method.
struct MethodAndLargeScene {
    Method method;
    Scene scene;
    UnrollDecision unrolling = {};
};

/// Whichever of the two the scene is. Throws InputError, too, where a scene that is not written out
/// has a parameter of the name of one of the method.
[[nodiscard]] std::variant<MethodAndScene, MethodAndLargeScene>
read_scene_of_any_size(const MethodOptions& options, const SystemOptions& system);

/// A method and a scene that need not have what a run needs; a parameter of both is one.
[[nodiscard]] std::variant<MethodAndScene, MethodAndLargeScene>
read_both(const MethodOptions& options, const SystemOptions& system);

/// A scene, or the Hamiltonian of the command line as one. What `--param` gives no value, and the
/// scene neither, has none.
[[nodiscard]] std::variant<WrittenOutScene, Scene>
read_scene_alone(const std::vector<Given>& parameters, const SystemOptions& system);

}  // namespace hvi::gen

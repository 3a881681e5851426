// What the command line says of METHOD and SCENE, read.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/cli/options.hpp"
#include "generator/read/coefficients.hpp"
#include "generator/read/hamiltonian.hpp"
#include "generator/read/scene.hpp"

namespace hvi::gen {

/// Reads the method, and gives its parameters their values.
[[nodiscard]] Method method_of(const MethodOptions& options);

/// Reads a tableau in place of a method, and gives its parameters the same values.
[[nodiscard]] Coefficients coefficients_of(const std::filesystem::path& file,
                                           const MethodOptions& options);

/// A method and an H without indices, read; the parameters of both have their values.
struct MethodAndHamiltonian {
    Method method;
    Hamiltonian hamiltonian;
};
[[nodiscard]] MethodAndHamiltonian read_hamiltonian(const MethodOptions& options,
                                                    const SystemOptions& system);

/// A method and a scene, read. A parameter that the method has too is fixed to its value; the
/// values of the others are defaults. Of --hamiltonian the scene has neither a name nor initial
/// data. A method that is not given is that of the scene's [run].
struct MethodAndScene {
    Method method;
    Scene scene;
    std::vector<Parameter> values;  ///< that the command line gives; both have them already
};

/// Throws InputError, too, for a parameter of --hamiltonian that --param gives no value.
[[nodiscard]] MethodAndScene read_scene(const MethodOptions& options, const SystemOptions& system);

/// A method and a scene whose parameters need not have values; those that --param gives are fixed.
[[nodiscard]] MethodAndScene read_both(const MethodOptions& options, const SystemOptions& system);

/// A scene, or the Hamiltonian of the command line as one. What `--param` gives no value, and the
/// scene neither, has none.
[[nodiscard]] Scene read_scene_alone(const std::vector<Given>& parameters,
                                     const SystemOptions& system);

}  // namespace hvi::gen

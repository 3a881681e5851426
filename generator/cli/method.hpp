// Reads the METHOD and the SCENE that the command line names.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/cli/options.hpp"
#include "generator/read/coefficients.hpp"
#include "generator/read/hamiltonian.hpp"
#include "generator/read/scene.hpp"

namespace hvi::gen {

/// Reads the method, and gives its parameters their values.
[[nodiscard]] Method method_of(const MethodOptions& options);

/// Reads a tableau in place of a method, and gives its parameters the values of the options.
[[nodiscard]] Coefficients coefficients_of(const std::filesystem::path& file,
                                           const MethodOptions& options);

/// A method and an H without indices. The parameters of both have their values.
struct MethodAndHamiltonian {
    Method method;
    Hamiltonian hamiltonian;
};
[[nodiscard]] MethodAndHamiltonian read_hamiltonian(const MethodOptions& options,
                                                    const SystemOptions& system);

/// A method and a scene. A parameter that the method has too is fixed to its value; the values of
/// the others are defaults. The scene of --hamiltonian has neither a name nor initial data. Without
/// a given method, the method is that of the scene's [run].
struct MethodAndScene {
    Method method;
    Scene scene;
    std::vector<Parameter> values;  ///< values of the command line, which both already have
};

/// Reads a method and a scene. Throws InputError, too, for a parameter of --hamiltonian that
/// --param gives no value.
[[nodiscard]] MethodAndScene read_scene(const MethodOptions& options, const SystemOptions& system);

/// Reads a method and a scene whose parameters need not have values. The parameters that --param
/// gives are fixed.
[[nodiscard]] MethodAndScene read_both(const MethodOptions& options, const SystemOptions& system);

/// Reads a scene, or makes one of the command line's Hamiltonian. A parameter has no value where
/// neither `--param` nor the scene gives one.
[[nodiscard]] Scene read_scene_alone(const std::vector<Given>& parameters,
                                     const SystemOptions& system);

}  // namespace hvi::gen

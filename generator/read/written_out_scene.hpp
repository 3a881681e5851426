// Scenes: a Hamiltonian or a Lagrangian with its numbers, and what one wants to know of its motion.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "generator/read/hamiltonian.hpp"
#include "generator/read/lagrangian.hpp"
#include "generator/read/own_functions.hpp"

namespace hvi::gen {

/// An expression with its name and where it stands. The ranges in it are ranges in its place's
/// source.
struct NamedExpression {
    std::string name;
    Expression expression;
    Place place;  ///< of its whole text
};

/// What [run] asks for, where it says so.
struct RunWishes {
    std::shared_ptr<const Source> method;  ///< of a named method or family: `gauss:4`; or null
    std::optional<NamedExpression> step;   ///< of parameters, pi and e
    std::optional<NamedExpression> until;  ///< the same
};

/// A vector field on the coordinates along which H or L is said not to change; those that are not
/// named do not move.
struct VectorField {
    std::string name;
    std::vector<NamedExpression> components;  ///< by the names of coordinates, in their order
    Place place;                              ///< of the name
};

/// What a scene says, checked as far as words go: every symbol is a variable, a parameter with a
/// value, pi, e, or, in H, L and [exact], the time t; names are free and differ. Its variables are
/// coordinates, and momenta where it has a Hamiltonian, velocities where it has a Lagrangian.
struct WrittenOutScene {
    std::string name;         ///< the key `name`, else that of the file without its ending
    std::string description;  ///< the key `description`: one line; or empty
    std::variant<Hamiltonian, Lagrangian> mechanics;  ///< no parameter of it has a value yet
    std::vector<Parameter> parameters;                ///< all, in the order of the file
    OwnFunctions own;                                 ///< that H and invariants may call
    std::vector<NamedExpression> invariants;          ///< in the order of the file
    std::set<std::string> approximate;     ///< invariants that are said to be nearly conserved
    std::vector<VectorField> fields;       ///< of [symmetries], in the order of the file
    std::vector<NamedExpression> initial;  ///< of the coordinates, then of the other variables
    std::vector<NamedExpression> exact;    ///< the same, as functions of t; or empty
    RunWishes run;
    std::optional<Place> place;  ///< of the word that names it, for errors; none of a file alone
};

/// Its H or L.
[[nodiscard]] const MechanicalFunction& function_of(const WrittenOutScene& scene);
[[nodiscard]] MechanicalFunction& function_of(WrittenOutScene& scene);

/// Coordinates, then momenta or velocities.
[[nodiscard]] std::vector<std::string> variables(const WrittenOutScene& scene);

/// `the Hamiltonian` or `the Lagrangian`.
[[nodiscard]] std::string_view name_of_function(const WrittenOutScene& scene);

/// H. Throws MathError, with the place of L, where the scene has a Lagrangian.
[[nodiscard]] const Hamiltonian& hamiltonian_of(const WrittenOutScene& scene);

/// The scene in a TOML file of at most 1 MiB, as CONTRACT.md has it, unrolled. Throws InputError
/// with the line of the file.
[[nodiscard]] WrittenOutScene scene_from_file(const std::filesystem::path& path);

/// The same for the text of such a file; the source's name is that of the file.
[[nodiscard]] WrittenOutScene scene_from_toml(const Source& file);

/// The scene that the command line names: one that comes with the program (`kepler`), else that of
/// the file; with other values for those of its parameters that `values` names. Throws InputError,
/// with what may have been meant, where there is neither, and for more than
/// most_degrees_of_freedom.
[[nodiscard]] WrittenOutScene find_scene(const Given& name_or_file,
                                         const std::vector<Parameter>& values = {});

/// The scenes that come with the program, by name. NOTE: what is said of them is known without
/// their sums being written out.
struct SceneEntry {
    std::string_view name;
    std::string description;
    std::size_t degrees_of_freedom = 0;  ///< with the values that its parameters have in it
};
[[nodiscard]] std::vector<SceneEntry> scenes();

/// A number that may depend on the scene's parameters, as [run] has it: the value of `--step`.
/// Throws InputError.
[[nodiscard]] NamedExpression expression_of_parameters(const WrittenOutScene& scene,
                                                       std::string name,
                                                       std::shared_ptr<const Source> text);

/// Throws InputError as check_together() of H does.
void check_together(const Method& method, const WrittenOutScene& scene);

/// Fixes the value of a parameter of the scene's H or L, initial values and the rest, or of the
/// method's. Throws InputError as set_parameter() of a Hamiltonian does. NOTE: a size has had its
/// value since find_scene().
void set_parameter(Method& method, WrittenOutScene& scene, Parameter parameter);

}  // namespace hvi::gen

// Lagrangians as the user gave them: an expression, and which of its symbols are variables.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "generator/read/hamiltonian.hpp"

namespace hvi::gen {

constexpr ConjugateWords words_of_velocities{"a velocity", "velocity", "velocities"};

/// L(q, v) or L(q, v, t).
struct Lagrangian : MechanicalFunction {
    std::vector<std::string> velocities;  ///< velocities[i] belongs to coordinates[i]
};

/// Makes L(q, v) of an expression in `source`; `origin` is left empty. Throws InputError.
[[nodiscard]] Lagrangian lagrangian_of(Expression expression, std::shared_ptr<const Source> source,
                                       const NameList& coordinates, const NameList& velocities);

/// Returns coordinates, then velocities.
[[nodiscard]] std::vector<std::string> variables(const Lagrangian& lagrangian);

/// Returns the symbols of L that are parameters, with a value or without, sorted.
[[nodiscard]] std::vector<std::string> parameter_names(const Lagrangian& lagrangian);

/// Returns names for the momenta of L: p_x for x, with `_` after it as often as other names need.
[[nodiscard]] std::vector<std::string> momentum_names(const Lagrangian& lagrangian);

/// Returns names for the velocities of H: x_dot for x, with `_` likewise.
[[nodiscard]] std::vector<std::string> velocity_names(const Hamiltonian& hamiltonian);

/// Whether the time `t` occurs in L.
[[nodiscard]] bool depends_on_time(const Lagrangian& lagrangian);

}  // namespace hvi::gen

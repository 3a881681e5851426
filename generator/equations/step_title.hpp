// The title of a step's equations: their method, and the values and names of parameters.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/read/lagrangian.hpp"

namespace hvi::gen {

struct StepTitle {
    std::string name;    ///< the method's name; empty for one given by basis and nodes
    std::string origin;  ///< METHOD and the Hamiltonian on the command line
    std::vector<std::string> parameters;  ///< free symbols of H and of the method, sorted
    std::vector<Parameter> values;        ///< values of the others, sorted by name
    /// The basis of the general form, whose unknowns are coefficients of velocities; else empty.
    std::vector<Expression> basis;
};

/// The words of a title about H or L.
struct FunctionWords {
    std::string origin;                   ///< includes the values that the command line gives
    std::vector<std::string> parameters;  ///< both known and free ones
    std::vector<Parameter> values;
};

[[nodiscard]] StepTitle title_of(const Method& method, const FunctionWords& function);
[[nodiscard]] StepTitle title_of(const Method& method, const Hamiltonian& hamiltonian);
[[nodiscard]] StepTitle title_of(const Method& method, const Lagrangian& lagrangian);

}  // namespace hvi::gen

// What equations of a step are of: their method, and the values and names of parameters.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/read/lagrangian.hpp"

namespace hvi::gen {

struct StepTitle {
    std::string name;    ///< of the method; empty for one given by basis and nodes
    std::string origin;  ///< METHOD and the Hamiltonian as the command line has them
    std::vector<std::string> parameters;  ///< free symbols of H and of the method, sorted
    std::vector<Parameter> values;        ///< of the others, sorted by name
    /// Of the general form, in which the velocities have coefficients for unknowns; else empty.
    std::vector<Expression> basis;
};

/// Words of a title about H or L.
struct FunctionWords {
    std::string origin;                   ///< with the values that the command line gives
    std::vector<std::string> parameters;  ///< with a value or without
    std::vector<Parameter> values;
};

[[nodiscard]] StepTitle title_of(const Method& method, const FunctionWords& function);
[[nodiscard]] StepTitle title_of(const Method& method, const Hamiltonian& hamiltonian);
[[nodiscard]] StepTitle title_of(const Method& method, const Lagrangian& lagrangian);

}  // namespace hvi::gen

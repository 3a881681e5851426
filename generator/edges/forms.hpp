// Forms of a method: steppers that solve its stages in different ways.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/edges/program.hpp"

namespace hvi::gen {

struct Form {
    std::string name;
    Solver solver;
    EdgeProgram program;
};

/// Returns the stepper without wishes, one iterated with fixed points, and one with Newton's
/// method. Explicit steppers have one form. Throws as EdgeProgram() does.
[[nodiscard]] std::vector<Form> forms(Builds& builds, const ComposedMethod& method,
                                      const Scene& scene);

}  // namespace hvi::gen

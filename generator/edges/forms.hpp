// The steppers of one method that solve its stages in different ways.
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

/// As it is without wishes, iterated with fixed points, and with Newton's method. Where there is
/// nothing to solve they are one. Throws what EdgeProgram() does.
[[nodiscard]] std::vector<Form> forms(Builds& builds, const ComposedMethod& method,
                                      const Scene& scene);

}  // namespace hvi::gen

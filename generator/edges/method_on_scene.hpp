// Cases for every method of a chapter on every scene of it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "generator/edges/edges.hpp"
#include "generator/edges/program.hpp"

namespace hvi::gen {

struct MethodOnScene {
    ExactMethod method;
    Scene scene;
    EdgeProgram program;
};

using ProgramOf = std::function<EdgeProgram(const ExactMethod&, const Scene&)>;

/// Makes all programs, then adds their cases to the chapter, and reports progress on standard
/// error. For an H that the general Galerkin form does not step, the case says why.
void add_cases(EdgeChapter& chapter, const std::vector<ExactMethod>& methods,
               const std::vector<Scene>& scenes, const ProgramOf& program,
               const std::function<std::vector<EdgeCheck>(const MethodOnScene&)>& cases);

}  // namespace hvi::gen

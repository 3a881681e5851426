// Measuring methods on a scene.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/program/compiler.hpp"
#include "generator/read/method.hpp"
#include "generator/read/scene.hpp"
#include "generator/report/report.hpp"
#include "generator/simulate/peers.hpp"

namespace hvi::gen {

/// What is to be measured.
struct StudyWishes {
    std::vector<Method> methods;
    std::vector<double> steps;  ///< sizes, of which none is 0; empty: chosen for each method so
                                ///< that errors go from 1e-2 to round-off
    std::vector<PeerLibrary> libraries = {};  ///< whose integrators are measured too
};

/// Compiles and runs all of it, and says on standard error what it is at, where that is a terminal.
/// `until` is the time at the end. Throws what scene_stepper(), built_program() and ask() do.
[[nodiscard]] SceneReport study(const Compiler& compiler, const Scene& scene, double until,
                                std::int64_t first_count, const StudyWishes& wishes);

}  // namespace hvi::gen

// Methods that are measured on a scene, and the solution that they are measured against.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/exact/methods/composed_method.hpp"
#include "generator/ir/step.hpp"
#include "generator/program/builds.hpp"
#include "generator/read/written_out_scene.hpp"
#include "generator/simulate/simulation.hpp"
#include "generator/study/work.hpp"

namespace hvi::gen {

/// A method that is to be measured.
struct StudiedMethod : ExactMethod {
    int order;
};

/// Looks for the order, which takes longer than all else that is asked of a method.
[[nodiscard]] StudiedMethod studied(ExactMethod method);

/// A method on a scene, ready to run.
struct Contender {
    std::string title;
    int order;
    ModuleBuild module;
    std::optional<SolverCosts> costs = {};  ///< of the ways to solve for its stages
    int sweeps = 0;                         ///< counted ones; 0: there are none
    bool takes_sweeps = false;              ///< whether they could be counted
};

/// `sweeps`: so many in each step; 0: the solver ends them. Throws what scene_stepper() does.
[[nodiscard]] Contender contender(Builds& builds, const StudiedMethod& method,
                                  const LoweredScene& scene, Solver solver, int sweeps = 0);

/// A contender of each method, then one of counted sweeps of each that takes these; none of those
/// for 0. Throws what scene_stepper() does.
[[nodiscard]] std::vector<Contender> contenders(Builds& builds,
                                                const std::vector<StudiedMethod>& methods,
                                                const LoweredScene& scene, int sweeps);

/// Measures its runs, until the time of the course.
[[nodiscard]] MeasureSteps measured(const Contender& contender, double until);

/// Whether its [exact] is one of states: beside a Lagrangian it is of velocities, and states have
/// momenta.
[[nodiscard]] bool has_exact_states(const WrittenOutScene& scene);

/// The program of a reference solution, where the scene has none that is exact.
/// Precondition: sums are written out.
[[nodiscard]] Build reference_build(Builds& builds, const LoweredScene& scene);

/// The scene's exact solution at its end, or one by that program, with steps halved until the end
/// moves by no more than `wanted`, or for so many seconds. `count` are the scene's own steps.
[[nodiscard]] Reference reference(const Build& build, const WrittenOutScene& scene, double until,
                                  std::int64_t count, double wanted, double seconds = 30);

}  // namespace hvi::gen

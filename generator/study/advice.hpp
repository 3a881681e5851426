// Which method takes a scene to an accuracy in the least time, and in which steps.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/ir/step.hpp"
#include "generator/program/builds.hpp"
#include "generator/read/written_out_scene.hpp"
#include "generator/study/contender.hpp"
#include "generator/study/curves.hpp"

namespace hvi::gen {

/// A way to make steps.
struct Candidate {
    StudiedMethod method;
    Solver solver = Solver::automatic;
    int sweeps = 0;  ///< counted ones; 0: the solver ends them
};

/// The accuracy that is asked for, and limits of the search.
struct AdviceWishes {
    double accuracy = 0;           ///< the largest error at the end, relative as in a report
    double until = 0;              ///< the time at the end
    std::int64_t first_count = 1;  ///< steps to begin with
    bool has_curve = false;        ///< steps are to have a curve, as those of compositions have not
    bool has_action = false;       ///< and an action, as those of counted sweeps have not
    double seconds = 60;           ///< for which runs are made; programs are compiled before
    UnrollWish sums = {};
};

struct Advice {
    std::vector<Candidate> candidates;
    std::vector<WorkCurve> curves;                  ///< of each the runs that were made
    std::vector<std::optional<SolverCosts>> costs;  ///< of each; see Contender
    std::size_t chosen = 0;
    WorkPoint point;         ///< of the chosen one, at that accuracy, or the best where
    bool is_reached = true;  ///< none got there in that time; its error is an estimate then
    Reference reference;
};

/// Compiles all candidates, runs them, and says on standard error what it is at, where that is a
/// terminal. No run is begun that would end after the time that there is, as far as those before it
/// tell. Steps of scaled time are parts of its length. Throws MathError where none gets there with
/// any steps, or nothing is known so well as to tell; InputError for jumps, kinks and scaled time
/// where sums stay loops; and what scene_stepper(), a Build and ask() do.
[[nodiscard]] Advice advice(Builds& builds, const Scene& scene, const AdviceWishes& wishes);

}  // namespace hvi::gen

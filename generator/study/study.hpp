// Measuring methods on a scene.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/program/builds.hpp"
#include "generator/read/scene.hpp"
#include "generator/read/written_out_scene.hpp"
#include "generator/simulate/peers.hpp"
#include "generator/study/contender.hpp"
#include "generator/study/curves.hpp"
#include "generator/support/time_spent.hpp"

namespace hvi::gen {

/// Methods and libraries to measure, and how.
struct StudyWishes {
    std::vector<StudiedMethod> methods;
    std::vector<double> steps;  ///< sizes, of which none is 0; empty: chosen for each method so
                                ///< that errors go from 1e-2 to round-off
    std::vector<PeerLibrary> libraries = {};  ///< whose integrators are measured too
    UnrollWish sums = {};
    int sweeps = 0;  ///< methods that are iterated are measured with so many a step, too; 0: not
};

/// Compiles and runs all of it, and says on standard error what it is at, where that is a terminal.
/// `until` is the time at the end. It adds to `report` as it goes, so that what there is can be
/// kept where it throws, as scene_stepper(), a Build and ask() do. Libraries are measured where
/// sums are written out and nothing is_eventful(), which takes sums that are written out, too.
void study(Builds& builds, const Scene& scene, double until, std::int64_t first_count,
           const StudyWishes& wishes, SceneReport& report, TimeSpent& time_spent);

}  // namespace hvi::gen

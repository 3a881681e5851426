// Edge cases: methods with stiff problems, extreme orbits or many steps, beside their expected
// results.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/draw/curves.hpp"
#include "generator/exact/methods/composed_method.hpp"
#include "generator/program/builds.hpp"
#include "generator/read/scene.hpp"

namespace hvi::gen {

/// One case. Its expected result never comes from a run.
struct EdgeCheck {
    std::string method, scene;
    std::string what;  ///< the case: `h = 1e300`
    std::string expected, seen;
    bool agrees = false;
};

struct EdgeChapter {
    std::string name;   ///< one word, for programs
    std::string title;  ///< for people
    std::string about;  ///< sentences: the expected results, and their source
    std::vector<EdgeCheck> checks;
    std::vector<CurvesPicture> pictures;
};

/// The chapters of a report. They compile and run programs, each under a time limit, and report
/// progress on standard error, where that is a terminal. All throw as scene_stepper() and a Build
/// do, and Interruption.
///
/// Precondition: the scenes have initial data and a step.
[[nodiscard]] EdgeChapter rejections(Builds& builds, const std::vector<ExactMethod>& methods,
                                     const std::vector<Scene>& scenes);
[[nodiscard]] EdgeChapter symplecticity(Builds& builds, const std::vector<ExactMethod>& methods,
                                        const std::vector<Scene>& scenes);

/// Chapters on scenes of their own. They throw as above.
[[nodiscard]] EdgeChapter stiff(Builds& builds, const std::vector<ExactMethod>& methods);
[[nodiscard]] EdgeChapter chain(Builds& builds, const std::vector<ExactMethod>& methods);
[[nodiscard]] EdgeChapter extreme(Builds& builds, const std::vector<ExactMethod>& methods);
[[nodiscard]] EdgeChapter long_runs(Builds& builds, const std::vector<ExactMethod>& methods);
[[nodiscard]] EdgeChapter events_and_scales(Builds& builds,
                                            const std::vector<ExactMethod>& methods);

}  // namespace hvi::gen

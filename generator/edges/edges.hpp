// What methods do at the edges, stiff, extreme or many steps, beside what they should do.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/draw/curves.hpp"
#include "generator/exact/methods/composed_method.hpp"
#include "generator/program/builds.hpp"
#include "generator/read/scene.hpp"

namespace hvi::gen {

/// One case. What is expected never comes from a run.
struct EdgeCheck {
    std::string method, scene;
    std::string what;  ///< the case: `h = 1e300`
    std::string expected, seen;
    bool agrees = false;
};

struct EdgeChapter {
    std::string name;   ///< one word, for programs
    std::string title;  ///< for people
    std::string about;  ///< what is expected, and where that comes from: sentences
    std::vector<EdgeCheck> checks;
    std::vector<CurvesPicture> pictures;
};

/// The chapters of a report. They compile and run programs, each under a time limit, and say on
/// standard error what they are at, where that is a terminal. All throw what scene_stepper() and
/// a Build do, and Interruption.
///
/// Precondition: the scenes have initial data and say their step.
[[nodiscard]] EdgeChapter rejections(Builds& builds, const std::vector<ExactMethod>& methods,
                                     const std::vector<Scene>& scenes);
[[nodiscard]] EdgeChapter symplecticity(Builds& builds, const std::vector<ExactMethod>& methods,
                                        const std::vector<Scene>& scenes);

/// The same on scenes of their own.
[[nodiscard]] EdgeChapter stiff(Builds& builds, const std::vector<ExactMethod>& methods);
[[nodiscard]] EdgeChapter chain(Builds& builds, const std::vector<ExactMethod>& methods);
[[nodiscard]] EdgeChapter extreme(Builds& builds, const std::vector<ExactMethod>& methods);
[[nodiscard]] EdgeChapter long_runs(Builds& builds, const std::vector<ExactMethod>& methods);
[[nodiscard]] EdgeChapter events_and_scales(Builds& builds,
                                            const std::vector<ExactMethod>& methods);

}  // namespace hvi::gen

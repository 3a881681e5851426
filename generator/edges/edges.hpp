// What methods do at the edges, stiff, extreme or many steps, beside what they should do.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/draw/curves.hpp"
#include "generator/program/compiler.hpp"
#include "generator/program/machine.hpp"
#include "generator/read/method.hpp"

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

struct EdgeReport {
    Machine machine;
    std::string compiler;  ///< its name and options
    std::string compiler_version;
    std::vector<EdgeChapter> chapters;
};

/// The chapters of a report. They compile and run programs, each under a time limit, and say on
/// standard error what they are at, where that is a terminal. All throw what scene_stepper() and
/// built_program() do, and Interruption.
[[nodiscard]] EdgeChapter rejections(const Compiler& compiler, const std::vector<Method>& methods);
[[nodiscard]] EdgeChapter stiff(const Compiler& compiler, const std::vector<Method>& methods);
[[nodiscard]] EdgeChapter long_runs(const Compiler& compiler, const std::vector<Method>& methods);
[[nodiscard]] EdgeChapter symplecticity(const Compiler& compiler,
                                        const std::vector<Method>& methods);

/// Schema hvi-edges/1.
[[nodiscard]] std::string edges_json(const EdgeReport& report);

/// One page that needs nothing beside it. Throws as draw() does.
[[nodiscard]] std::string edges_html(const EdgeReport& report);

}  // namespace hvi::gen

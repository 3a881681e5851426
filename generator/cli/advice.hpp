// `--accuracy`: the method and the step that take a scene to its end with an error of at most that.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "generator/cli/options.hpp"
#include "generator/scene/step_count.hpp"

namespace hvi::gen {

/// What `--accuracy` is asked of.
struct AccuracyQuestion {
    std::vector<Given> parameters;  ///< of the scene: `mu=2`
    SystemOptions system;           ///< a scene
    Given until;                    ///< in place of the scene's
    double accuracy = 0;
    double seconds = 60;     ///< for which runs are made
    bool has_curve = false;  ///< of the steps, which compositions have not
    bool explain = false;    ///< what the runs cost beside what the model of costs says
};

/// In place of options that are not given.
struct AdvisedOptions {
    std::string method;
    Solver solver = Solver::automatic;
    std::optional<Composition> composition;
    Steps steps{};
    std::string step;  ///< exactly, as `--step` takes it: `200/1123`
    std::string note;  ///< what it is for, in a line
    std::string shortfall =
        {};  ///< that the accuracy was not reached in that time; empty where it was
};

/// Measures, and says on standard error what was measured and chosen. Throws what advice() does.
/// Precondition: interruptions are held.
[[nodiscard]] AdvisedOptions advised(const AccuracyQuestion& question);

}  // namespace hvi::gen

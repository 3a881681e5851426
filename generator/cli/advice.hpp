// `--accuracy`: finds the method and the step that reach the end of a scene within an error.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "generator/cli/options.hpp"
#include "generator/scene/step_count.hpp"

namespace hvi::gen {

/// The request of `--accuracy`.
struct AccuracyQuestion {
    std::vector<Given> parameters;  ///< parameters of the scene: `mu=2`
    SystemOptions system;           ///< a scene
    Given until;                    ///< the end, in place of the scene's
    double accuracy = 0;
    double seconds = 60;     ///< seconds that runs may take
    bool has_curve = false;  ///< whether a curve of the steps is asked for, which compositions lack
    bool has_action = false;  ///< and their action, which counted sweeps lack
    bool explain = false;     ///< whether to compare measured costs with the model of costs
};

/// Replacements for options that are not given.
struct AdvisedOptions {
    std::string method;
    Solver solver = Solver::automatic;
    int sweeps = 0;  ///< counted ones; 0: the solver ends them
    std::optional<Composition> composition;
    Steps steps{};
    double until = 0;  ///< the end
    std::string step;  ///< exactly, as `--step` takes it: `200/1123`
    std::string note;  ///< its purpose, in a line
    std::string shortfall =
        {};  ///< a message that the accuracy was not reached; empty where it was
};

/// Measures, and reports the measurements and the choice on standard error. Throws as advice()
/// does. Precondition: interruptions are held.
[[nodiscard]] AdvisedOptions advised(const AccuracyQuestion& question);

}  // namespace hvi::gen

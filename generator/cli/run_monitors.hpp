// Measurements along the steps of a run, by steppers of their own.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "generator/cli/method.hpp"
#include "generator/cli/options.hpp"
#include "generator/cli/runner.hpp"
#include "generator/drive/trajectory.hpp"
#include "generator/simulate/balance.hpp"
#include "generator/simulate/shadow.hpp"
#include "generator/simulate/tangents.hpp"

namespace hvi::gen {

/// A parameter that the end of the run is differentiated by.
struct Sensitivity {
    std::string parameter;
    SceneStepper stepper;
    std::vector<double> start = {};  ///< of the derivative, where states have none
};

/// Measurements that are wished for, and the steppers for them.
struct Monitors {
    TangentWishes tangents = {};
    std::optional<SceneStepper> tangent = {};  ///< of directions, where these are wished for
    std::vector<Sensitivity> sensitivities = {};
    FindMotion motion = {};                    ///< of scaled time, for both of these
    std::optional<SceneStepper> shadow = {};   ///< of the modified Hamiltonian, likewise
    std::optional<SceneStepper> balance = {};  ///< of the energy, where H depends on the time
    std::size_t degrees = 0;                   ///< of freedom, of the scene; where there is one
};

/// Throws InputError for what is not built for the scene, whose stepper this is.
[[nodiscard]] Monitors wished_monitors(const MethodAndScene& both, const SceneStepper& stepper,
                                       const StepperWishes& wishes, const RunOptions& options,
                                       const Runner& runner);

/// Measurements of those that were wished for.
struct MonitorFindings {
    TangentFindings directions = {};
    std::vector<TangentFindings> sensitivities = {};  ///< of each parameter
    std::optional<ShadowFindings> shadow = {};        ///< nothing where there were too few steps
    std::optional<BalanceFindings> balance = {};
    std::optional<DrivenEvent> event = {};  ///< that ended the run, where there is the matrix

    /// Why one of them has not come to the end of the run; empty where all have.
    [[nodiscard]] std::string fault() const;
};

/// Begins to compile the steppers.
void begin(const Monitors& monitors, Runner& runner);

/// Measures along the steps that the run has taken, of size h. Throws as find_tangents() does.
[[nodiscard]] MonitorFindings measured(const Monitors& monitors, const Simulation& run,
                                       const EventWishes& events, double h, Runner& runner);

/// The table of derivatives of the event that ended the run, its time and its state, by the start,
/// whose variables have names in these boxes; empty where there are none.
[[nodiscard]] std::string section_table(const TangentFindings& found,
                                        const std::vector<NameBox>& names);

/// The table of derivatives of the end by parameters, with names in these boxes, of which variables
/// are the first; empty where none were wished for.
[[nodiscard]] std::string table_of_sensitivities(const Monitors& monitors,
                                                 const MonitorFindings& found,
                                                 const std::vector<NameBox>& names);

/// Lines of the summary: names, and what there is to say.
[[nodiscard]] std::vector<std::pair<std::string, std::string>>
lines_of(const Monitors& monitors, const MonitorFindings& found);

}  // namespace hvi::gen

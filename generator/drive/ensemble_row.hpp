// A trajectory of an ensemble, from its own start to its own end.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "generator/drive/driven_event.hpp"
#include "generator/read/reductions.hpp"

namespace hvi::gen {

/// Words for the end of a trajectory. Its number stands in tables of numbers alone: the first ones
/// are numbers of hvi::Status::Code.
inline constexpr std::array<std::string_view, 16> row_statuses{
    "ok",
    "not_converged",
    "not_finite",
    "singular",
    "dimension_mismatch",
    "unsafe_arithmetic",
    "pole",
    "zero_weight",
    "parameter_too_large",
    "not_a_rotation",
    "outside_chart",
    "no_number",        ///< a value of the row is infinite or not a number
    "no_steps",         ///< its step is 0 or leads away from its end
    "accumulation",     ///< an event comes again and again without time between
    "undefined_event",  ///< the function of an event is not a number
    "time_stands",      ///< scaled time does not go on with the steps
};

/// Numbers of the statuses that are no codes of a step.
enum class RowStatus : std::size_t {
    ok = 0,
    no_number = 11,
    no_steps,
    accumulation,
    undefined_event,
    time_stands,
};

/// Wishes for all trajectories of an ensemble.
struct RowWishes {
    std::vector<std::size_t> columns;   ///< numbers of the columns at the end
    std::vector<Reduction> reductions;  ///< over all steps
    bool growth = false;                ///< MEGNO and the largest Lyapunov exponent
    bool looks_at_end = false;          ///< computes costly invariants at the end only
};

/// The data of one trajectory.
struct RowStart {
    MakeStepper make;
    /// Steppers that carry directions along, for the growth. Time is not scaled then.
    MakeStepper make_directions = {};
    double h = 0;
    std::int64_t steps = 0;
    std::optional<ScaledClock> clock = {};  ///< then `steps` is the most that are taken
    std::shared_ptr<const std::vector<DrivenEvent>> events = {};
};

/// The end of one trajectory.
struct RowEnd {
    std::size_t status = 0;  ///< a number among `row_statuses`
    std::int64_t steps = 0;
    double t = 0;
    std::vector<double> columns = {};
    double energy_error = 0;  ///< the largest departure of the energy; 0 where it is not conserved
    std::vector<std::int64_t> events = {};  ///< the number of occurrences of each
    std::vector<double> reduced = {};
    double lyapunov = 0, megno = 0;  ///< NaN where directions are not carried to the end
};

/// Takes the steps of a trajectory. Returns nothing where SIGTERM has come on the way: see
/// heed_signals(). A step that fails ends the trajectory with its status, and the state before it.
/// Throws std::bad_alloc, SolverIsApart, and std::runtime_error where the stepper refuses its
/// parameters.
[[nodiscard]] std::optional<RowEnd> take_row(const RowWishes& wishes, const RowStart& start);

}  // namespace hvi::gen

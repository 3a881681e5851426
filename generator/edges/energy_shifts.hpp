// Shifts of the mean energy over a long run.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "generator/edges/program.hpp"

namespace hvi::gen {

/// Runs from several states of a scene.
struct LongRun {
    std::string scene;
    long steps;
    double h;
    std::size_t starts;
};

struct EnergyShifts {
    /// Pairs of n and a root mean square, for windows of n/2 to n steps. The mean over the runs is
    /// of the change of the mean energy from a window's first half to its second.
    std::vector<std::pair<double, double>> of_windows;
    std::string failure;  ///< why there are no windows; else empty
};

/// Runs the command `energy` or `forgetful-energy` of src/driver/edge_energy.hpp. The runs go side
/// by side. Throws as ask() does.
[[nodiscard]] EnergyShifts energy_shifts(const EdgeProgram& program, const std::string& command,
                                         const LongRun& run,
                                         const std::vector<double>& values = {});

/// Returns the windows whose shift is not 0.
[[nodiscard]] std::vector<std::pair<double, double>> above_zero(const EnergyShifts& shifts);

}  // namespace hvi::gen

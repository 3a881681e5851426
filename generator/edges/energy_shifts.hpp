// How the mean energy moves over a long run.
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
    /// Of windows of n/2 to n steps, n and the root of the mean square, over the runs, of the
    /// change of the mean energy from the first half to the second.
    std::vector<std::pair<double, double>> of_windows;
    std::string failure;  ///< why there are none; else empty
};

/// The command of src/driver/edge_energy.hpp: `energy` or `forgetful-energy`. The runs go side by
/// side. Throws as ask() does.
[[nodiscard]] EnergyShifts energy_shifts(const EdgeProgram& program, const std::string& command,
                                         const LongRun& run,
                                         const std::vector<double>& values = {});

/// Without what was not there at all.
[[nodiscard]] std::vector<std::pair<double, double>> above_zero(const EnergyShifts& shifts);

}  // namespace hvi::gen

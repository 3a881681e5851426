// The library that takes rows of a study at once, on a GPU.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/pipeline/stepper.hpp"
#include "generator/simulate/simulation.hpp"

namespace hvi::gen {

/// Returns the wishes for its steppers, where `wishes` are those of a run; `place` is where the
/// user has asked for a GPU.
[[nodiscard]] StepperWishes device_wishes(StepperWishes wishes, std::optional<Place> place = {});

/// Returns the library: for Builds by find_device_compiler(), and loaded_rows(). By find_compiler()
/// it takes its rows on the host, to the same bits, where `artifact` says so. Preconditions: those
/// of device_module().
[[nodiscard]] SimulationProgram device_program(const SceneStepper& stepper,
                                               Artifact artifact = Artifact::device_library);

}  // namespace hvi::gen

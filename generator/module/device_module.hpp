// A stepper of a scene as a module that takes many rows of a study at once, on a GPU.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/pipeline/stepper.hpp"

namespace hvi::gen {

/// A source, for src/hvi/detail/device/rows.hpp, and numbers as in a DrivenSystem. It is CUDA, and
/// C++ for a compiler that knows nothing of CUDA: its rows are then a loop, with the same bits. As
/// that of a DrivenModule it depends neither on values of parameters nor on the start of the scene.
struct DeviceModule {
    std::string source;
    std::vector<double> numbers;
};

/// Writes the module. Precondition: `stepper` is made with Lanes::gpu, and has its energy and its
/// invariants as members.
[[nodiscard]] DeviceModule device_module(const SceneStepper& stepper);

}  // namespace hvi::gen

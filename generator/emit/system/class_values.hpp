// Values of a state that a generated class computes beside steps.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/emit/system/scene_code.hpp"

namespace hvi::gen {

/// A value as a member of System, and as a member of the stepper where `about` describes it.
struct ClassValue {
    std::string name;
    const std::vector<SystemSum>* sums;
    bool has_time = false;   ///< whether the time is an argument
    std::string about = {};  ///< for the doc comment of the stepper's member; else empty
};

/// Returns the energy, the Lagrangian and the invariants that are wished for. The result points
/// into the system.
[[nodiscard]] std::vector<ClassValue> values_of_class(const System& system,
                                                      const SceneWishes& wishes);

}  // namespace hvi::gen

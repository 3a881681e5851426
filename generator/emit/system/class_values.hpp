// Values of a state that a generated class computes beside steps.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/emit/system/scene_code.hpp"

namespace hvi::gen {

/// A value as a member of System, and of the stepper where it says what it is.
struct ClassValue {
    std::string name;
    const std::vector<SystemSum>* sums;
    bool has_time = false;   ///< among its arguments
    std::string about = {};  ///< for the doc comment of the stepper's member; else empty
};

/// The energy, the Lagrangian and invariants, as far as they are wished for. The result points into
/// the system.
[[nodiscard]] std::vector<ClassValue> values_of_class(const System& system,
                                                      const SceneWishes& wishes);

}  // namespace hvi::gen

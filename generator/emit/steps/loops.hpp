// Headers of scenes with loops.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/emit/steps/emit.hpp"
#include "generator/emit/system/loop_code.hpp"

namespace hvi::gen {

/// A header for a scene of any size. Preconditions: `step` is a plan for a class of the user, with
/// what is known of the system; options.system is null, and options.loops is `code`.
[[nodiscard]] std::string emit_loops(const OneStepMethod& method, const Step& step,
                                     const LoopCode& code, const EmitOptions& options);

}  // namespace hvi::gen

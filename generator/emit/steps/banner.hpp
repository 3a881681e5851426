// First comment of a header.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/emit/steps/emit.hpp"

namespace hvi::gen {

/// Returns the first comment of a header: its command, its sources, the exact tableau, and the
/// decisions of the plan.
[[nodiscard]] std::string banner(const OneStepMethod& method, const Step& step,
                                 const EmitOptions& options);

}  // namespace hvi::gen

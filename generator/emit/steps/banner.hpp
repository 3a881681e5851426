// How a header opens.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/emit/steps/emit.hpp"

namespace hvi::gen {

/// What made the header, from what, the exact tableau, and what was left out.
[[nodiscard]] std::string banner(const OneStepMethod& method, const Step& step,
                                 const EmitOptions& options);

}  // namespace hvi::gen

// Pieces of headers of flows of parts of H, of one trajectory or of eight.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "generator/emit/system/flow_code.hpp"
#include "generator/ir/step.hpp"
#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Returns the tables of the fractions of h, one for each part.
[[nodiscard]] std::string fractions_text(const FlowStep& form);

/// Returns the flows of a step in turn, which move `path`.
[[nodiscard]] std::string rounds_text(const FlowStep& form);

/// Returns the classes of the flows of all parts; see flow_text().
[[nodiscard]] std::string flows_text(const System& system, const FlowStep& form,
                                     std::string_view library, Constants constants,
                                     Carries carries);

}  // namespace hvi::gen

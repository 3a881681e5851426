// How a header opens.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/emit/steps/emit.hpp"

namespace hvi::gen {

/// What made the header, from what, the exact tableau, and what was left out.
[[nodiscard]] std::string banner(const OneStepMethod& method, const Step& step,
                                 const EmitOptions& options);

/// The command that a header says it was written by.
[[nodiscard]] std::string command_in(const std::string& header);

/// The header with a line of comment behind that command.
[[nodiscard]] std::string with_note(std::string header, const std::string& note);

}  // namespace hvi::gen

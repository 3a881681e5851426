// Checks the command line by the rules in the table of options.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/cli/words.hpp"

namespace hvi::gen {

/// Throws InputError for options that are to come, unknown, without a value, given twice, excluded
/// by others, or without options that they need.
void check_rules(const Words& words, const CommandLine& line);

/// Throws InputError where the command itself is to come.
void check_command(const CommandEntry& command, const CommandLine& line);

}  // namespace hvi::gen

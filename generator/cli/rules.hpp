// What the table of options says of a command line as a whole.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/cli/words.hpp"

namespace hvi::gen {

/// Throws InputError for options that are to come, or unknown, or without their value, or given
/// twice, or with others that they exclude, or without those that they need.
void check_rules(const Words& words, const CommandLine& line);

/// Throws InputError where the command itself is to come.
void check_command(const CommandEntry& command, const CommandLine& line);

}  // namespace hvi::gen

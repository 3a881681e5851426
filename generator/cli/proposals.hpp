// What shells propose where a word of the command line is completed.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "generator/options/option_table.hpp"

namespace hvi::gen {

/// Possible values of an option between blanks, as far as they are names: a family of methods is
/// `gauss:`, behind which a number is to follow.
[[nodiscard]] std::string proposals(const OptionEntry& option);

/// `--help --method ...`: of those that are built.
[[nodiscard]] std::string option_names(Command command);

/// The commands that are built.
[[nodiscard]] std::vector<CommandEntry> built_commands();

/// The names of those that take the option, between separators.
[[nodiscard]] std::string command_names(Commands commands, std::string_view separator);

}  // namespace hvi::gen

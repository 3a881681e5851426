// Proposals of shells for a word of the command line.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "generator/options/option_table.hpp"

namespace hvi::gen {

/// Returns possible values of an option between blanks, as far as they are names. A family of
/// methods is `gauss:`, which a number must follow.
[[nodiscard]] std::string proposals(const OptionEntry& option);

/// Returns the options of a command that are built: `--help --method ...`.
[[nodiscard]] std::string option_names(Command command);

/// Returns the commands that are built.
[[nodiscard]] std::vector<CommandEntry> built_commands();

/// Returns the names of the commands that take the option, between separators.
[[nodiscard]] std::string command_names(Commands commands, std::string_view separator);

}  // namespace hvi::gen

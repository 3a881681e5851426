// The table of options as CLI11 knows it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace hvi::gen {

/// Describes the grammar of the command line to CLI11. NOTE: CLI11 gets neither limits nor types
/// nor exclusions to check, because its messages know no place. It only refuses a last option
/// without its value.
void describe(CLI::App& app);

}  // namespace hvi::gen

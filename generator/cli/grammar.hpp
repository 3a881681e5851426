// The table of options as CLI11 knows it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace hvi::gen {

/// Tells CLI11 what the command line can say. NOTE: it gets neither limits nor types nor exclusions
/// to check, because its messages know no place. It only refuses a last option without its value.
void describe(CLI::App& app);

}  // namespace hvi::gen

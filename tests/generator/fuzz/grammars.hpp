// The grammars of what people give to hvi-gen.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "tests/generator/fuzz/grammar.hpp"

namespace hvi::gen::fuzz {

// Texts as command_line() and command() of targets.hpp read them.

[[nodiscard]] const Grammar& command_lines();  ///< any options of any command
[[nodiscard]] const Grammar& methods();        ///< basis functions and nodes
[[nodiscard]] const Grammar& scenes();
[[nodiscard]] const Grammar& searches();  ///< for symmetries, in scenes of any size
[[nodiscard]] const Grammar& tableau_files();

}  // namespace hvi::gen::fuzz

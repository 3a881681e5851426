// Numbers in files, in the header of a scene with loops.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/emit/system/class_names.hpp"
#include "generator/emit/text/text.hpp"
#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Writes the members of Parameters that are read from files.
void write_numbers_in_files(Writer& writer, const System& system);

/// Writes the member of a stepper that reads them; nothing where there are none.
void write_reading(Writer& writer, const System& system);

/// Returns whether a file has initial values of some variables.
[[nodiscard]] bool begins_in_file(const System& system);

/// Writes `if (...) { return; }` for files whose count of initial values differs from that of the
/// variables.
void write_conditions_of_files(Writer& writer, const System& system, const ClassNames& names);

/// Returns the #include of the reader; empty where nothing is read.
[[nodiscard]] std::string include_of_files(const System& system);

}  // namespace hvi::gen

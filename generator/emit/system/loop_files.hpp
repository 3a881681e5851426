// What a header of a scene with loops says of numbers that stand in files.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/emit/system/class_names.hpp"
#include "generator/emit/text/text.hpp"
#include "generator/ir/system.hpp"

namespace hvi::gen {

/// The members of Parameters that are read from files.
void write_numbers_in_files(Writer& writer, const System& system);

/// What reads them, as a member of a stepper; nothing where there are none.
void write_reading(Writer& writer, const System& system);

/// Whether some variables begin as a file has them.
[[nodiscard]] bool begins_in_file(const System& system);

/// `if (...) { return; }` where a file has not as many numbers as there are variables that begin
/// there.
void write_conditions_of_files(Writer& writer, const System& system, const ClassNames& names);

/// What reads them, as #include; empty where there are none.
[[nodiscard]] std::string include_of_files(const System& system);

}  // namespace hvi::gen

// Functions of compiled libraries.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

namespace hvi::gen {

/// Loads a library, which stays loaded until the process ends, and returns its functions of this
/// symbol and version, whose first member is an int: their version. Throws std::runtime_error where
/// it has none.
[[nodiscard]] const void* functions_of_library(const std::string& path, const char* symbol,
                                               int version);

}  // namespace hvi::gen

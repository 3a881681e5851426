// Checks of a C++ header that need no compiler.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string_view>

namespace hvi::gen::fuzz {

/// Throws std::logic_error for brackets without partners, words of comments that stand outside of
/// these, and names that keywords or macros of the standard library have.
void check_header(std::string_view text);

}  // namespace hvi::gen::fuzz

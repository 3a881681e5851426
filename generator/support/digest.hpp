// A number that tells a text from another one.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace hvi::gen {

/// Sixteen hexadecimal digits, by FNV-1a. NOTE: it tells what is whole from what is damaged, and is
/// no protection against who wants to deceive.
[[nodiscard]] std::string digest(std::string_view text);

}  // namespace hvi::gen

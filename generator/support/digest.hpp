// A number that identifies a text.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace hvi::gen {

/// Returns sixteen hexadecimal digits, by FNV-1a. NOTE: it detects damage, but is no protection
/// against deceit.
[[nodiscard]] std::string digest(std::string_view text);

}  // namespace hvi::gen

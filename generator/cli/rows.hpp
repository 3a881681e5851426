// Rows of texts under a title.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hvi::gen {

using TextRows = std::vector<std::vector<std::string>>;

/// Formats rows under a title, in columns as wide as they need to be.
[[nodiscard]] std::string text_table(std::string_view title, const TextRows& rows);

}  // namespace hvi::gen

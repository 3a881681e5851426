// Suggestions for a mistyped word.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hvi::gen {

/// Returns the candidates that are a few typing errors away from `word` (at most one in three
/// letters), the nearest first, at most three.
[[nodiscard]] std::vector<std::string_view>
nearest(std::string_view word, const std::vector<std::string_view>& candidates);

/// Lists names for a line of help: `x, y, z`. Of too many names it shows the first ones and the
/// last: `x[1], x[2], ..., p[64]`.
[[nodiscard]] std::string listed(const std::vector<std::string_view>& names);
[[nodiscard]] std::string listed(const std::vector<std::string>& names);

/// Returns "did you mean `gauss` or `fejer`?" for the nearest candidates, or else `otherwise`.
[[nodiscard]] std::string did_you_mean(std::string_view word,
                                       const std::vector<std::string_view>& candidates,
                                       std::string otherwise);

}  // namespace hvi::gen

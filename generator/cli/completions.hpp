// Scripts that complete words of the command line, of each shell its own.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace hvi::gen {

[[nodiscard]] std::string bash_completions();
[[nodiscard]] std::string zsh_completions();
[[nodiscard]] std::string fish_completions();

/// In quotes of bash and zsh, in which nothing is escaped.
[[nodiscard]] std::string in_quotes(std::string_view text);

}  // namespace hvi::gen

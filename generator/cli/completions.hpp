// Scripts that complete words of the command line, one for each shell.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace hvi::gen {

[[nodiscard]] std::string bash_completions();
[[nodiscard]] std::string zsh_completions();
[[nodiscard]] std::string fish_completions();

/// Quotes a text for bash and zsh, where nothing is escaped within quotes.
[[nodiscard]] std::string in_quotes(std::string_view text);

}  // namespace hvi::gen

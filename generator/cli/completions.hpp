// Scripts that complete words of the command line, one for each shell.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

namespace hvi::gen {

[[nodiscard]] std::string bash_completions();
[[nodiscard]] std::string zsh_completions();
[[nodiscard]] std::string fish_completions();

}  // namespace hvi::gen

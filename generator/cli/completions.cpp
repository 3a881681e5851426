// `hvi-gen completions`: writes the script that completes command lines in a shell.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/completions.hpp"

#include "generator/cli/commands.hpp"

namespace hvi::gen {

namespace {

std::string script(Shell shell) {
    switch (shell) {
    case Shell::bash: return bash_completions();
    case Shell::zsh: return zsh_completions();
    case Shell::fish: return fish_completions();
    }
    HVI_CHECK(false);
    return {};
}

}  // namespace

void run(const CompletionsOptions& options) { write_result(options.output, script(options.shell)); }

}  // namespace hvi::gen

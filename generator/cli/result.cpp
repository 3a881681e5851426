// Writes results.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/commands.hpp"
#include "generator/support/output_file.hpp"

namespace hvi::gen {

void write_result(const std::optional<std::filesystem::path>& file, std::string_view text) {
    if (file)
        write_file(*file, text);
    else
        write_standard_output(text);
}

void run(const Information& information) { write_standard_output(information.text); }

}  // namespace hvi::gen

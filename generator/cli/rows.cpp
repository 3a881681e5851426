// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/rows.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hvi::gen {

std::string text_table(std::string_view title, const TextRows& rows) {
    std::vector<std::size_t> widths(rows.front().size());
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());

    std::string text = fmt::format("{}\n", title);
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i)
            line += fmt::format("  {:<{}}", row[i], widths[i]);
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/draw/lines.hpp"

#include <fmt/format.h>

#include "generator/draw/gnuplot.hpp"

namespace hvi::gen {

FirstRows first_rows(const std::vector<double>& times, std::size_t count) {
    if (count >= times.size()) return {times.size(), times.empty() ? 0 : times.back(), true};
    return {count, times[count - 1], false};
}

std::string quoted_name(const std::filesystem::path& table) {
    return gnuplot_quoted(table.filename().string());
}

std::string time_label(const std::string& text) {
    return fmt::format("set xlabel {} offset 0,0.6\n", gnuplot_quoted(text));
}

std::string key_for(std::size_t lines) {
    return lines == 1 ? "set key off\n" : "set key outside right center samplen 2 font ',11'\n";
}

std::string drawn_line(const std::filesystem::path& table, const Line& line, std::size_t k,
                       const FirstRows& rows) {
    const std::string first = rows.are_all ? "" : fmt::format(" every ::0::{}", rows.count - 1);
    return fmt::format(" {} skip 1{} using (column({})):((column({})-({:.17g}))/{:g}) with lines "
                       "linestyle {} title {}",
                       quoted_name(table), first, line.x, line.y, line.less, line.unit,
                       k % style_count + 1, gnuplot_label(line.name));
}

std::string plot(const std::filesystem::path& table, const std::vector<Line>& lines,
                 const FirstRows& rows) {
    std::string text;
    for (std::size_t k = 0; k < lines.size(); ++k)
        text += (k == 0 ? "" : ",") + drawn_line(table, lines[k], k, rows);
    return key_for(lines.size()) + "plot" + text + "\n";
}

}  // namespace hvi::gen

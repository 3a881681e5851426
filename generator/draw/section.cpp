// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/draw/section.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/draw/gnuplot.hpp"

namespace hvi::gen {

namespace {

constexpr int section_width = 720, section_height = 640;
constexpr std::int64_t most_points = 20'000;  // some 2 MB of SVG

// Told apart by colour and, in print, by their marks.
constexpr const char* points = R"(
set datafile separator comma
set datafile commentschars '#'
set style line 1 linecolor rgb '#00508c' pointtype 7 pointsize 0.25
set style line 2 linecolor rgb '#c83200' pointtype 1 pointsize 0.4
set style line 3 linecolor rgb '#3c7828' pointtype 2 pointsize 0.4
set style line 4 linecolor rgb '#784696' pointtype 6 pointsize 0.4
set style line 5 linecolor rgb '#646464' pointtype 4 pointsize 0.4
set grid linecolor rgb '#d8d8d8'
set border linecolor rgb '#505050'
)";
constexpr std::size_t point_styles = 5;

/// NOTE: the names of events are identifiers, in which nothing is markup of a string of gnuplot.
std::string points_of(const SectionPicture& picture, std::size_t k) {
    const std::string& name = picture.events[k];
    const std::int64_t stride = (picture.rows + most_points - 1) / most_points;
    return fmt::format(
        "{} skip 1 every {} using (strcol(1) eq {} ? column({}) : NaN):(column({})) with "
        "points linestyle {} title {}",
        gnuplot_quoted(picture.table.filename().string()), std::max<std::int64_t>(1, stride),
        gnuplot_quoted(name), picture.x.number, picture.y.number, k % point_styles + 1,
        gnuplot_label(name));
}

}  // namespace

std::string draw(const SectionPicture& picture) {
    std::string script =
        points + fmt::format("set title {}\nset xlabel {}\nset ylabel {}\n",
                             gnuplot_label(picture.title), gnuplot_label(picture.x.name),
                             gnuplot_label(picture.y.name));
    script += picture.events.size() == 1 ? "set key off\n" : "set key outside right center\n";
    for (std::size_t k = 0; k < picture.events.size(); ++k)
        script += (k == 0 ? "plot " : ", ") + points_of(picture, k);
    return gnuplot_svg(script + "\n", section_width, section_height,
                       picture.table.has_parent_path() ? picture.table.parent_path() : ".");
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/draw/curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "generator/draw/gnuplot.hpp"

namespace hvi::gen {

namespace {

constexpr int page_width = 480, panel_height = 370, row_height = 22;
constexpr std::size_t longest_title = 46;   ///< characters, which fit beside each other
constexpr std::size_t longest_of_two = 18;  ///< of names of curves in two columns
constexpr const char* ring = "pointtype 6 pointsize 1.5 linecolor rgb '#202020' linewidth 1";

struct Style {
    const char* colour;
    const char* dashes;
    int mark;
};

// In black and white the marks tell, and the dashes.
constexpr std::array<Style, 8> styles{{{"#00508c", "solid", 7},
                                       {"#c83200", "'-'", 5},
                                       {"#3c7828", "'.-'", 9},
                                       {"#784696", "'.'", 13},
                                       {"#8c6400", "'_'", 11},
                                       {"#505050", "solid", 6},
                                       {"#00788c", "'-'", 4},
                                       {"#b40064", "'.-'", 8}}};

constexpr std::array<Style, 6> styles_aside{{{"#303030", "solid", 12},
                                             {"#606060", "'-'", 10},
                                             {"#808080", "solid", 14},
                                             {"#404040", "'.'", 1},
                                             {"#707070", "'.-'", 2},
                                             {"#909090", "'_'", 3}}};

/// The k-th style. When the colours begin again, dashes and marks are other ones.
template <std::size_t count>
Style mixed(const std::array<Style, count>& all, std::size_t k) {
    const Style& look = all.at((k + k / count) % count);
    return {all.at(k % count).colour, look.dashes, look.mark};
}

/// The style of the k-th curve of its kind.
Style style(const CurvesPicture::Curve& curve, std::size_t k) {
    return curve.is_aside ? mixed(styles_aside, k) : mixed(styles, k);
}

/// The two arrays of a curve.
std::string arrays(const std::string& name, const std::vector<std::pair<double, double>>& points) {
    std::vector<double> xs, ys;
    for (const auto& [x, y] : points) {
        xs.push_back(x);
        ys.push_back(y);
    }
    return gnuplot_array("x" + name, xs) + gnuplot_array("y" + name, ys);
}

std::string values_of(const std::string& name) {
    return fmt::format("x{0} using (x{0}[$1]):(y{0}[$1])", name);
}

/// In two lines where it is long: the first ends with a comma or colon, or else with a word.
std::string title_label(const std::string& title) {
    if (title.size() <= longest_title) return gnuplot_label(title);
    std::size_t end = title.find_last_of(",:", longest_title);
    if (end == std::string::npos) end = title.find_last_of(' ', longest_title);
    if (end == std::string::npos) return gnuplot_label(title);
    const std::size_t next = title.find_first_not_of(' ', end + 1);
    if (next == std::string::npos) return gnuplot_label(title);
    return gnuplot_label(title.substr(0, end + 1)) + ".\"\\n\"." +
           gnuplot_label(title.substr(next));
}

/// The names below the curves: how many columns they take, and how many rows.
struct Legend {
    std::size_t columns = 2, rows = 0;
};

Legend legend_of(const std::vector<std::string>& names) {
    std::size_t longest = 0;
    for (const std::string& name : names) longest = std::max(longest, name.size());
    const std::size_t columns = longest > longest_of_two ? 1 : 2;
    return {columns, (names.size() + columns - 1) / columns};
}

double largest_x(const CurvesPicture& picture) {
    double largest = 0;
    for (const CurvesPicture::Curve& curve : picture.curves)
        for (const auto& [x, y] : curve.points) largest = std::max(largest, std::abs(x));
    return largest;
}

std::string axes(const CurvesPicture& picture, const Legend& legend) {
    return fmt::format("set title {}\nset xlabel {} offset 0,0.4\nset ylabel {} offset 0.5,0\n",
                       title_label(picture.title), gnuplot_label(picture.x),
                       gnuplot_label(picture.y)) +
           (picture.x_is_logarithmic
                ? "set logscale xy\nset format xy '10^{%L}'\n"
                : "set logscale y\nset format y '10^{%L}'\n" + gnuplot_ticks(largest_x(picture))) +
           fmt::format("set grid linecolor rgb '#d8d8d8'\nset border linecolor rgb '#505050'\n"
                       "set key below maxcols {} height 1 Left reverse samplen 3\n",
                       legend.columns);
}

}  // namespace

std::string draw(const CurvesPicture& picture) {
    std::string data, plots;
    std::vector<std::string> names;
    std::vector<std::pair<double, double>> ringed;
    std::size_t aside = 0, drawn = 0;
    for (std::size_t k = 0; k < picture.curves.size(); ++k) {
        const CurvesPicture::Curve& curve = picture.curves[k];
        const Style look = style(curve, curve.is_aside ? aside++ : drawn++);
        if (curve.points.empty()) continue;
        ringed.insert(ringed.end(), curve.ringed.begin(), curve.ringed.end());
        names.push_back(curve.name);
        data += arrays(std::to_string(k), curve.points);
        const std::string marks =
            picture.has_marks ? fmt::format("linespoints pointtype {} pointsize 0.7", look.mark)
                              : std::string("lines");
        plots +=
            fmt::format("{} {} with {} linecolor rgb '{}' dashtype {} linewidth {} title {}",
                        plots.empty() ? "" : ",", values_of(std::to_string(k)), marks, look.colour,
                        look.dashes, curve.is_aside ? 0.8 : 1.5, gnuplot_label(curve.name));
    }
    if (!ringed.empty()) {
        names.push_back(picture.about_rings);
        data += arrays("_ringed", ringed);
        plots += fmt::format(", {} with points {} title {}", values_of("_ringed"), ring,
                             gnuplot_label(picture.about_rings));
    }
    if (plots.empty()) plots = " [1:10][1e-16:1] 1/0 notitle";
    const Legend legend = legend_of(names);
    return gnuplot_svg(axes(picture, legend) + data + "plot" + plots + "\n", page_width,
                       panel_height + row_height * static_cast<int>(legend.rows), ".");
}

}  // namespace hvi::gen

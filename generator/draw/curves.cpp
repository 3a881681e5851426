// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/draw/curves.hpp"

#include <fmt/format.h>

#include <array>

#include "generator/draw/gnuplot.hpp"

namespace hvi::gen {

namespace {

constexpr int page_width = 720, page_height = 600;

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

/// The k-th of its kind.
const Style& style(const CurvesPicture::Curve& curve, std::size_t k) {
    return curve.is_aside ? styles_aside.at(k % styles_aside.size()) : styles.at(k % styles.size());
}

/// NOTE: gnuplot reads data of its own script only from its standard input or as blocks, which need
/// line ends; so each curve is an array.
std::string array(const std::string& name, const std::vector<double>& values) {
    std::string text = fmt::format("array {}[{}] = [", name, values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        text += fmt::format("{}{:.6g}", i == 0 ? "" : ",", values[i]);
    return text + "]\n";
}

}  // namespace

std::string draw(const CurvesPicture& picture) {
    std::string script =
        fmt::format("set title {}\nset xlabel {}\nset ylabel {}\n", gnuplot_label(picture.title),
                    gnuplot_label(picture.x), gnuplot_label(picture.y));
    script += picture.x_is_logarithmic ? "set logscale xy\nset format xy '10^{%L}'\n"
                                       : "set logscale y\nset format y '10^{%L}'\n";
    script += "set grid linecolor rgb '#d8d8d8'\nset border linecolor rgb '#505050'\n"
              "set key below maxcols 2 Left reverse samplen 3\n";
    std::string plots;
    std::size_t aside = 0, drawn = 0;
    for (std::size_t k = 0; k < picture.curves.size(); ++k) {
        const CurvesPicture::Curve& curve = picture.curves[k];
        const Style& look = style(curve, curve.is_aside ? aside++ : drawn++);
        if (curve.points.empty()) continue;
        std::vector<double> xs, ys;
        for (const auto& [x, y] : curve.points) {
            xs.push_back(x);
            ys.push_back(y);
        }
        script += array(fmt::format("x{}", k), xs) + array(fmt::format("y{}", k), ys);
        const std::string marks =
            picture.has_marks ? fmt::format("linespoints pointtype {} pointsize 0.7", look.mark)
                              : std::string("lines");
        plots += fmt::format("{} x{} using (x{}[$1]):(y{}[$1]) with {} linecolor rgb '{}' "
                             "dashtype {} linewidth {} title {}",
                             plots.empty() ? "" : ",", k, k, k, marks, look.colour, look.dashes,
                             curve.is_aside ? 0.8 : 1.5, gnuplot_label(curve.name));
    }
    if (plots.empty()) plots = " [1:10][1e-16:1] 1/0 notitle";
    return gnuplot_svg(script + "plot" + plots + "\n", page_width, page_height, ".");
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/draw/trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/draw/density.hpp"
#include "generator/draw/departures.hpp"
#include "generator/draw/gnuplot.hpp"
#include "generator/draw/lines.hpp"
#include "generator/draw/palette.hpp"

namespace hvi::gen {

namespace {

constexpr int picture_width = 1000, picture_height = 560, tall_picture_height = 680;
constexpr double top = 0.95;            // of the panels, below the title of all
constexpr std::size_t most_turns = 40;  // of a curve over time, some 400 pixels wide

std::string with_end(const std::string& title, const FirstRows& rows) {
    return rows.are_all ? title : fmt::format("{}, until t = {:.4g}", title, rows.until);
}

/// A part of the page, whose lower left corner is at 0, 0 and the upper right one at 1, 1.
struct Panel {
    double x, y, width, height;
};

std::string panel(const Panel& panel, const std::string& title) {
    return fmt::format("set origin {},{}\nset size {},{}\nset title {} offset 0,-0.6\n", panel.x,
                       panel.y, panel.width, panel.height, gnuplot_label(title));
}

std::string time_axis(double until) {
    return time_label("t") + gnuplot_ticks(until) + "set autoscale xfix\nunset ylabel\n";
}

/// The columns over time: the beginning of the run, where more would be a bar.
std::string columns_over_time(const TrajectoryPicture& picture, const Panel& place) {
    std::vector<std::size_t> numbers;
    std::vector<Line> lines;
    for (const TableColumn& column : picture.columns) {
        numbers.push_back(column.number);
        lines.push_back({time_column, column.number, 0, column.name});
    }
    const auto times = read_columns(picture.table, {time_column}).front();
    const auto columns = read_columns(picture.table, numbers);
    std::size_t count = times.size();
    for (const std::vector<double>& column : columns)
        count = std::min(count, rows_with_turns(column, least_swing * extent(columns), most_turns));
    const FirstRows rows = first_rows(times, count);
    const std::string what =
        lines.size() == 1 ? lines.front().name + " over t" : picture.title_of_columns + " over t";
    return time_axis(rows.until) + "set format y '%g'\nset ytics autofreq\n" +
           panel(place, with_end(what, rows)) + plot(picture.table, lines, rows);
}

/// NOTE: of steps in scaled time the table alone knows where they end.
double last_time(const TrajectoryPicture& picture) {
    const auto times = read_columns(picture.table, {time_column}).front();
    return times.empty() ? 0 : times.back();
}

std::string over_time(const TrajectoryPicture& picture, double width) {
    if (picture.kept.empty()) return columns_over_time(picture, {0, 0, width, top});
    std::string script =
        time_axis(last_time(picture)) + "set format y '%g'\nset ytics nomirror autofreq\n";
    const bool has_more = picture.kept.size() > 1;
    const DeparturesPanel first = departures_panel(picture, 0, 1);
    script += panel({0, has_more ? top / 2 : 0, width, has_more ? top / 2 : top}, first.title) +
              first.script;
    if (!has_more) return script;
    const DeparturesPanel others = departures_panel(picture, 1, picture.kept.size());
    return script + panel({0, 0, width, top / 2}, others.title) + others.script;
}

/// A part of the picture beside what is kept, and what comes before all parts.
struct Beside {
    double width = 0;
    std::string before, script;
    int height = picture_height;  ///< of the whole picture
};

FirstRows rows_of(const TableCurves& view) {
    std::vector<std::size_t> numbers{time_column};
    for (const auto& [x, y] : view.curves) {
        numbers.push_back(x.number);
        numbers.push_back(y.number);
    }
    auto columns = read_columns(view.table, numbers);
    std::vector<PlaneCurve> curves;
    for (std::size_t i = 1; i < columns.size(); i += 2)
        curves.emplace_back(std::move(columns[i]), std::move(columns[i + 1]));
    return first_rows(columns.front(), rows_with_room(curves));
}

/// The curves, and below them the columns over time, unless these are where else is what is kept.
Beside beside(const TrajectoryPicture& picture, const TableCurves& view) {
    if (view.curves.empty()) return {};
    constexpr double width = 0.45, below = 0.4;
    const bool has_below = !picture.kept.empty() && !picture.columns.empty();
    std::vector<Line> lines;
    for (const auto& [x, y] : view.curves)
        lines.push_back({x.number, y.number, 0, y.name + " over " + x.name});
    const auto& [x, y] = view.curves.front();
    const std::string axes =
        fmt::format("set autoscale x\nset format y '%g'\nset xtics autofreq\nset xlabel {} offset "
                    "0,0.6\nset ylabel {}\n",
                    gnuplot_label(x.name), gnuplot_label(y.name));
    const FirstRows rows = rows_of(view);
    const double bottom = has_below ? below * top : 0;
    const std::string title = with_end(y.name + " over " + x.name, rows);
    return {width, "",
            axes + panel({1 - width, bottom, width, top - bottom}, title) +
                plot(view.table, lines, rows) +
                (has_below ? columns_over_time(picture, {1 - width, 0, width, bottom}) : ""),
            has_below ? tall_picture_height : picture_height};
}

/// Axes of a panel with an image.
std::string image_axes(const std::string& x, const std::string& y) {
    return fmt::format("set autoscale fix\nset format y '%g'\nset ytics autofreq\nset xlabel {} "
                       "offset 0,0.6\nset ylabel {}\nset key off\n",
                       gnuplot_label(x), gnuplot_label(y));
}

/// The value of an index, of which `number` says how many are before it.
std::string value_of(const ShownIndex& index, const std::string& number) {
    return fmt::format("({}*{}+{})", number, index.stride, index.first);
}

/// NOTE: gnuplot counts the columns of a matrix from 0 on, which here is the time.
Beside beside(const TrajectoryPicture& picture, const PlacesInTime& view) {
    constexpr double width = 0.55;
    return {width, gnuplot_palette(viridis),
            image_axes("t", "i") + gnuplot_ticks(picture.until) +
                panel({1 - width, 0, width, top}, view.name + "[i] over t") +
                fmt::format("plot {} skip 1 matrix every 1:1:1:0:{}:{} using ($2*{:.17g}):{}:3 "
                            "with image\n",
                            quoted_name(view.table), view.places.count, view.rows - 1,
                            view.time_of_row, value_of(view.places, "($1-1)"))};
}

/// NOTE: gnuplot makes an image of a matrix, or of a list of places and values, which a row of the
/// table becomes; not of a row.
Beside beside(const TrajectoryPicture& picture, const FieldAtEnds& view) {
    constexpr double width = 0.4;
    constexpr double most_ticks = 3;  // below an image of a third of the width of the page
    const std::size_t fast = view.second.count;
    const auto length =
        static_cast<double>(view.first.count) * static_cast<double>(view.first.stride);
    Beside result{width, gnuplot_palette(viridis),
                  "set datafile separator whitespace\nset size ratio -1\n" + image_axes("i", "j") +
                      gnuplot_ticks(length, most_ticks)};
    for (const int row : {0, 1}) {
        result.before +=
            fmt::format("set table $field{0}\nplot {1} skip 1 matrix every 1:1:1:{0}:{2}:{0} using "
                        "{3}:{4}:3 with table\nunset table\n",
                        row, quoted_name(view.table), view.first.count * fast,
                        value_of(view.first, fmt::format("int(($1-1)/{})", fast)),
                        value_of(view.second, fmt::format("(int($1-1)%{})", fast)));
        result.script +=
            panel({1 - width, row == 0 ? top / 2 : 0, width, top / 2},
                  fmt::format("{}[i,j] at t = {:.10g}", view.name, row == 0 ? 0 : picture.until)) +
            fmt::format("plot $field{} using 1:2:3 with image\n", row);
    }
    return result;
}

std::string stem(const std::string& name) { return name.substr(0, name.find('[')); }

}  // namespace

std::string draw(const TrajectoryPicture& picture) {
    const Beside part =
        std::visit([&](const auto& view) { return beside(picture, view); }, picture.view);
    const std::string script =
        line_styles + part.before +
        fmt::format("set multiplot title {}\n", gnuplot_label(picture.title)) +
        over_time(picture, 1 - part.width) + part.script + "unset multiplot\n";
    // NOTE: in its directory, whose name may have in it what no script can quote.
    return gnuplot_svg(script, picture_width, part.height,
                       picture.table.has_parent_path() ? picture.table.parent_path() : ".");
}

std::vector<TableCurve> curves_of(const std::vector<TableColumn>& coordinates,
                                  const std::vector<TableColumn>& momenta) {
    if (coordinates.empty() || coordinates.size() + momenta.size() == 1) return {};
    if (coordinates.size() == 1) return {{coordinates.front(), momenta.front()}};
    const std::string first = stem(coordinates.front().name);
    std::vector<TableColumn> x, y;
    for (const TableColumn& column : coordinates) {
        if (stem(column.name) == first)
            x.push_back(column);
        else if (y.empty() || stem(column.name) == stem(y.front().name))
            y.push_back(column);
    }
    if (x.size() != y.size()) return {{coordinates[0], coordinates[1]}};
    std::vector<TableCurve> curves;
    for (std::size_t i = 0; i < x.size(); ++i) curves.emplace_back(x[i], y[i]);
    return curves;
}

}  // namespace hvi::gen

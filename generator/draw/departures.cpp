// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/draw/departures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "generator/draw/density.hpp"
#include "generator/draw/gnuplot.hpp"
#include "generator/draw/lines.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t most_turns_of_line = 80;  // some six pixels for each
constexpr std::size_t turns_in_part = 8;        // of a band: so it has the range of four swings
constexpr std::size_t most_parts = 100;
constexpr std::size_t most_bands = 8;  // in a panel: more would hide each other

/// The power of ten that numbers up to `largest` are shown in: 1 where they need none.
int power_for(double largest) {
    constexpr int least = -3, most = 4;
    if (!(largest > 0) || !std::isfinite(largest)) return 0;
    const int power = static_cast<int>(std::floor(std::log10(largest)));
    return power < least || power >= most ? power : 0;
}

double largest_of(const std::vector<std::vector<double>>& columns) {
    double largest = 0;
    for (const std::vector<double>& column : columns)
        for (const double value : column)
            if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    return largest;
}

/// The band of a curve that turns back too often for a line, else an empty one.
Band band_of(const std::vector<double>& times, const std::vector<double>& values) {
    const std::size_t shown =
        rows_with_turns(values, least_swing * extent({values}), most_turns_of_line);
    if (shown >= values.size()) return {};
    const std::size_t parts = values.size() * most_turns_of_line / turns_in_part / shown;
    return band(times, values, std::min(parts, most_parts));
}

std::string arrays_of(const Band& band, std::size_t k) {
    return gnuplot_array(fmt::format("x{}", k), band.x) +
           gnuplot_array(fmt::format("least{}", k), band.least) +
           gnuplot_array(fmt::format("most{}", k), band.most) +
           gnuplot_array(fmt::format("mean{}", k), band.mean);
}

/// The part of `plot` that draws the band of arrays_of().
std::string drawn_band(const std::string& name, std::size_t k) {
    return fmt::format(" x{0} using (x{0}[$1]):(least{0}[$1]):(most{0}[$1]) with filledcurves "
                       "linestyle {1} fillstyle transparent solid 0.3 noborder title {2}, x{0} "
                       "using (x{0}[$1]):(mean{0}[$1]) with lines linestyle {1} notitle",
                       k, k % style_count + 1, gnuplot_label(name));
}

/// Commands with an axis of the whole time, as the middles of parts do not reach its ends.
std::string whole_time(const std::vector<double>& times, const std::string& commands) {
    const auto [first, last] = std::minmax(times.front(), times.back());
    return fmt::format("set xrange [{:.17g}:{:.17g}]\n{}set autoscale x\n", first, last, commands);
}

std::string title_of(const std::vector<Line>& lines, int power) {
    return (lines.size() == 1 ? lines.front().name + ", less that at the start"
                              : "invariants, less those at the start") +
           (power == 0 ? "" : fmt::format(", in 1e{}", power));
}

}  // namespace

DeparturesPanel departures_panel(const TrajectoryPicture& picture, std::size_t begin,
                                 std::size_t end) {
    const auto times = read_columns(picture.table, {time_column}).front();
    std::vector<Line> lines;
    std::vector<std::size_t> numbers;
    for (std::size_t i = begin; i < end; ++i) {
        const TrajectoryPicture::Kept& kept = picture.kept[i];
        lines.push_back({time_column, kept.column.number, kept.start, kept.column.name});
        numbers.push_back(kept.column.number);
    }
    auto columns = read_columns(picture.table, numbers);
    for (std::size_t k = 0; k < columns.size(); ++k)
        for (double& value : columns[k]) value -= lines[k].less;
    // NOTE: a power that no double has would be a division by zero.
    const int power = std::max(power_for(largest_of(columns)), -300);
    const double unit = std::pow(10, power);

    std::string arrays, text, label = "t";
    for (std::size_t k = 0; k < lines.size(); ++k) {
        lines[k].unit = unit;
        for (double& value : columns[k]) value /= unit;
        const Band band = k < most_bands ? band_of(times, columns[k]) : Band{};
        if (!band.x.empty()) {
            arrays += arrays_of(band, k);
            label = "t (shaded: range, line: mean)";
        }
        text += (k == 0 ? "" : ",") + (band.x.empty() ? drawn_line(picture.table, lines[k], k)
                                                      : drawn_band(lines[k].name, k));
    }
    return {title_of(lines, power),
            key_for(lines.size()) + arrays + time_label(label) +
                (arrays.empty() ? "plot" + text + "\n" : whole_time(times, "plot" + text + "\n"))};
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/draw/map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "generator/draw/full_grid.hpp"
#include "generator/draw/gnuplot.hpp"
#include "generator/draw/palette.hpp"
#include "generator/draw/pixels.hpp"
#include "generator/draw/plotted_numbers.hpp"

namespace hvi::gen {

namespace {

constexpr int map_width = 720, map_height = 640;
constexpr std::size_t most_dots = 20'000;  // some 2 MB of SVG
constexpr std::size_t most_large_dots = 2'000;
constexpr std::size_t most_in_image = 1000;     // in each direction: at most 4 MB of SVG
constexpr std::size_t most_rectangles = 5'000;  // of an image whose pixels have sharp edges
constexpr std::size_t image_width = 560, image_height = 540;  // of many points

constexpr const char* map_style = R"(
set key off
set border linecolor rgb '#505050'
set format x '%g'
set format y '%g'
set grid linecolor rgb '#d8d8d8'
)";
// For numbers of points, from few to many.
constexpr const char* shades[]{"#9ec4e0", "#00508c", "#001a33"};
constexpr const char* grey = "#b0b0b0";
constexpr const char* white = "#ffffff";

std::vector<MapPoint> points_of(const MapPicture& picture) {
    const std::size_t width = picture.z.empty() ? 2 : 3;
    std::vector<MapPoint> points;
    for (std::size_t at = 0; at + width <= picture.values.size(); at += width) {
        MapPoint point{picture.values[at], picture.values[at + 1]};
        if (!is_shown(point.x) || !is_shown(point.y)) continue;
        if (width == 3 && is_shown(picture.values[at + 2])) point.z = picture.values[at + 2];
        points.push_back(point);
    }
    return points;
}

bool has_gap(const std::vector<double>& values) {
    return std::any_of(values.begin(), values.end(), [](double z) { return std::isnan(z); });
}

/// Colours of values, with what is said of them.
struct MapScale {
    NumberRange range;
    std::string label;
};

/// Returns the scale of values, of which the picture shows those in the range; others are its ends.
MapScale scale_of(const MapPicture& picture, std::vector<double>& values) {
    const NumberRange all = range_of(values), range = colour_range_of(values);
    for (double& value : values)
        if (std::isfinite(value)) value = std::clamp(value, range.from, range.to);
    const bool has_more = all.from < range.from || range.to < all.to;
    return {range, picture.z + (has_more ? ", with 1 % beyond each end" : "")};
}

std::string svg_of(const MapPicture& picture, const std::string& label, const std::string& script) {
    const std::string labels =
        fmt::format("set title {}\nset xlabel {}\nset ylabel {}\nset cblabel {}\n",
                    gnuplot_label(picture.title), gnuplot_label(picture.x),
                    gnuplot_label(picture.y), gnuplot_label(label));
    return gnuplot_svg(map_style + labels + script, map_width, map_height, ".");
}

// ---- images ----

/// Draws values on a grid, all of them finite. NOTE: gnuplot loses the corners of an image that are
/// NaN, and with them the image.
std::string image(const MapPicture& picture, const FullGrid& grid, const std::string& label,
                  const FootedPalette& colours) {
    std::vector<double> numbers;
    for (std::size_t k = 0; k < grid.values.size(); ++k)
        numbers.insert(numbers.end(),
                       {grid.x[k % grid.x.size()], grid.y[k / grid.x.size()], grid.values[k]});
    const PlottedNumbers plotted(numbers);
    return svg_of(
        picture, label,
        colours.commands() + "set autoscale fix\n" +
            fmt::format("plot {} binary record=({},{}) format='%3double' using 1:2:3 with "
                        "image{}\n",
                        plotted.quoted_path(), grid.x.size(), grid.y.size(),
                        grid.values.size() <= most_rectangles ? " pixels" : ""));
}

std::string image_of_grid(const MapPicture& picture, FullGrid grid) {
    std::vector<const char*> feet;
    if (has_gap(grid.values)) feet.push_back(grey);
    const MapScale scale = scale_of(picture, grid.values);
    const FootedPalette colours(viridis, feet, scale.range);
    for (double& value : grid.values)
        if (std::isnan(value)) value = colours.foot(0);
    return image(picture, grid, scale.label, colours);
}

/// Returns the middles of pixels.
std::vector<double> middles(const NumberRange& range, std::size_t count) {
    std::vector<double> result;
    for (std::size_t k = 0; k < count; ++k) {
        const double part = (static_cast<double>(k) + 0.5) / static_cast<double>(count);
        result.push_back(std::lerp(range.from, range.to, part));
    }
    return result;
}

/// Draws the numbers of points, or the means of their values.
std::string image_of_many(const MapPicture& picture, const std::vector<MapPoint>& points) {
    const Pixels all = pixels(points, image_width, image_height);
    FullGrid grid{middles(all.x, image_width), middles(all.y, image_height), all.means};
    std::vector<const char*> feet{white, grey};
    MapScale scale;
    if (picture.z.empty()) {
        feet.pop_back();
        for (std::size_t k = 0; k < grid.values.size(); ++k)
            grid.values[k] = std::log10(all.counts[k]);
        scale = {range_of(grid.values), "points in a pixel, log10"};
    } else {
        scale = scale_of(picture, grid.values);
    }
    const FootedPalette colours = picture.z.empty() ? FootedPalette(shades, feet, scale.range)
                                                    : FootedPalette(viridis, feet, scale.range);
    for (std::size_t k = 0; k < grid.values.size(); ++k)
        if (!std::isfinite(grid.values[k]))
            grid.values[k] = colours.foot(all.counts[k] > 0 ? 1 : 0);
    return image(picture, grid, scale.label, colours);
}

// ---- points ----

std::string dots(const MapPicture& picture, const std::vector<MapPoint>& points) {
    std::vector<double> values, numbers;
    for (const MapPoint& point : points) values.push_back(point.z);
    const bool has_colours = !picture.z.empty();
    const MapScale scale = scale_of(picture, values);
    const FootedPalette colours(
        viridis, has_gap(values) ? std::vector{grey} : std::vector<const char*>{}, scale.range);
    for (std::size_t k = 0; k < points.size(); ++k)
        numbers.insert(numbers.end(), {points[k].x, points[k].y,
                                       std::isnan(values[k]) ? colours.foot(0) : values[k]});
    const PlottedNumbers plotted(numbers);
    if (points.empty()) return svg_of(picture, scale.label, "plot [0:1] [0:1] NaN\n");
    const double size = !has_colours ? 0.25 : points.size() <= most_large_dots ? 0.6 : 0.35;
    return svg_of(picture, scale.label,
                  colours.commands() +
                      fmt::format("plot {} binary record={} format='%3double' using {} "
                                  "pointtype 7 pointsize {}\n",
                                  plotted.quoted_path(), points.size(),
                                  has_colours ? "1:2:3 with points palette"
                                              : "1:2 with points linecolor rgb '#00508c'",
                                  size));
}

}  // namespace

std::string draw(const MapPicture& picture) {
    const std::vector<MapPoint> points = points_of(picture);
    const std::optional<FullGrid> grid = picture.z.empty() ? std::nullopt : full_grid(points);
    if (grid) return image_of_grid(picture, thinned(*grid, most_in_image));
    return points.size() > most_dots ? image_of_many(picture, points) : dots(picture, points);
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/render/stability_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "generator/support/ticks.hpp"

namespace hvi::gen {

namespace {

// Lengths in pixels. The plot's area:
constexpr double plot_left = 70;
constexpr double plot_right = 780;
constexpr double plot_top = 92;
constexpr double plot_bottom = 412;
constexpr double picture_width = 800;
constexpr double line_height = 18;
constexpr std::size_t most_columns = 100;  // columns of the text below the plot
/// Half the trace is drawn between these values and their negatives.
constexpr double most = 2.5;

/// Converts z and half the trace to pixels.
class Axes {
public:
    explicit Axes(long until) : until_(static_cast<double>(until)) {}

    [[nodiscard]] double until() const { return until_; }
    [[nodiscard]] double x(double z) const {
        return plot_left + (plot_right - plot_left) * z / until_;
    }
    [[nodiscard]] static double y(double half_trace) {
        return (plot_top + plot_bottom) / 2 - (plot_bottom - plot_top) / 2 * half_trace / most;
    }

    [[nodiscard]] double tick() const {
        constexpr double most_ticks = 10.5;
        return distance_of_ticks(until_, most_ticks);
    }

private:
    double until_;
};

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        result += c == '&'   ? std::string("&amp;")
                  : c == '<' ? std::string("&lt;")
                  : c == '>' ? std::string("&gt;")
                             : std::string(1, c);
    }
    return result;
}

std::string text_at(double x, double y, const std::string& attributes, const std::string& text) {
    return fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\"{}>{}</text>\n", x, y,
                       attributes.empty() ? "" : " " + attributes, escaped(text));
}

std::string line(double x1, double y1, double x2, double y2, const std::string& kind) {
    return fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" "
                       "class=\"{}\"/>\n",
                       x1, y1, x2, y2, kind);
}

std::string shading(const Axes& axes, const LinearStability& stability) {
    std::string result;
    for (const StabilityInterval& interval : stability.stable) {
        const double x1 = axes.x(interval.low.nearest_double());
        const double x2 = axes.x(interval.high.nearest_double());
        result += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
                              "class=\"stable\"/>\n",
                              x1, plot_top, x2 - x1, plot_bottom - plot_top);
    }
    return result;
}

std::string grid(const Axes& axes) {
    std::string result;
    for (const int value : {-1, 0, 1}) {
        const double y = Axes::y(value);
        result += line(plot_left, y, plot_right, y, value == 0 ? "zero" : "one");
    }
    result += fmt::format(
        "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" class=\"frame\"/>\n",
        plot_left, plot_top, plot_right - plot_left, plot_bottom - plot_top);
    const int ticks = static_cast<int>(std::floor(axes.until() / axes.tick() + 1e-9));
    for (int i = 0; i <= ticks; ++i) {
        const double z = i * axes.tick();
        result += line(axes.x(z), plot_bottom, axes.x(z), plot_bottom + 5, "tick");
        result +=
            text_at(axes.x(z), plot_bottom + 19, "class=\"middle\"", fmt::format("{:.6g}", z));
    }
    for (int value = -2; value <= 2; ++value) {
        result += line(plot_left - 5, Axes::y(value), plot_left, Axes::y(value), "tick");
        result +=
            text_at(plot_left - 9, Axes::y(value) + 4, "class=\"end\"", fmt::format("{}", value));
    }
    result +=
        text_at((plot_left + plot_right) / 2, plot_bottom + 38, "class=\"middle\"", "z = h·ω");
    const double middle = (plot_top + plot_bottom) / 2;
    result += text_at(24, middle,
                      fmt::format("class=\"middle\" transform=\"rotate(-90 24 {:.2f})\"", middle),
                      "trace/2");
    return result;
}

/// Draws poles as dashed lines, with labels above the plot: in the first row with room, else in the
/// last.
std::string poles(const Axes& axes, const LinearStability& stability) {
    constexpr double label_width = 80;
    std::array<double, 3> taken{};  // the end of the text in each row
    std::string result;
    for (const Number& pole : stability.poles) {
        const double x = axes.x(pole.nearest_double());
        std::size_t row = 0;
        while (row + 1 < taken.size() && x - label_width / 2 < taken[row]) { ++row; }
        taken[row] = x + label_width / 2;
        result += line(x, plot_top, x, plot_bottom, "pole");
        result += text_at(x, plot_top - 6 - 14 * static_cast<double>(row), "class=\"middle\"",
                          "pole " + pole.decimal(4));
    }
    return result;
}

/// Returns the arguments of the curve: every pixel, all special points, and closer and closer to
/// the poles.
std::vector<double> arguments(const Axes& axes, const LinearStability& stability) {
    std::vector<double> result;
    const double step = axes.until() / (plot_right - plot_left);
    for (int i = 1; i < static_cast<int>(plot_right - plot_left); ++i) {
        result.push_back(i * step);
    }
    for (const StabilityInterval& interval : stability.stable) {
        result.push_back(interval.low.nearest_double());
        result.push_back(interval.high.nearest_double());
    }
    for (const TouchingPoint& point : stability.touching) {
        result.push_back(point.z.nearest_double());
    }
    constexpr int halvings = 20;
    for (const Number& pole : stability.poles) {
        const double z = pole.nearest_double();
        for (int k = 0; k < halvings; ++k) {
            result.push_back(z - std::ldexp(step, -k));
            result.push_back(z + std::ldexp(step, -k));
        }
    }
    std::sort(result.begin(), result.end());
    return result;
}

/// Draws the curve, broken at the poles. Parts above or below the plot are drawn a little outside,
/// and clipped.
std::string curve(const Axes& axes, const OscillatorMap& map, const LinearStability& stability) {
    constexpr double outside = 1.5 * most;
    std::string path;
    bool is_drawing = false;
    auto pole = stability.poles.begin();
    for (const double z : arguments(axes, stability)) {
        while (pole != stability.poles.end() && pole->nearest_double() <= z) {
            is_drawing = false;
            ++pole;
        }
        const auto value = z < 0 ? std::nullopt : value_at(map.half_trace, z);
        if (!value) {
            is_drawing = false;
            continue;
        }
        path += fmt::format("{}{:.2f} {:.2f}\n", is_drawing ? 'L' : 'M', axes.x(z),
                            Axes::y(std::clamp(*value, -outside, outside)));
        is_drawing = true;
    }
    return "<path class=\"curve\" clip-path=\"url(#plot)\" d=\"" + path + "\"/>\n";
}

std::string circle(double x, double y, bool is_identity) {
    return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"4\" class=\"{}\"/>\n", x, y,
                       is_identity ? "identity" : "jordan");
}

std::string touching(const Axes& axes, const LinearStability& stability) {
    std::string result;
    for (const TouchingPoint& point : stability.touching) {
        result +=
            circle(axes.x(point.z.nearest_double()), Axes::y(point.half_trace), point.is_identity);
    }
    return result;
}

/// Breaks `head` and items into lines that fit below the plot.
std::vector<std::string> broken(const std::string& head, const std::vector<std::string>& items) {
    std::vector<std::string> lines{head};
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::string item = " " + items[i] + (i + 1 < items.size() ? "," : "");
        if (lines.back().size() + item.size() > most_columns) { lines.emplace_back(); }
        lines.back() += item;
    }
    return lines;
}

std::string short_text(const Number& number) {
    return fmt::format("{:.6g}", number.nearest_double());
}

/// Describes the picture in words.
std::vector<std::string> words(const LinearStability& stability) {
    std::vector<std::string> intervals;
    for (const StabilityInterval& interval : stability.stable) {
        intervals.push_back(fmt::format("{}{}, {}{}", interval.low_included ? '[' : '(',
                                        short_text(interval.low), short_text(interval.high),
                                        interval.high_included ? ']' : ')'));
    }
    std::vector<std::string> singular;
    for (const Number& pole : stability.poles) { singular.push_back(short_text(pole)); }
    std::vector<std::string> lines =
        broken(intervals.empty() ? "Nowhere stable" : "Stable for z in", intervals);
    const auto more = broken(singular.empty() ? "No poles" : "Poles at z =", singular);
    lines.insert(lines.end(), more.begin(), more.end());
    return lines;
}

std::string legend(double y, const LinearStability& stability) {
    std::string result = fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"26\" height=\"13\" "
                                     "class=\"stable key\"/>\n",
                                     plot_left, y - 11);
    result += text_at(plot_left + 33, y, "", "stable: powers of the map are bounded");
    double x = plot_left + 320;
    if (!stability.poles.empty()) {
        result += line(x, y - 5, x + 26, y - 5, "pole");
        result += text_at(x + 33, y, "", "pole");
        x += 90;
    }
    for (const bool is_identity : {true, false}) {
        const auto& points = stability.touching;
        if (std::any_of(points.begin(), points.end(), [&](const TouchingPoint& point) {
                return point.is_identity == is_identity;
            })) {
            result += circle(x + 5, y - 5, is_identity);
            result += text_at(x + 15, y, "", is_identity ? "map is ±I" : "resonance");
            x += 110;
        }
    }
    return result;
}

// NOTE: grey, black and dashes are equally clear in a print in black and white.
constexpr const char* style = R"(<style>
text { font-family: sans-serif; font-size: 13px; fill: #000 }
.middle { text-anchor: middle }
.end { text-anchor: end }
.title { font-size: 16px; font-weight: bold }
.stable { fill: #d8d8d8 }
.key, .frame { stroke: #000; stroke-width: 1 }
.frame { fill: none }
.tick { stroke: #000; stroke-width: 1 }
.one { stroke: #000; stroke-width: 1 }
.zero { stroke: #888; stroke-width: 0.7 }
.pole { stroke: #000; stroke-width: 1; stroke-dasharray: 5 4 }
.curve { fill: none; stroke: #000; stroke-width: 2; stroke-linejoin: round }
.identity { fill: #fff; stroke: #000; stroke-width: 1.5 }
.jordan { fill: #000 }
</style>
)";

}  // namespace

std::string stability_svg(const std::string& name, const OscillatorMap& map,
                          const LinearStability& stability) {
    const Axes axes(stability.until);
    const std::vector<std::string> below = words(stability);
    const double legend_at = plot_bottom + 66;
    const double height = legend_at + line_height * static_cast<double>(below.size() + 1);
    std::string svg = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" "
                                  "height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\">\n",
                                  picture_width, height);
    svg += "<title>" + escaped("Linear stability of " + name) + "</title>\n" + style;
    svg += fmt::format("<clipPath id=\"plot\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>"
                       "</clipPath>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
                       plot_left, plot_top, plot_right - plot_left, plot_bottom - plot_top);
    svg += text_at(plot_left, 28, "class=\"title\"", "Linear stability of " + name);
    svg += text_at(plot_left, 48, "", "Half the trace of one step for H = (p² + ω² q²)/2");
    svg += shading(axes, stability) + grid(axes) + poles(axes, stability);
    svg += curve(axes, map, stability) + touching(axes, stability) + legend(legend_at, stability);
    for (std::size_t i = 0; i < below.size(); ++i) {
        svg +=
            text_at(plot_left, legend_at + line_height * static_cast<double>(i + 1), "", below[i]);
    }
    return svg + "</svg>\n";
}

}  // namespace hvi::gen

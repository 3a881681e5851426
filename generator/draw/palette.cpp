// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/draw/palette.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "generator/support/ticks.hpp"

namespace hvi::gen {

namespace {

constexpr double height_of_foot = 0.04, height_of_colour = 0.03;  // in it; of the range
constexpr double most_ticks_of_colours = 8;

}  // namespace

NumberRange range_of(const std::vector<double>& numbers) {
    constexpr double most = std::numeric_limits<double>::max();
    NumberRange range{most, -most};
    for (const double number : numbers) {
        if (!std::isfinite(number)) continue;
        range.from = std::min(range.from, number);
        range.to = std::max(range.to, number);
    }
    if (range.from > range.to) return {0, 1};
    if (range.from < range.to) return range;
    const double around = range.from == 0 ? 1 : std::abs(range.from) / 2;
    return {range.from - around, range.to + around};
}

NumberRange colour_range_of(const std::vector<double>& numbers) {
    constexpr std::size_t enough = 200;
    constexpr double much = 3;
    const NumberRange all = range_of(numbers);
    std::vector<double> finite;
    for (const double number : numbers)
        if (std::isfinite(number)) finite.push_back(number);
    if (finite.size() < enough) return all;
    const auto nth = [&](std::size_t n) {
        const auto place = finite.begin() + static_cast<std::ptrdiff_t>(n);
        std::nth_element(finite.begin(), place, finite.end());
        return *place;
    };
    const std::size_t hundredth = finite.size() / 100;
    const NumberRange most{nth(hundredth), nth(finite.size() - 1 - hundredth)};
    const bool are_few_far = (all.to - all.from) > much * (most.to - most.from);
    return are_few_far && most.from < most.to ? most : all;
}

std::string gnuplot_palette(std::span<const char* const> colours) {
    std::string list;
    for (std::size_t k = 0; k < colours.size(); ++k)
        list += fmt::format("{}{} '{}'", k == 0 ? "" : ", ", k, colours[k]);
    return "set palette defined (" + list + ")\nset format cb '%g'\n";
}

double FootedPalette::foot(std::size_t number) const {
    return range_.from -
           (static_cast<double>(number) + 0.6) * height_of_foot * (range_.to - range_.from);
}

std::string FootedPalette::commands() const {
    std::string list;
    for (std::size_t k = feet_.size(); k-- > 0;) {
        const double bottom = -height_of_foot * static_cast<double>(k + 1);
        list +=
            fmt::format("{0:g} '{2}', {1:g} '{2}', ", bottom, bottom + height_of_colour, feet_[k]);
    }
    // NOTE: the first colour begins below the range, as the least number is within rounding of it.
    if (!feet_.empty())
        list += fmt::format("{:g} '{}', ", height_of_colour - height_of_foot, colours_[0]);
    for (std::size_t k = 0; k < colours_.size(); ++k)
        list += fmt::format("{}{:g} '{}'", k == 0 ? "" : ", ",
                            static_cast<double>(k) / static_cast<double>(colours_.size() - 1),
                            colours_[k]);
    const double length = range_.to - range_.from,
                 tick = distance_of_ticks(length, most_ticks_of_colours);
    const double bottom = range_.from - height_of_foot * static_cast<double>(feet_.size()) * length;
    return fmt::format("set palette defined ({})\nset format cb '%g'\nset cbrange "
                       "[{:.17g}:{:.17g}]\nset cbtics {:.17g},{:.17g},{:.17g}\n",
                       list, bottom, range_.to, std::ceil(range_.from / tick) * tick, tick,
                       range_.to);
}

}  // namespace hvi::gen

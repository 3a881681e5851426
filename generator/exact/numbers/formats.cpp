// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/numbers/formats.hpp"

#include <algorithm>

namespace hvi::gen {
namespace {

bool is_in_range(const Dyadic& value, const Format& format) {
    return value.is_zero() || (value.leading() >= format.least && value.leading() <= format.most);
}

}  // namespace

Rounded nearest(const Number& value) {
    Rounded result;
    for (std::size_t f = 0; f < formats.size(); ++f) {
        const Dyadic rounded = value.nearest_of(formats[f].bits);
        if (is_in_range(rounded, formats[f])) { result[f] = rounded; }
    }
    return result;
}

Rounded nearest_or_small(const Number& value) {
    Rounded result = nearest(value);
    for (std::size_t f = 0; f < formats.size(); ++f) {
        const Dyadic rounded = value.nearest_of(formats[f].bits);
        const bool small = rounded.is_zero() || rounded.leading() < formats[f].least;
        if (small) { result[f] = value.nearest_multiple(formats[f].least - formats[f].bits + 1); }
    }
    return result;
}

bool is_power_of_two(const Number& value) {
    if (value.has_parameters()) { return false; }
    const Rounded in_formats = nearest(value);
    return std::all_of(in_formats.begin(), in_formats.end(), [&](const auto& rounded) {
        return rounded && rounded->bits() == 1 && rounded == in_formats.front();
    });
}

}  // namespace hvi::gen

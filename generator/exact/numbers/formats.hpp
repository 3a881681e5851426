// Formats of floating-point numbers, and the nearest numbers in each.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "generator/exact/numbers/dyadic.hpp"
#include "generator/exact/numbers/number.hpp"

namespace hvi::gen {

/// A format: the numbers with so many bits in the mantissa. NOTE: formats have no C++ names here,
/// as a C++ type has one of these formats on one machine and another on the next.
struct Format {
    int bits;
    int least, most;  ///< powers of two of the leading bit, for numbers with all bits
};

inline constexpr std::array<Format, 4> formats{{
    {24, -126, 127},
    {53, -1022, 1023},
    {64, -16382, 16383},
    {113, -16382, 16383},
}};

/// A number in each of the formats; empty where the format has no such number.
using Rounded = std::array<std::optional<Dyadic>, formats.size()>;
using RoundedMatrix = std::vector<std::vector<Rounded>>;

/// Returns the nearest number of each format, half to even. Empty beyond its range.
[[nodiscard]] Rounded nearest(const Number& value);

/// Returns the nearest numbers, also among numbers that are too small for all bits: for
/// coefficients that need not be good to their last bit.
[[nodiscard]] Rounded nearest_or_small(const Number& value);

/// Returns whether a product with it is exact in every format.
[[nodiscard]] bool is_power_of_two(const Number& value);

}  // namespace hvi::gen

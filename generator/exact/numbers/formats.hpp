// The formats of floating-point numbers, and the nearest numbers of each.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "generator/exact/numbers/dyadic.hpp"
#include "generator/exact/numbers/number.hpp"

namespace hvi::gen {

/// The numbers with so many bits in the mantissa. NOTE: a format has no name here, as a C++ type is
/// one of these on one machine and another one on the next.
struct Format {
    int bits;
    int least, most;  ///< powers of two of the leading bit, of numbers with all bits
};

inline constexpr std::array<Format, 4> formats{{
    {24, -126, 127},
    {53, -1022, 1023},
    {64, -16382, 16383},
    {113, -16382, 16383},
}};

/// One number in each of the formats; empty where the format has no such number.
using Rounded = std::array<std::optional<Dyadic>, formats.size()>;
using RoundedMatrix = std::vector<std::vector<Rounded>>;

/// The nearest number of each format, half to even. Empty beyond its range.
[[nodiscard]] Rounded nearest(const Number& value);

/// The same, with numbers that are too small for all bits where that is nearest: for coefficients
/// that need not be good to their last bit.
[[nodiscard]] Rounded nearest_or_small(const Number& value);

/// Whether a product with it is exact in every format.
[[nodiscard]] bool is_power_of_two(const Number& value);

}  // namespace hvi::gen

// Coefficients in the formats of floating-point numbers, symplectic in each.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "generator/exact/numbers/dyadic.hpp"
#include "generator/ir/step.hpp"

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

/// m and mt with m[i][j] + mt[j][i] == 1 without rounding, in each format.
struct RoundedCoefficients {
    RoundedMatrix m;
    RoundedMatrix mt;
};

/// Rounds each m_ij, for each format by itself, to a multiple of ulp(max(|m_ij|, |1 - m_ij|)) and
/// takes mt_ji = 1 - m_ij, which then is of that format. Where A == A~ only the entries with i > j
/// are rounded, m_ji = 1 - m_ij, and the diagonal is 1/2. Empty where 1 is no multiple of that ulp,
/// and where m_ij depends on a parameter.
[[nodiscard]] RoundedCoefficients rounded(const Step& step);

/// c and n with n[i][j] - n[j][i] == c[i] - c[j] without rounding, in each format.
struct RoundedVelocityForm {
    std::vector<Rounded> c;
    RoundedMatrix n;
};

/// Rounds c and the n_ij with i >= j to multiples of one power of two, the least with which these,
/// 1 - c_i and n_ji = n_ij - (c_i - c_j) are numbers of the format. A zero stays one.
[[nodiscard]] RoundedVelocityForm rounded(const VelocityForm& form);

}  // namespace hvi::gen

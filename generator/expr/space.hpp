// Spaces of coordinates.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace hvi::gen {

/// The space of an element of a family.
struct Space {
    std::string_view name;
    std::size_t point = 1;    ///< numbers of a point
    std::size_t tangent = 1;  ///< numbers of a tangent, and degrees of freedom

    friend bool operator==(const Space&, const Space&) = default;
};
inline constexpr Space real_line{"number", 1, 1};
/// Rotations: a matrix row by row, and its turns about the axes of the body.
inline constexpr Space rotations_of_space{"rotation", 9, 3};
inline constexpr Space angular_momenta{"angular momentum", 3, 3};

}  // namespace hvi::gen

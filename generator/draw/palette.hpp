// Colours of numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace hvi::gen {

/// Numbers between two ends. Both are finite, and `from` is below `to`.
struct NumberRange {
    double from = 0, to = 1;
};

/// Returns the range of the finite numbers: where all are equal a range around them, and from 0 to
/// 1 where there is none.
[[nodiscard]] NumberRange range_of(const std::vector<double>& numbers);

/// Returns a range for colours: that of the finite numbers, or, where a few of them would leave the
/// others one colour, that of all but the lowest and the highest hundredth.
[[nodiscard]] NumberRange colour_range_of(const std::vector<double>& numbers);

// From dark to light, for all eyes: five colours of matplotlib's viridis.
inline constexpr const char* viridis[]{"#440154", "#3b528b", "#21918c", "#5ec962", "#fde725"};

/// Sets a palette of these colours, evenly spaced.
[[nodiscard]] std::string gnuplot_palette(std::span<const char* const> colours);

/// Colours of numbers in a range, and below them some of single colours, for what is no number: the
/// feet of the scale.
class FootedPalette {
public:
    FootedPalette(std::span<const char* const> colours, std::vector<const char*> feet,
                  NumberRange range)
        : colours_(colours.begin(), colours.end()), feet_(std::move(feet)), range_(range) {}

    /// Returns a number that is shown in the colour of a foot.
    [[nodiscard]] double foot(std::size_t number) const;

    [[nodiscard]] std::string commands() const;

private:
    std::vector<const char*> colours_, feet_;
    NumberRange range_;
};

}  // namespace hvi::gen

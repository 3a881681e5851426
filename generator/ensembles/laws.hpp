// Values at random: `--random NAME=LAW`.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "generator/read/scene_times.hpp"

namespace hvi::gen {

/// The normal distribution; its deviation is the root of its variance.
struct Normal {
    double mean = 0, deviation = 1;
};

/// The uniform distribution between two numbers.
struct Uniform {
    double from = 0, to = 1;
};

/// The distribution of the values of a name.
struct Law {
    std::string name;
    std::variant<Normal, Uniform> kind;
    Place place;  ///< the place of the name
};

/// Reads `NAME=normal(MEAN, DEVIATION)` or `NAME=uniform(FROM, TO)`; the numbers may use parameters
/// of the scene. Throws InputError, with its place, where the text has another form, for a negative
/// deviation, and where FROM is above TO; and as nearest_value() does.
[[nodiscard]] Law law(const Given& text, const SceneTimes& scene);

/// Returns a number between 0 and 1, neither of them, from the upper 52 bits: an odd multiple of
/// 2^-53, each as likely as the others.
[[nodiscard]] double between_0_and_1(std::uint64_t bits);

/// Returns a number between 0 and 1, neither of them, which depends on these three alone. It comes
/// from Philox4x32-10 (Salmon et al.,
/// "Parallel random numbers: as easy as 1, 2, 3", 2011) with `seed` as key and (row, number) as
/// counter.
[[nodiscard]] double uniform_number(std::uint64_t seed, std::int64_t row, std::uint32_t number);

/// Returns the value below which a law puts this part of all values, between 0 and 1.
[[nodiscard]] double quantile(const Law& law, double part);

/// Returns the value of a row by a law. `number` tells the laws of a study apart. The value does
/// not depend on those of other rows.
[[nodiscard]] double sample(const Law& law, std::uint64_t seed, std::int64_t row,
                            std::uint32_t number);

}  // namespace hvi::gen

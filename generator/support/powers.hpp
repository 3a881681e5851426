// Numbers with a power of ten in a text, so that pages and pictures show the power.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace hvi::gen {

/// A number as programs print it: `6.8e-26`.
struct PowerOfTen {
    std::string factor;  ///< `6.8`; empty where it is 1
    int exponent = 0;
};

/// The text with each number that has an exponent replaced by what `shown` makes of it, and all
/// between them by what `plain` makes of that. A number that is a part of a word stays as it is.
[[nodiscard]] std::string with_powers(const std::string& text,
                                      const std::function<std::string(const std::string&)>& plain,
                                      const std::function<std::string(const PowerOfTen&)>& shown);

}  // namespace hvi::gen

// A point plus an increment: the motion of positions and momenta in a step. The space is flat here.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "generator/exact/numbers/number.hpp"

namespace hvi::gen {

/// A sum of products. A factor of 1 and a term of 0 leave no trace in the arithmetic.
class Increment {
public:
    /// Adds value * what, where `factor` is the value in C++.
    void add(const Number& value, std::string_view factor, std::string_view what);

    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string text_;
};

/// Returns a call of hvi::detail::moved(), small numbers first; `remainder` is what rounding has
/// cut off from the point so far. Precondition: the increment is not empty.
[[nodiscard]] std::string moved(std::string_view point, std::string_view remainder,
                                std::string_view increment);

/// Returns the call that adds an increment to component k of the point y, q or p, at the end of a
/// step and keeps what rounding cuts off; see hvi::detail::move().
[[nodiscard]] std::string move_to_end(std::string_view y, std::string_view increment);

}  // namespace hvi::gen

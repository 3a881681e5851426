// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/increments.hpp"

#include <fmt/format.h>

#include "generator/ir/equal.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

void Increment::add(const Number& value, std::string_view factor, std::string_view what) {
    if (equal(value, 0)) { return; }
    if (!text_.empty()) { text_ += " + "; }
    text_ += equal(value, 1) ? std::string(what) : fmt::format("{} * {}", factor, what);
}

std::string moved(std::string_view point, std::string_view remainder, std::string_view increment) {
    HVI_CHECK(!increment.empty());
    return fmt::format("hvi::detail::moved({}, {} + ({}))", point, remainder, increment);
}

std::string move_to_end(std::string_view y, std::string_view increment) {
    return fmt::format("s_.add(s_.at.{0}[k], s_.remainder.{0}[k], {1})", y, increment);
}

}  // namespace hvi::gen

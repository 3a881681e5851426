// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/numbers/number_text.hpp"

namespace hvi::gen {

std::string dump(const Number& number) {
    constexpr int digits = 50;
    const auto form = number.closed_form();
    return form ? to_text(*form) : "~" + number.decimal(digits);
}

}  // namespace hvi::gen

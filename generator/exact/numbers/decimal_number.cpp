// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/numbers/decimal_number.hpp"

namespace hvi::gen {

Number decimal_number(std::string_view text) {
    const bool is_negative = text.front() == '-';
    Number digits(0), unit(1);
    bool is_fraction = false;
    for (const char c : text.substr(is_negative ? 1 : 0)) {
        if (c == '.') {
            is_fraction = true;
            continue;
        }
        digits = digits * Number(10) + Number(c - '0');
        if (is_fraction) { unit = unit * Number(10); }
    }
    return (is_negative ? -digits : digits) / unit;
}

}  // namespace hvi::gen

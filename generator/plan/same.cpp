// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/same.hpp"

namespace hvi::gen {

bool same(const Number& a, const Number& b) {
    const Number difference = a - b;
    if (difference.closed_form()) { return difference.is_zero(); }
    // NOTE: 1 is added so that a zero has digits to compare.
    return (difference + Number(1)).decimal(40) == Number(1).decimal(40);
}

}  // namespace hvi::gen

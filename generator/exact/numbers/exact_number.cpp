// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/numbers/exact_number.hpp"

#include <cmath>

namespace hvi::gen {

Number exact_number(double value) {
    int exponent = 0;
    Number result(static_cast<long>(std::ldexp(std::frexp(value, &exponent), 53)));
    for (exponent -= 53; exponent < 0; ++exponent) { result = result / Number(2); }
    for (; exponent > 0; --exponent) { result = result * Number(2); }
    return result;
}

}  // namespace hvi::gen

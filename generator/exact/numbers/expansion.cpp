// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/numbers/expansion.hpp"

#include <cmath>

#include "generator/exact/numbers/number_value.hpp"

namespace hvi::gen {

std::array<double, 5> expansion(const Number& constant) {
    std::array<double, 5> parts{};
    Number rest = constant;
    for (double& part : parts) {
        part = rest.nearest_double();
        int exponent = 0;
        const auto mantissa = static_cast<long>(std::ldexp(std::frexp(part, &exponent), 53));
        const Rational scale = power(Rational(2), exponent - 53);
        rest = rest - number(Element(mantissa * scale), nullptr);
    }
    return parts;
}

}  // namespace hvi::gen

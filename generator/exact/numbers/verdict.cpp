// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/numbers/verdict.hpp"

#include "generator/exact/numbers/number_value.hpp"
#include "generator/exact/numbers/rational.hpp"

namespace hvi::gen {

std::optional<Verdict> vanishes(const Ball& ball) {
    constexpr slong exponent = -167;  // 2^-167 < 10^-50
    if (ball.sign() != 0) { return Verdict{false, true}; }
    if (mag_cmp_2exp_si(arb_radref(ball.get()), exponent) >= 0) { return std::nullopt; }
    return Verdict{true, false};
}

Verdict vanishes(const Number& number) {
    if (is_exact(number)) { return {number.is_zero(), true}; }
    return refine(number, "whether a number is zero",
                  [](const Ball& ball) { return vanishes(ball); });
}

Verdict can_vanish(const Number& number, Precision bits) {
    if (is_exact(number)) { return {number.is_zero(), true}; }
    const bool excluded = enclosure(number, bits).sign() != 0;
    return excluded ? Verdict{false, true} : Verdict{true, false};
}

}  // namespace hvi::gen

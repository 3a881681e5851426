// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/numbers/rounded.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "generator/exact/numbers/ground.hpp"
#include "generator/exact/numbers/number_value.hpp"
#include "generator/exact/numbers/rational.hpp"

namespace hvi::gen {

namespace {

/// Extends a ball to enclose [value - radius, value + radius] as well.
void include(Ball& ball, double value, double radius, Precision bits) {
    Ball other, end;
    arb_set_d(other.get(), value);
    arb_set_d(end.get(), radius);
    arb_add_error(other.get(), end.get());
    arb_union(ball.get(), ball.get(), other.get(), bits);
}

/// Returns an enclosure of radius 2^-bits, or the narrowest there is.
Ball accurate(const Number& value, Precision bits) {
    constexpr Precision spare = 128;
    Precision working = bits + spare;
    Ball result = enclosure(value, working);
    while (mag_cmp_2exp_si(arb_radref(result.get()), -bits) > 0 && 2 * working <= last_precision) {
        working *= 2;
        Ball next = enclosure(value, working);
        if (mag_cmp(arb_radref(next.get()), arb_radref(result.get())) >= 0) { break; }
        result = std::move(next);
    }
    return result;
}

/// Returns the least n with 10^n >= the largest absolute value in a ball; empty for zero.
std::optional<long> power_of_ten_above(const Ball& ball) {
    constexpr Precision bits = 64;
    Ball largest, logarithm, ten;
    arb_get_abs_ubound_arf(arb_midref(largest.get()), ball.get(), bits);
    if (arb_is_zero(largest.get()) != 0) { return std::nullopt; }
    arb_set_ui(ten.get(), 10);
    arb_log(logarithm.get(), largest.get(), bits);
    arb_log(ten.get(), ten.get(), bits);
    arb_div(logarithm.get(), logarithm.get(), ten.get(), bits);
    arf_t above;
    arf_init(above);
    arb_get_ubound_arf(above, logarithm.get(), bits);
    const long result = arf_get_si(above, ARF_RND_CEIL);
    arf_clear(above);
    return result;
}

}  // namespace

Number unrounded(const Number& written, const DecimalDigits& digits,
                 std::optional<double> spacing) {
    const Number unit = power(Number(10), static_cast<unsigned>(std::abs(digits.last_place)));
    const Number half = (digits.last_place < 0 ? Number(1) / unit : unit) / Number(2);
    const Precision bits = bits_for(digits.significant);
    Ball ball = enclosure(written - half, bits);
    arb_union(ball.get(), ball.get(), enclosure(written + half, bits).get(), bits);
    if (spacing) { include(ball, written.nearest_double(), *spacing / 2, bits); }
    return number(Real([ball](Precision) { return ball; }));
}

double spacing_at(double value) {
    const double size = std::abs(value);
    return std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
}

Precision bits_for(int digits) {
    constexpr Precision spare = 128;
    return 4 * Precision{digits} + spare;
}

bool overlap(const Number& left, const Number& right, Precision bits) {
    const Ball a = accurate(left, bits);
    const Ball b = accurate(right, bits);
    return arb_overlaps(a.get(), b.get()) != 0;
}

Verdict can_agree(const Number& left, const Number& right, Precision bits) {
    if (is_exact(left) && is_exact(right)) { return vanishes(left - right); }
    return overlap(left, right, bits) ? Verdict{true, false} : Verdict{false, true};
}

std::optional<long> common_places(const Number& left, const Number& right, Precision bits) {
    if (is_exact(left) && is_exact(right) && (left - right).is_zero()) { return std::nullopt; }
    Ball twice = accurate(left, bits);
    arb_sub(twice.get(), twice.get(), accurate(right, bits).get(), bits);
    arb_mul_2exp_si(twice.get(), twice.get(), 1);
    const auto above = power_of_ten_above(twice);
    return above ? std::optional(-*above) : std::nullopt;
}

}  // namespace hvi::gen

// Correctly rounded decimals and binary numbers: enclosures are refined until one answer is left.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>

#include "generator/exact/numbers/integers.hpp"
#include "generator/exact/numbers/number_value.hpp"

namespace hvi::gen {

namespace {

/// Limit of decimal exponents. Larger and smaller numbers are no coefficients, and their digits
/// would take long.
constexpr long most_decimal_exponent = 10000;

void nearest_integer(Integer& result, const arf_t value) {
    arf_get_fmpz(result.get(), value, ARF_RND_NEAR);  // ties to even
}

/// Returns the integer nearest to every number in the ball (half to even), if there is only one.
std::optional<Integer> only_nearest_integer(const Ball& ball) {
    arf_t lower, upper;
    arf_init(lower);
    arf_init(upper);
    arb_get_interval_arf(lower, upper, ball.get(), ARF_PREC_EXACT);
    std::optional<Integer> result;
    if (arf_is_finite(lower) && arf_is_finite(upper) && arf_cmpabs_2exp_si(lower, 1 << 20) < 0) {
        Integer low, high;
        nearest_integer(low, lower);
        nearest_integer(high, upper);
        if (fmpz_equal(low.get(), high.get())) result = low;
    }
    arf_clear(lower);
    arf_clear(upper);
    return result;
}

/// Returns value * base^exponent. NOTE: a rational stays exact, for it may lie half-way between two
/// answers. For other numbers the enclosure is enough, and a product of long sums is saved.
Number scaled(const Number& value, long base, long exponent) {
    const Number factor = number(Element(power(Rational(base), exponent)), nullptr);
    const Element* const element = value.value().element();
    if (element != nullptr && element->is_rational()) { return value * factor; }
    return number(Real([value](Precision bits) { return enclosure(value, bits); })) * factor;
}

Integer nearest_integer(const Number& value) {
    return refine(value, "how to round a number", only_nearest_integer);
}

/// Converts an integer. Precondition: it has no more bits than a Dyadic.
WideInteger wide(const Integer& value) {
    HVI_CHECK(fmpz_bits(value.get()) <= Dyadic::most_bits);
    Integer rest, digit;
    fmpz_abs(rest.get(), value.get());
    WideInteger result = 0;
    for (int position = 0; fmpz_sgn(rest.get()) != 0; position += 32) {
        fmpz_fdiv_r_2exp(digit.get(), rest.get(), 32);
        fmpz_fdiv_q_2exp(rest.get(), rest.get(), 32);
        result += WideInteger(fmpz_get_ui(digit.get())) << position;
    }
    return fmpz_sgn(value.get()) < 0 ? -result : result;
}

/// Returns a number not greater than log10 of the ball's middle, and not more than two less.
long decimal_exponent(const Ball& ball) {
    fmpz_t exponent;
    fmpz_init(exponent);
    arf_t magnitude;
    arf_init(magnitude);
    arf_set_round(magnitude, arb_midref(ball.get()), 30, ARF_RND_DOWN);
    arf_abs(magnitude, magnitude);
    arf_abs_bound_lt_2exp_fmpz(exponent, magnitude);
    const double bits = fmpz_get_d(exponent) - 2;  // the midpoint may be a power of 2 above
    arf_clear(magnitude);
    fmpz_clear(exponent);
    return static_cast<long>(std::floor(bits * std::log10(2.0)));
}

/// Returns the first enclosure that excludes zero, or the last there is: those of an integral end
/// early.
Ball apart_from_zero(const Number& value) {
    Ball ball = enclosure(value, first_precision);
    for (Precision bits = 2 * first_precision; ball.sign() == 0 && bits <= last_precision;
         bits *= 2) {
        try {
            ball = enclosure(value, bits);
        } catch (const MathError&) { break; }
    }
    return ball;
}

/// Returns whether all of the ball is 0 to so many decimal places.
bool is_zero_to(const Ball& ball, int places) {
    Ball scale, twice;
    arb_set_ui(scale.get(), 10);
    arb_pow_ui(scale.get(), scale.get(), static_cast<ulong>(places), first_precision);
    arb_mul(twice.get(), ball.get(), scale.get(), first_precision);
    arb_mul_2exp_si(twice.get(), twice.get(), 1);
    arb_sub_ui(scale.get(), twice.get(), 1, first_precision);
    arb_add_ui(twice.get(), twice.get(), 1, first_precision);
    return scale.sign() < 0 && twice.sign() > 0;
}

/// Returns d.ddd from digits and the exponent of the first one.
std::string place_point(const std::string& digits, long exponent) {
    const auto count = static_cast<long>(digits.size());
    if (exponent < -6 || exponent >= std::max(count, 21L)) {
        const std::string tail = count > 1 ? "." + digits.substr(1) : "";
        return digits.substr(0, 1) + tail + "e" + std::to_string(exponent);
    }
    if (exponent < 0)
        return "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
    std::string whole = digits.substr(0, static_cast<std::size_t>(std::min(count, exponent + 1)));
    whole.append(static_cast<std::size_t>(exponent + 1) - whole.size(), '0');
    return exponent + 1 < count
               ? whole + "." + digits.substr(static_cast<std::size_t>(exponent + 1))
               : whole;
}

}  // namespace

std::string Number::decimal(int digits) const {
    HVI_CHECK(digits >= 1 && !has_parameters());
    if (is_exactly(*this, 0)) return "0";
    const Ball apart = apart_from_zero(*this);
    if (apart.sign() == 0 && is_zero_to(apart, digits)) return "0e-" + std::to_string(digits);
    if (apart.sign() == 0) throw MathError("cannot decide whether a number is zero");
    const long first_exponent = decimal_exponent(apart);
    if (std::abs(first_exponent) > most_decimal_exponent) {
        throw MathError("a number of about 10^" + std::to_string(first_exponent) +
                        " is beyond what can be written out");
    }
    // begins with an exponent that may be too small, and goes up until the digits are not too many
    for (long exponent = first_exponent;; ++exponent) {
        const Integer scaled_value = nearest_integer(scaled(*this, 10, digits - 1 - exponent));
        std::string text = scaled_value.text();
        const bool negative = text.front() == '-';
        if (negative) text.erase(0, 1);
        if (static_cast<int>(text.size()) > digits) continue;
        HVI_CHECK(static_cast<int>(text.size()) == digits);
        return (negative ? "-" : "") + place_point(text, exponent);
    }
}

double Number::nearest_double() const {
    HVI_CHECK(!has_parameters());
    const Element* const element = value().element();
    if (element != nullptr && element->is_zero()) return 0.0;
    return refine(*this, "how to round a number", [](const Ball& ball) -> std::optional<double> {
        arf_t lower, upper;
        arf_init(lower);
        arf_init(upper);
        arb_get_interval_arf(lower, upper, ball.get(), ARF_PREC_EXACT);
        const double low = arf_get_d(lower, ARF_RND_NEAR);
        const double high = arf_get_d(upper, ARF_RND_NEAR);
        arf_clear(lower);
        arf_clear(upper);
        if (low != high) { return std::nullopt; }
        // NOTE: 0 is nearest to all of a narrow ball around zero, whether the number is zero or
        // not, and then it has no sign.
        return ball.sign() == 0 ? 0.0 : low;
    });
}

Dyadic Number::nearest_of(int bits) const {
    HVI_CHECK(!has_parameters());
    const Element* const element = value().element();
    if (element != nullptr && element->is_zero()) return {};
    return refine(*this, "how to round a number", [&](const Ball& ball) -> std::optional<Dyadic> {
        arf_t lower, upper;
        arf_init(lower);
        arf_init(upper);
        arb_get_interval_arf(lower, upper, ball.get(), ARF_PREC_EXACT);
        arf_set_round(lower, lower, bits, ARF_RND_NEAR);
        arf_set_round(upper, upper, bits, ARF_RND_NEAR);
        std::optional<Dyadic> result;
        if (arf_is_normal(lower) && arf_equal(lower, upper)) {
            Integer mantissa, exponent;
            arf_get_fmpz_2exp(mantissa.get(), exponent.get(), lower);
            if (fmpz_bits(exponent.get()) >= 30)
                throw MathError("a number is beyond the range of every binary format");
            result = Dyadic(wide(mantissa), static_cast<int>(fmpz_get_si(exponent.get())));
        }
        arf_clear(lower);
        arf_clear(upper);
        return result;
    });
}

Dyadic Number::nearest_multiple(int exponent) const {
    HVI_CHECK(!has_parameters());
    return {wide(nearest_integer(scaled(*this, 2, -exponent))), exponent};
}

}  // namespace hvi::gen

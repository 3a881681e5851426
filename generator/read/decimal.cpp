// Decimal numbers as exact fractions.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/decimal.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "generator/read/token.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t most_digits = 1000;
constexpr long largest_exponent = 1000;

std::string_view without_sign(std::string_view text) {
    const bool has_sign = !text.empty() && (text.front() == '-' || text.front() == '+');
    return text.substr(has_sign ? 1 : 0);
}

bool only_digits(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), is_digit);
}

/// Returns the exponent after `e`; for one with too many digits, a number beyond the limit.
long exponent_value(std::string_view text) {
    const bool negative = !text.empty() && text.front() == '-';
    long value = 0;
    for (const char digit : without_sign(text))
        if (value <= largest_exponent) value = 10 * value + (digit - '0');
    return negative ? -value : value;
}

void strip_leading_zeros(std::string& digits) {
    digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
}

/// Divides by 2 or 5 when that leaves no remainder.
bool divide(std::string& digits, int divisor) {
    if ((digits.back() - '0') % divisor != 0) return false;
    int remainder = 0;
    for (char& digit : digits) {
        const int value = 10 * remainder + (digit - '0');
        digit = static_cast<char>('0' + value / divisor);
        remainder = value % divisor;
    }
    strip_leading_zeros(digits);
    return true;
}

/// Returns digits / 10^places in lowest terms: 10^places has no prime factors but 2 and 5.
Expression over_power_of_ten(std::string digits, std::size_t places) {
    if (digits == "0") return Expression::integer(0);
    std::string denominator = "1" + std::string(places, '0');
    for (const int prime : {2, 5})
        for (std::size_t k = 0; k < places && divide(digits, prime); ++k)
            divide(denominator, prime);
    return Expression::rational(std::move(digits), std::move(denominator));
}

}  // namespace

Expression read_decimal(const Place& place) {
    const std::string_view text =
        std::string_view(place.source->text)
            .substr(place.range.begin, place.range.end - place.range.begin);
    const std::string_view mantissa = text.substr(0, text.find_first_of("eE"));
    const long exponent =
        mantissa.size() == text.size() ? 0 : exponent_value(text.substr(mantissa.size() + 1));
    if (mantissa.size() > most_digits + 1)
        throw InputError("a number has more than 1000 digits", place);
    if (exponent > largest_exponent || exponent < -largest_exponent)
        throw InputError("an exponent is beyond 1000", place);

    const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
    std::string digits(mantissa.substr(0, point));
    std::size_t places = 0;
    if (point < mantissa.size()) {
        places = mantissa.size() - point - 1;
        digits += mantissa.substr(point + 1);
    }
    strip_leading_zeros(digits);
    const long scale = exponent - static_cast<long>(places);
    if (scale < 0) return over_power_of_ten(std::move(digits), static_cast<std::size_t>(-scale));
    if (digits != "0") digits.append(static_cast<std::size_t>(scale), '0');
    return Expression::rational(std::move(digits), "1");
}

std::optional<DecimalDigits> decimal_digits(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) { text.remove_prefix(1); }
    while (!text.empty() && is_blank(text.back())) { text.remove_suffix(1); }
    text = without_sign(text);
    const std::size_t e = std::min(text.find_first_of("eE"), text.size());
    const std::size_t point = std::min(text.find('.'), e);
    std::string digits(text.substr(0, e));
    if (point < e) { digits.erase(point, 1); }
    const std::string_view exponent = text.substr(std::min(e + 1, text.size()));
    const bool has_exponent = e < text.size();
    if (!only_digits(digits) || (has_exponent && !only_digits(without_sign(exponent))) ||
        (!has_exponent && point == e)) {
        return std::nullopt;
    }
    const std::size_t zeros = std::min(digits.find_first_not_of('0'), digits.size());
    const auto places = static_cast<long>(point < e ? e - point - 1 : 0);
    return DecimalDigits{static_cast<int>(digits.size() - zeros),
                         exponent_value(exponent) - places};
}

}  // namespace hvi::gen

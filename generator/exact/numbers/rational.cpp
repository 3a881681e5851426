// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/numbers/rational.hpp"

#include <numeric>

#include "generator/exact/numbers/number_value.hpp"

namespace hvi::gen {

namespace {

/// Returns the n-th root of `7` or `2/3` when both parts are n-th powers.
std::optional<Number> perfect_root(const std::string& fraction, long n, const Ground& ground) {
    const Rational value = Rational::read(fraction);
    Integer above, below;
    const bool exact = fmpz_root(above.get(), fmpq_numref(value.get()), n) != 0 &&
                       fmpz_root(below.get(), fmpq_denref(value.get()), n) != 0;
    return exact ? std::optional(ground.rational(above.text(), below.text())) : std::nullopt;
}

/// Returns the n-th root of a number > 0.
Number root(const Number& base, long n, const Ground& ground) {
    if (n == 2) return ground.sqrt(base);
    if (const auto exact = rational_root(base, n, ground)) return *exact;
    return number(Real([base, n](Precision bits) {
        Ball result = enclosure(base, bits);
        arb_root_ui(result.get(), result.get(), static_cast<ulong>(n), bits);
        return result;
    }));
}

}  // namespace

namespace {

long checked_product(long a, long b) {
    long result = 0;
    if (__builtin_mul_overflow(a, b, &result)) {
        throw InputError("an exponent is larger than any method needs");
    }
    return result;
}

long checked_sum(long a, long b) {
    long result = 0;
    if (__builtin_add_overflow(a, b, &result)) {
        throw InputError("an exponent is larger than any method needs");
    }
    return result;
}

}  // namespace

Ratio ratio(long above, long below) {
    HVI_CHECK(below > 0);
    const long divisor = std::gcd(above, below);
    return {above / divisor, below / divisor};
}

long Ratio::floor() const { return above >= 0 ? above / below : -((-above + below - 1) / below); }

Ratio operator+(const Ratio& left, const Ratio& right) {
    return ratio(checked_sum(checked_product(left.above, right.below),
                             checked_product(right.above, left.below)),
                 checked_product(left.below, right.below));
}

Ratio operator*(const Ratio& left, const Ratio& right) {
    return ratio(checked_product(left.above, right.above),
                 checked_product(left.below, right.below));
}

Ratio operator-(const Ratio& argument) { return {-argument.above, argument.below}; }

Number to_number(const Ratio& ratio) { return Number(ratio.above) / Number(ratio.below); }

bool is_exact(const Number& number) { return number.value().element() != nullptr; }

std::optional<std::string> rational_text(const Number& number) {
    const Element* const element = number.value().element();
    if (element == nullptr || !element->is_rational()) return std::nullopt;
    return element->rational().text();
}

std::optional<Ratio> small_ratio(const Number& number) {
    constexpr std::size_t most_digits = 9;
    const auto text = rational_text(number);
    if (!text) return std::nullopt;
    const std::size_t bar = text->find('/');
    const std::string above = text->substr(0, bar);
    const std::string below = bar == std::string::npos ? "1" : text->substr(bar + 1);
    const std::size_t sign = above.front() == '-' ? 1 : 0;
    if (above.size() > most_digits + sign || below.size() > most_digits) return std::nullopt;
    return Ratio{std::stol(above), std::stol(below)};
}

std::optional<Number> rational_root(const Number& number, long n, const Ground& ground) {
    const auto fraction = rational_text(number);
    const bool has_root = fraction && fraction->front() != '-';
    return has_root ? perfect_root(*fraction, n, ground) : std::nullopt;
}

Number power(const Number& base, const Ratio& exponent, const Ground& ground) {
    if (exponent.above == 0) return Number(1);
    if (exponent.above < 0) return Number(1) / power(base, -exponent, ground);
    const auto above = static_cast<unsigned>(exponent.above);
    if (exponent.is_integer()) return power(base, above);
    if (base.is_zero()) return Number(0);
    return power(root(base, exponent.below, ground), above);
}

}  // namespace hvi::gen

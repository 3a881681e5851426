// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/numbers/rational_value.hpp"

#include "generator/support/error.hpp"

namespace hvi::gen {

Rational Rational::read(const std::string& text) {
    Rational result;
    const bool read = fmpq_set_str(result.value_, text.c_str(), 10) == 0;
    HVI_CHECK(read);
    fmpq_canonicalise(result.value_);
    return result;
}

std::string Rational::text() const {
    char* const digits = fmpq_get_str(nullptr, 10, value_);
    std::string result(digits);
    flint_free(digits);
    return result;
}

Integer Rational::numerator() const {
    Integer result;
    fmpz_set(result.get(), fmpq_numref(value_));
    return result;
}

Integer Rational::denominator() const {
    Integer result;
    fmpz_set(result.get(), fmpq_denref(value_));
    return result;
}

long Rational::to_long() const {
    HVI_CHECK(is_integer());
    return numerator().to_long();
}

Rational& Rational::operator/=(const Rational& divisor) {
    HVI_CHECK(!divisor.is_zero());
    fmpq_div(value_, value_, divisor.value_);
    return *this;
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/algebra/polynomial_in_square.hpp"

#include "generator/exact/numbers/number_value.hpp"

namespace hvi::gen {

namespace {

NumberPolynomial part(const NumberPolynomial& polynomial, std::size_t parity) {
    NumberPolynomial result;
    for (std::size_t k = parity; k < polynomial.size(); k += 2) { result.push_back(polynomial[k]); }
    return result;
}

}  // namespace

NumberPolynomial even(const NumberPolynomial& polynomial) { return part(polynomial, 0); }
NumberPolynomial odd(const NumberPolynomial& polynomial) { return part(polynomial, 1); }

Ball between(const Number& low, const Number& high) {
    for (Precision bits = first_precision; bits <= last_precision; bits *= 2) {
        const Ball a = enclosure(low, bits);
        const Ball b = enclosure(high, bits);
        if (arb_lt(a.get(), b.get()) == 0) { continue; }
        Ball middle;
        arb_add(middle.get(), a.get(), b.get(), bits);
        arb_mul_2exp_si(middle.get(), middle.get(), -1);
        arb_get_mid_arb(middle.get(), middle.get());
        return middle;
    }
    throw MathError("cannot tell two ends of intervals of stability apart");
}

int sign_at(const NumberPolynomial& polynomial, const Ball& z) {
    for (Precision bits = first_precision; bits <= last_precision; bits *= 2) {
        Ball t;
        arb_sqr(t.get(), z.get(), bits);
        if (const int sign = enclosure(polynomial, t, bits).sign(); sign != 0) { return sign; }
    }
    throw MathError("cannot decide whether an interval is stable");
}

}  // namespace hvi::gen

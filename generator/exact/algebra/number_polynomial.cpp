// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/algebra/number_polynomial.hpp"

#include <algorithm>

#include "generator/exact/numbers/rational.hpp"

namespace hvi::gen {

void trim(NumberPolynomial& polynomial) {
    while (!polynomial.empty() && polynomial.back().is_zero()) polynomial.pop_back();
}

NumberPolynomial sum(const NumberPolynomial& a, const NumberPolynomial& b) {
    NumberPolynomial result = a.size() < b.size() ? b : a;
    const NumberPolynomial& shorter = a.size() < b.size() ? a : b;
    for (std::size_t i = 0; i < shorter.size(); ++i) result[i] = result[i] + shorter[i];
    trim(result);
    return result;
}

NumberPolynomial product(const NumberPolynomial& a, const NumberPolynomial& b) {
    if (a.empty() || b.empty()) return {};
    NumberPolynomial result(a.size() + b.size() - 1);
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) result[i + j] = result[i + j] + a[i] * b[j];
    }
    return result;
}

NumberPolynomial scaled(const NumberPolynomial& a, const Number& factor) {
    NumberPolynomial result;
    for (const Number& coefficient : a) result.push_back(coefficient * factor);
    trim(result);
    return result;
}

NumberPolynomial shifted(NumberPolynomial polynomial) {
    if (!polynomial.empty()) { polynomial.insert(polynomial.begin(), Number(0)); }
    return polynomial;
}

NumberPolynomial power_of(const NumberPolynomial& base, unsigned exponent) {
    NumberPolynomial result{Number(1)};
    for (; exponent > 0; --exponent) result = product(result, base);
    return result;
}

Number value_at(const NumberPolynomial& polynomial, const Number& point) {
    Number result;
    for (auto next = polynomial.rbegin(); next != polynomial.rend(); ++next) {
        result = result * point + *next;
    }
    return result;
}

Division divide(const NumberPolynomial& dividend, const NumberPolynomial& divisor) {
    HVI_CHECK(!divisor.empty());
    Division result{{}, dividend};
    NumberPolynomial& rest = result.remainder;
    if (rest.size() < divisor.size()) return result;
    result.quotient.resize(rest.size() - divisor.size() + 1);
    const Number inverse = Number(1) / divisor.back();
    for (std::size_t shift = result.quotient.size(); shift-- > 0;) {
        const Number factor = rest.back() * inverse;
        result.quotient[shift] = factor;
        rest.pop_back();
        for (std::size_t i = 0; i + 1 < divisor.size(); ++i) {
            rest[shift + i] = rest[shift + i] - factor * divisor[i];
        }
    }
    trim(rest);
    trim(result.quotient);
    return result;
}

NumberPolynomial gcd(NumberPolynomial a, NumberPolynomial b) {
    while (!b.empty()) {
        NumberPolynomial rest = divide(a, b).remainder;
        a = std::move(b);
        b = std::move(rest);
    }
    return a;
}

std::optional<Bezout> bezout(const NumberPolynomial& a, const NumberPolynomial& b) {
    // Euclid's algorithm with r = u a modulo b.
    NumberPolynomial previous = b;
    NumberPolynomial r = divide(a, b).remainder;
    NumberPolynomial previous_u;
    NumberPolynomial u{Number(1)};
    while (r.size() > 1) {
        const Division step = divide(previous, r);
        NumberPolynomial next_u = sum(previous_u, scaled(product(step.quotient, u), Number(-1)));
        previous = std::move(r);
        r = step.remainder;
        previous_u = std::move(u);
        u = std::move(next_u);
    }
    if (r.empty()) return std::nullopt;
    u = divide(scaled(u, Number(1) / r.front()), b).remainder;
    NumberPolynomial v = sum({Number(1)}, scaled(product(u, a), Number(-1)));
    return Bezout{std::move(u), divide(v, b).quotient};
}

std::optional<RationalPolynomial> over_rationals(const NumberPolynomial& polynomial) {
    RationalPolynomial result;
    for (std::size_t i = 0; i < polynomial.size(); ++i) {
        const auto text = rational_text(polynomial[i]);
        if (!text) return std::nullopt;
        result.set_coefficient(static_cast<long>(i), *text);
    }
    return result;
}

NumberPolynomial with_numbers(const RationalPolynomial& polynomial, const Ground& ground) {
    NumberPolynomial result;
    for (long i = 0; i <= polynomial.degree(); ++i) {
        const std::string text = polynomial.coefficient(i);
        const std::size_t bar = text.find('/');
        result.push_back(ground.rational(text.substr(0, bar),
                                         bar == std::string::npos ? "1" : text.substr(bar + 1)));
    }
    return result;
}

namespace {

/// Appends tau^2 + p tau + q, or its two linear factors if it has real roots.
void append_quadratic(std::vector<Factorization::Part>& parts, const NumberPolynomial& monic,
                      unsigned multiplicity, const Ground& ground) {
    const Number half = monic[1] / Number(2);
    const Number discriminant = half * half - monic[0];
    const int sign = discriminant.sign();
    if (sign < 0) {
        parts.push_back({monic, multiplicity});
    } else if (sign == 0) {
        parts.push_back({{half, Number(1)}, 2 * multiplicity});
    } else {
        const Number root = ground.sqrt(discriminant);
        parts.push_back({{half - root, Number(1)}, multiplicity});
        parts.push_back({{half + root, Number(1)}, multiplicity});
    }
}

}  // namespace

std::optional<Factorization> factorize(const NumberPolynomial& polynomial, const Ground& ground) {
    HVI_CHECK(!polynomial.empty());
    for (const Number& coefficient : polynomial) {
        if (!is_exact(coefficient) || coefficient.has_parameters()) return std::nullopt;
    }
    Factorization result{polynomial.back(), {}};
    const NumberPolynomial monic = scaled(polynomial, Number(1) / polynomial.back());
    if (monic.size() == 1) return result;
    if (monic.size() == 2) {
        result.parts.push_back({monic, 1});
        return result;
    }
    const auto rational = over_rationals(monic);
    if (rational) {
        for (const auto& [factor, multiplicity] : irreducible_factors(*rational)) {
            const NumberPolynomial part = with_numbers(factor, ground);
            if (part.size() == 3) {
                append_quadratic(result.parts, part, multiplicity, ground);
            } else {
                result.parts.push_back({part, multiplicity});
            }
        }
        return result;
    }
    if (monic.size() != 3) return std::nullopt;
    append_quadratic(result.parts, monic, 1, ground);
    return result;
}

}  // namespace hvi::gen

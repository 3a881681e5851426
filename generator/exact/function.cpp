// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/function.hpp"

namespace hvi::gen {

namespace {

using Wave = ExactTerm::Wave;

bool equal(const Number& left, const Number& right) { return (left - right).is_zero(); }

/// A complex number over the exact reals.
struct Complex {
    Number real, imaginary;
};

Complex operator*(const Complex& left, const Complex& right) {
    return {left.real * right.real - left.imaginary * right.imaginary,
            left.real * right.imaginary + left.imaginary * right.real};
}

Complex operator-(const Complex& left, const Complex& right) {
    return {left.real - right.real, left.imaginary - right.imaginary};
}

Complex reciprocal(const Complex& z) {
    const Number square = z.real * z.real + z.imaginary * z.imaginary;
    return {z.real / square, -z.imaginary / square};
}

/// exp(z t) for real t.
Complex complex_exponential(const Complex& z, const Number& t, const Ground& ground) {
    const Number size = z.real.is_zero() ? Number(1) : ground.exp(z.real * t);
    if (z.imaginary.is_zero()) return {size, Number(0)};
    const Number angle = z.imaginary * t;
    return {size * ground.cos(angle), size * ground.sin(angle)};
}

Number component(const Complex& value, Wave wave) {
    return wave == Wave::sin ? value.imaginary : value.real;
}

/// The integral of t^k exp(z t) over [0, end]: I_k = (end^k exp(z end) - k I_{k-1})/z for z != 0.
Complex moment(unsigned k, const Complex& z, const Number& end, const Ground& ground) {
    if (z.real.is_zero() && z.imaginary.is_zero()) {
        return {power(end, k + 1) / Number(static_cast<long>(k) + 1), Number(0)};
    }
    const Complex inverse = reciprocal(z);
    const Complex last = complex_exponential(z, end, ground);
    Complex result = (last - Complex{Number(1), Number(0)}) * inverse;
    for (unsigned j = 1; j <= k; ++j) {
        const Number scale = power(end, j);
        const Number count(static_cast<long>(j));
        result = (Complex{scale * last.real, scale * last.imaginary} -
                  Complex{count * result.real, count * result.imaginary}) *
                 inverse;
    }
    return result;
}

}  // namespace

bool same_shape(const ExactTerm& left, const ExactTerm& right) {
    return left.power == right.power && left.wave == right.wave && equal(left.rate, right.rate) &&
           equal(left.frequency, right.frequency);
}

ExactFunction::ExactFunction(const Number& constant) {
    add({constant, 0, Number(0), Wave::none, Number(0)});
}

ExactFunction ExactFunction::tau() {
    ExactFunction result;
    result.add({Number(1), 1, Number(0), Wave::none, Number(0)});
    return result;
}

ExactFunction ExactFunction::exponential(const Number& rate) {
    ExactFunction result;
    result.add({Number(1), 0, rate, Wave::none, Number(0)});
    return result;
}

ExactFunction ExactFunction::cosine(const Number& frequency) {
    ExactFunction result;
    result.add({Number(1), 0, Number(0), Wave::cos, frequency});
    return result;
}

ExactFunction ExactFunction::sine(const Number& frequency) {
    ExactFunction result;
    result.add({Number(1), 0, Number(0), Wave::sin, frequency});
    return result;
}

void ExactFunction::add(const ExactTerm& given) {
    ExactTerm term = given;
    if (term.wave != Wave::none && term.frequency.is_zero()) {
        if (term.wave == Wave::sin) return;
        term.wave = Wave::none;
    }
    if (term.wave != Wave::none && canonical_sign(term.frequency) < 0) {
        term.frequency = -term.frequency;
        if (term.wave == Wave::sin) term.coefficient = -term.coefficient;
    }
    for (auto known = terms_.begin(); known != terms_.end(); ++known) {
        if (!same_shape(*known, term)) continue;
        known->coefficient = known->coefficient + term.coefficient;
        if (known->coefficient.is_zero()) terms_.erase(known);
        return;
    }
    if (!term.coefficient.is_zero()) terms_.push_back(term);
}

ExactFunction operator+(const ExactFunction& left, const ExactFunction& right) {
    ExactFunction result = left;
    for (const ExactTerm& term : right.terms_) result.add(term);
    return result;
}

ExactFunction operator*(const ExactFunction& left, const ExactFunction& right) {
    ExactFunction result;
    for (const ExactTerm& a : left.terms_) {
        for (const ExactTerm& b : right.terms_) {
            ExactTerm term{a.coefficient * b.coefficient, a.power + b.power, a.rate + b.rate,
                           Wave::none, Number(0)};
            if (a.wave == Wave::none || b.wave == Wave::none) {
                term.wave = a.wave == Wave::none ? b.wave : a.wave;
                term.frequency = a.frequency + b.frequency;
                result.add(term);
                continue;
            }
            // cos x cos y, sin x sin y, sin x cos y: half of f(x - y) +- f(x + y)
            term.coefficient = term.coefficient / Number(2);
            const bool mixed = a.wave != b.wave;
            term.wave = mixed ? Wave::sin : Wave::cos;
            const Number x = mixed && a.wave == Wave::cos ? b.frequency : a.frequency;
            const Number y = mixed && a.wave == Wave::cos ? a.frequency : b.frequency;
            term.frequency = x - y;
            result.add(term);
            term.frequency = x + y;
            if (a.wave == Wave::sin && b.wave == Wave::sin) term.coefficient = -term.coefficient;
            result.add(term);
        }
    }
    return result;
}

bool ExactFunction::is_polynomial() const {
    for (const ExactTerm& term : terms_) {
        if (term.wave != Wave::none || !term.rate.is_zero()) return false;
    }
    return true;
}

std::optional<Number> ExactFunction::constant() const {
    if (terms_.empty()) return Number(0);
    const bool alone = terms_.size() == 1 && terms_.front().power == 0;
    return alone && is_polynomial() ? std::optional(terms_.front().coefficient) : std::nullopt;
}

Number ExactFunction::at(const Number& point, const Ground& ground) const {
    Number sum;
    for (const ExactTerm& term : terms_) {
        const Complex value = complex_exponential({term.rate, term.frequency}, point, ground);
        sum = sum + term.coefficient * power(point, term.power) * component(value, term.wave);
    }
    return sum;
}

Number ExactFunction::integral(const Number& end, const Ground& ground) const {
    Number sum;
    for (const ExactTerm& term : terms_) {
        const Complex value = moment(term.power, {term.rate, term.frequency}, end, ground);
        sum = sum + term.coefficient * component(value, term.wave);
    }
    return sum;
}

}  // namespace hvi::gen

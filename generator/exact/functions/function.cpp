// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/functions/function.hpp"

#include <algorithm>

#include "generator/exact/functions/closed_integral.hpp"
#include "generator/exact/functions/factor.hpp"
#include "generator/exact/functions/quadrature.hpp"
#include "generator/exact/functions/reflection.hpp"

namespace hvi::gen {

namespace {

using Wave = ExactTerm::Wave;

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

/// Returns exp(z t) for real t.
Complex complex_exponential(const Complex& z, const Number& t, const Ground& ground) {
    const Number size = z.real.is_zero() ? Number(1) : ground.exp(z.real * t);
    if (z.imaginary.is_zero()) return {size, Number(0)};
    const Number angle = z.imaginary * t;
    return {size * ground.cos(angle), size * ground.sin(angle)};
}

Number component(const Complex& value, Wave wave) {
    return wave == Wave::sin ? value.imaginary : value.real;
}

/// Returns the integral of t^k exp(z t) over [0, end]: I_k = (end^k exp(z end) - k I_{k-1})/z for z
/// != 0.
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

/// Returns the integral over [from, to] of a term without its step, where a formula is known.
std::optional<Number> closed_integral(const ExactTerm& term, const Number& from, const Number& to,
                                      const Ground& ground) {
    if (term.factor == nullptr) {
        const Complex z{term.rate, term.frequency};
        const Number upper = component(moment(term.power, z, to, ground), term.wave);
        if (!term.step) return term.coefficient * upper;
        return term.coefficient *
               (upper - component(moment(term.power, z, from, ground), term.wave));
    }
    if ((to - from).is_zero()) return Number(0);
    if (term.wave != Wave::none || !term.rate.is_zero()) return std::nullopt;
    const auto value = closed_integral(*term.factor, term.power, from, to, ground);
    return value ? std::optional(term.coefficient * *value) : std::nullopt;
}

/// Returns whether tau = point has reached the step.
bool reaches(const Number& point, const Number& step) {
    if (point.has_parameters()) {
        throw InputError("a piecewise function at a node with a free parameter is not built yet",
                         {}, "give the parameter a value with --param");
    }
    const Number distance = point - step;
    return distance.is_zero() || distance.sign() > 0;
}

/// Returns the later of two steps.
std::optional<Number> later(const std::optional<Number>& left, const std::optional<Number>& right) {
    if (!left || !right) return left ? left : right;
    return (*left - *right).sign() < 0 ? right : left;
}

/// Returns the product of two terms without their factors: one or two terms.
std::vector<ExactTerm> product_of_waves(const ExactTerm& a, const ExactTerm& b) {
    ExactTerm term{a.coefficient * b.coefficient, a.power + b.power, a.rate + b.rate};
    term.step = later(a.step, b.step);
    if (a.wave == Wave::none || b.wave == Wave::none) {
        term.wave = a.wave == Wave::none ? b.wave : a.wave;
        term.frequency = a.frequency + b.frequency;
        return {term};
    }
    // cos x cos y, sin x sin y, sin x cos y: half of f(x - y) +- f(x + y)
    term.coefficient = term.coefficient / Number(2);
    const bool mixed = a.wave != b.wave;
    term.wave = mixed ? Wave::sin : Wave::cos;
    const Number x = mixed && a.wave == Wave::cos ? b.frequency : a.frequency;
    const Number y = mixed && a.wave == Wave::cos ? a.frequency : b.frequency;
    ExactTerm other = term;
    term.frequency = x - y;
    other.frequency = x + y;
    if (a.wave == Wave::sin && b.wave == Wave::sin) other.coefficient = -other.coefficient;
    return {term, other};
}

bool same_step(const ExactTerm& left, const ExactTerm& right) {
    if (left.step.has_value() != right.step.has_value()) return false;
    return !left.step || are_equal(*left.step, *right.step);
}

bool same_factor(const ExactTerm& left, const ExactTerm& right) {
    if (left.factor == right.factor) return true;
    return left.factor != nullptr && right.factor != nullptr && same(*left.factor, *right.factor);
}

}  // namespace

bool ExactTerm::is_monomial() const {
    return wave == Wave::none && rate.is_zero() && !step && factor == nullptr;
}

bool same_shape(const ExactTerm& left, const ExactTerm& right) {
    return left.power == right.power && left.wave == right.wave &&
           are_equal(left.rate, right.rate) && are_equal(left.frequency, right.frequency) &&
           same_step(left, right) && same_factor(left, right);
}

bool known_same(const ExactFunction& left, const ExactFunction& right) {
    const auto& terms = right.terms();
    if (left.terms().size() != terms.size()) return false;
    return std::all_of(left.terms().begin(), left.terms().end(), [&](const ExactTerm& term) {
        return std::any_of(terms.begin(), terms.end(), [&](const ExactTerm& other) {
            return same_shape(term, other) &&
                   (term.coefficient - other.coefficient).known_zero() == true;
        });
    });
}

ExactFunction::ExactFunction(const Number& constant) { add({constant}); }

ExactFunction::ExactFunction(const std::vector<Number>& coefficients) {
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
        add({coefficients[k], static_cast<unsigned>(k)});
    }
}

ExactFunction::ExactFunction(const ExactTerm& term) { add(term); }

ExactFunction::ExactFunction(FactorPointer factor) {
    ExactTerm term{Number(1)};
    term.factor = std::move(factor);
    add(term);
}

ExactFunction ExactFunction::tau() {
    ExactFunction result;
    result.add({Number(1), 1});
    return result;
}

ExactFunction ExactFunction::exponential(const Number& rate) {
    ExactFunction result;
    result.add({Number(1), 0, rate});
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

ExactFunction ExactFunction::step(const Number& from) {
    ExactTerm term{Number(1)};
    term.step = from;
    ExactFunction result;
    result.add(term);
    return result;
}

void ExactFunction::add(const ExactTerm& term) {
    if (term.factor == nullptr) return add_normal(term);
    for (const ExactTerm& part : normal_terms(term)) add_normal(part);
}

void ExactFunction::add_normal(const ExactTerm& given) {
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
            const std::vector<ExactTerm> waves = product_of_waves(a, b);
            if (a.factor == nullptr || b.factor == nullptr) {
                for (ExactTerm wave : waves) {
                    wave.factor = a.factor == nullptr ? b.factor : a.factor;
                    result.add(wave);
                }
                continue;
            }
            const ExactFunction factors = product_of_factors(a.factor, b.factor);
            for (const ExactTerm& wave : waves) {
                for (const ExactTerm& factor : factors.terms_) {
                    ExactTerm term = product_of_waves(wave, factor).front();
                    term.factor = factor.factor;
                    result.add(term);
                }
            }
        }
    }
    return result;
}

bool ExactFunction::is_polynomial() const {
    return std::all_of(terms_.begin(), terms_.end(),
                       [](const ExactTerm& term) { return term.is_monomial(); });
}

bool ExactFunction::has_steps() const {
    return std::any_of(terms_.begin(), terms_.end(),
                       [](const ExactTerm& term) { return term.step.has_value(); });
}

bool ExactFunction::has_parameters() const {
    return std::any_of(terms_.begin(), terms_.end(), [](const ExactTerm& term) {
        return term.coefficient.has_parameters() || term.rate.has_parameters() ||
               term.frequency.has_parameters();
    });
}

std::optional<Number> ExactFunction::constant() const {
    if (terms_.empty()) return Number(0);
    const bool alone = terms_.size() == 1 && terms_.front().power == 0;
    return alone && is_polynomial() ? std::optional(terms_.front().coefficient) : std::nullopt;
}

std::vector<Number> ExactFunction::coefficients() const {
    std::vector<Number> result;
    for (const ExactTerm& term : terms_) {
        HVI_CHECK(term.is_monomial());
        if (result.size() <= term.power) result.resize(term.power + 1);
        result[term.power] = term.coefficient;
    }
    return result;
}

ExactFunction ExactFunction::piece_at(const Number& point) const {
    ExactFunction result;
    for (ExactTerm term : terms_) {
        if (term.step && !reaches(point, *term.step)) continue;
        term.step.reset();
        result.add(term);
    }
    return result;
}

Number ExactFunction::at(const Number& point, const Ground& ground) const {
    Number sum;
    for (const ExactTerm& term : terms_) {
        if (term.step && !reaches(point, *term.step)) continue;
        const Complex wave = complex_exponential({term.rate, term.frequency}, point, ground);
        Number next = term.coefficient * power(point, term.power) * component(wave, term.wave);
        if (term.factor != nullptr) { next = next * value(*term.factor, point, ground); }
        sum = sum + next;
    }
    return sum;
}

Number ExactFunction::integral(const Number& end, const Ground& ground) const {
    const bool has_factors = std::any_of(
        terms_.begin(), terms_.end(), [](const ExactTerm& term) { return term.factor != nullptr; });
    if (has_factors && is_odd_about_middle(*this, end, ground)) return Number(0);
    Number sum;
    ExactFunction open;  // terms without a formula, which are integrated together
    for (const ExactTerm& term : terms_) {
        if (term.step && !reaches(end, *term.step)) continue;
        const Number from = term.step.value_or(Number(0));
        if (const auto closed = closed_integral(term, from, end, ground)) {
            sum = sum + *closed;
        } else if (term.step || wants_substitution(term)) {
            ExactTerm smooth = term;
            smooth.step.reset();
            sum = sum + quadrature(ExactFunction(smooth), from, end, ground);
        } else {
            open.add_normal(term);
        }
    }
    return open.terms_.empty() ? sum : sum + quadrature(open, Number(0), end, ground);
}

}  // namespace hvi::gen

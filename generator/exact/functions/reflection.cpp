// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/functions/reflection.hpp"

#include "generator/exact/functions/ball_function.hpp"
#include "generator/exact/numbers/number_value.hpp"

namespace hvi::gen {

namespace {

using Wave = ExactTerm::Wave;

/// Reflection tau -> end - tau.
class Mirror {
public:
    Mirror(const Number& end, const Ground& ground)
        : end_(end), ground_(ground), line_(NumberPolynomial{end, Number(-1)}) {}

    [[nodiscard]] ExactFunction image(const ExactFunction& function) const {
        ExactFunction result;
        for (const ExactTerm& term : function.terms()) result = result + image(term);
        return result;
    }

private:
    [[nodiscard]] ExactFunction image(const ExactTerm& term) const {
        ExactFunction result{term.coefficient * ground_.exp(term.rate * end_)};
        result = result * ExactFunction::exponential(-term.rate) *
                 power_of(line_, {static_cast<long>(term.power), 1}) * wave(term);
        if (term.factor == nullptr) return result;
        return result *
               std::visit([&](const auto& kind) { return image(kind); }, term.factor->what);
    }

    [[nodiscard]] ExactFunction wave(const ExactTerm& term) const {
        if (term.wave == Wave::none) return ExactFunction(Number(1));
        const ExactFunction cos(ground_.cos(term.frequency * end_));
        const ExactFunction sin(ground_.sin(term.frequency * end_));
        const ExactFunction cosine = ExactFunction::cosine(term.frequency);
        const ExactFunction sine = ExactFunction::sine(term.frequency);
        if (term.wave == Wave::cos) return cos * cosine + sin * sine;
        return sin * cosine + ExactFunction(Number(-1)) * cos * sine;
    }

    [[nodiscard]] ExactFunction image(const LinearPower& factor) const {
        LinearPower result = factor;
        result.offset = value_at(factor.line(), end_);
        result.sign = -factor.sign;
        return ExactFunction(make_factor(result));
    }

    [[nodiscard]] ExactFunction image(const Pole& factor) const {
        NumberPolynomial polynomial = image(ExactFunction(factor.polynomial)).coefficients();
        const Number leading = polynomial.back();
        polynomial = scaled(polynomial, leading);  // it is 1 or -1
        return ExactFunction(power(leading, factor.order)) *
               ExactFunction(make_factor(Pole{std::move(polynomial), factor.order}));
    }

    [[nodiscard]] ExactFunction image(const Power& factor) const {
        return power_of(image(factor.base), factor.exponent);
    }

    [[nodiscard]] ExactFunction image(const Call& factor) const {
        return call_of(factor.name, image(factor.argument));
    }

    [[nodiscard]] ExactFunction image(const Product& product) const {
        ExactFunction result{Number(1)};
        for (const FactorPointer& factor : product.factors) {
            result =
                result * std::visit([&](const auto& kind) { return image(kind); }, factor->what);
        }
        return result;
    }

    const Number& end_;
    const Ground& ground_;
    ExactFunction line_;
};

/// Returns whether values at two points that mirror each other show that a function is not odd: for
/// most functions that is enough.
bool is_seen_not_odd(const ExactFunction& function, const Number& end) {
    const BallFunction values = compile(function, first_precision);
    const Number point = end / Number(7);
    Ball sum = real_values(values, enclosure(point, first_precision));
    const Ball other = real_values(values, enclosure(end - point, first_precision));
    arb_add(sum.get(), sum.get(), other.get(), first_precision);
    return sum.sign() != 0;
}

}  // namespace

bool is_odd_about_middle(const ExactFunction& function, const Number& end, const Ground& ground) {
    if (!rational_text(end) || function.has_steps() || function.has_parameters()) return false;
    if (is_seen_not_odd(function, end)) return false;
    const ExactFunction sum = function + Mirror(end, ground).image(function);
    for (const ExactTerm& term : sum.terms()) {
        if (term.coefficient.known_zero() != true) return false;
    }
    return true;
}

}  // namespace hvi::gen

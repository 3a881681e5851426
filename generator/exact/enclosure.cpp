// Proven bounds for field elements.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/field.hpp"
#include "generator/exact/integers.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

/// A polynomial in the transcendental generators.
Ball evaluate(const std::vector<RationalFunction::Term>& terms, const Field* field,
              Precision bits) {
    Ball sum;
    for (const RationalFunction::Term& term : terms) {
        Ball product = ball_of_rational(digits(term.coefficient), bits);
        for (std::size_t i = 0; i < term.powers.size(); ++i) {
            if (term.powers[i] == 0) continue;
            const Transcendental& generator = field->transcendentals().at(i);
            HVI_CHECK(!generator.is_parameter);
            Ball power = generator.value(bits);
            arb_pow_ui(power.get(), power.get(), term.powers[i], bits);
            arb_mul(product.get(), product.get(), power.get(), bits);
        }
        arb_add(sum.get(), sum.get(), product.get(), bits);
    }
    return sum;
}

Ball evaluate(const RationalFunction& function, const Field* field, Precision bits) {
    Ball result = evaluate(function.numerator(), field, bits);
    const Ball denominator = evaluate(function.denominator(), field, bits);
    arb_div(result.get(), result.get(), denominator.get(), bits);
    return result;
}

}  // namespace

Ball enclosure(const Element& argument, Precision bits) {
    Ball sum;
    for (const auto& [monomial, coefficient] : argument.terms()) {
        Ball term = evaluate(coefficient, argument.field(), bits);
        for (std::size_t i = 0; i < monomial.size(); ++i) {
            if (monomial[i] == 0) continue;
            Ball generator = argument.field()->algebraic(i).value(bits);
            arb_pow_ui(generator.get(), generator.get(), monomial[i], bits);
            arb_mul(term.get(), term.get(), generator.get(), bits);
        }
        arb_add(sum.get(), sum.get(), term.get(), bits);
    }
    return sum;
}

std::optional<int> sign(const Element& argument) {
    if (argument.is_zero()) return 0;
    for (Precision bits = first_precision; bits <= last_precision; bits *= 2) {
        if (const int found = enclosure(argument, bits).sign(); found != 0) return found;
    }
    return std::nullopt;
}

}  // namespace hvi::gen

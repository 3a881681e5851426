// Proven bounds for field elements.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <map>
#include <utility>

#include "generator/exact/numbers/field.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

/// Values of the generators to some precision, and powers of them: each is computed once.
class Powers {
public:
    Powers(const Field* field, Precision bits) : field_(field), bits_(bits) {}

    void multiply_by_transcendental(Ball& product, std::size_t index, unsigned exponent) {
        const Transcendental& generator = field_->transcendentals().at(index);
        HVI_CHECK(!generator.is_parameter);
        multiply(product, transcendentals_[{index, exponent}], generator.value, exponent);
    }
    void multiply_by_algebraic(Ball& product, std::size_t index, unsigned exponent) {
        multiply(product, algebraics_[{index, exponent}], field_->algebraic(index).value, exponent);
    }

private:
    using Table = std::map<std::pair<std::size_t, unsigned>, std::optional<Ball>>;

    void multiply(Ball& product, std::optional<Ball>& power,
                  const std::function<Ball(Precision)>& value, unsigned exponent) const {
        if (!power) {
            power = value(bits_);
            arb_pow_ui(power->get(), power->get(), exponent, bits_);
        }
        arb_mul(product.get(), product.get(), power->get(), bits_);
    }

    const Field* field_;
    Precision bits_;
    Table transcendentals_, algebraics_;
};

/// Returns the value of a polynomial in the transcendental generators.
Ball evaluate(const IntegerMultivariate& polynomial, Powers& powers, Precision bits) {
    Ball sum;
    for (const IntegerMultivariate::Term& term : polynomial.terms()) {
        Ball product;
        arb_set_round_fmpz(product.get(), term.coefficient.get(), bits);
        for (std::size_t i = 0; i < term.powers.size(); ++i) {
            if (term.powers[i] == 0) continue;
            powers.multiply_by_transcendental(product, i, term.powers[i]);
        }
        arb_add(sum.get(), sum.get(), product.get(), bits);
    }
    return sum;
}

}  // namespace

Ball enclosure(const Element& argument, Precision bits) {
    Powers powers(argument.field(), bits);
    Ball sum;
    for (const auto& [monomial, coefficient] : argument.numerator()) {
        Ball term = evaluate(coefficient, powers, bits);
        for (std::size_t i = 0; i < monomial.size(); ++i) {
            if (monomial[i] == 0) continue;
            powers.multiply_by_algebraic(term, i, monomial[i]);
        }
        arb_add(sum.get(), sum.get(), term.get(), bits);
    }
    const Ball denominator = evaluate(argument.denominator(), powers, bits);
    arb_div(sum.get(), sum.get(), denominator.get(), bits);
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

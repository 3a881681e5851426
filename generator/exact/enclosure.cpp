// Proven bounds for field elements.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/field.hpp"
#include "generator/exact/integers.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

using GiNaC::ex;

/// A rational function of the transcendental generators, by recursion over GiNaC's tree. The order
/// of its terms may change the radius, never the truth of the bound.
Ball evaluate(const ex& function, const Field* field, Precision bits) {
    Ball result;
    if (GiNaC::is_a<GiNaC::numeric>(function)) {
        return ball_of_rational(digits(GiNaC::ex_to<GiNaC::numeric>(function)), bits);
    }
    if (GiNaC::is_a<GiNaC::add>(function)) {
        for (std::size_t i = 0; i < function.nops(); ++i) {
            const Ball term = evaluate(function.op(i), field, bits);
            arb_add(result.get(), result.get(), term.get(), bits);
        }
        return result;
    }
    if (GiNaC::is_a<GiNaC::mul>(function)) {
        arb_one(result.get());
        for (std::size_t i = 0; i < function.nops(); ++i) {
            const Ball factor = evaluate(function.op(i), field, bits);
            arb_mul(result.get(), result.get(), factor.get(), bits);
        }
        return result;
    }
    if (GiNaC::is_a<GiNaC::power>(function)) {
        result = evaluate(function.op(0), field, bits);
        const int exponent = GiNaC::ex_to<GiNaC::numeric>(function.op(1)).to_int();
        if (exponent < 0) arb_inv(result.get(), result.get(), bits);
        arb_pow_ui(result.get(), result.get(), static_cast<ulong>(std::abs(exponent)), bits);
        return result;
    }
    for (const Transcendental& generator : field->transcendentals()) {
        if (generator.symbol.is_equal(GiNaC::ex_to<GiNaC::basic>(function))) {
            HVI_CHECK(!generator.is_parameter);
            return generator.value(bits);
        }
    }
    HVI_CHECK(false && "a coefficient is a rational function of the generators");
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

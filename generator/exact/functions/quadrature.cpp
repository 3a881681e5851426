// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/functions/quadrature.hpp"

#include <acb_calc.h>

#include "generator/exact/functions/ball_function.hpp"
#include "generator/exact/numbers/number_value.hpp"
#include "generator/support/process.hpp"
#include "generator/support/progress.hpp"
#include "generator/support/work.hpp"

namespace hvi::gen {

namespace {

/// Limit of precision, more than 1200 digits. A decision that needs more, such as whether two
/// integrals are equal, cannot be made in this way, and each doubling takes several times longer.
constexpr Precision most_bits = 4096;

/// Limit of evaluations of a quadrature: a smooth integrand takes some ten for each bit, a root at
/// an end bits^2/2, and one with a pole on the way any number.
constexpr slong most_evaluations(Precision bits) { return bits * bits + 10000; }

/// Evaluates the integrand. NOTE: it is called from C, through which nothing is thrown: after an
/// interruption it returns values that cost nothing.
int evaluate(acb_ptr result, const acb_t point, void* function, slong order, slong /*bits*/) {
    if (is_interrupted()) {
        acb_indeterminate(result);
        return 0;
    }
    Jet tau;
    acb_set(tau.value.get(), point);
    const Jet jet = (*static_cast<BallFunction*>(function))(tau, order != 0);
    acb_set(result, jet.value.get());
    return 0;
}

Ball enclose(BallFunction function, const Ball& from, const Ball& to, Precision bits) {
    const Progress::Stage stage("enclosing an integral that has no closed form");
    const ComplexBall lower(from);
    const ComplexBall upper(to);
    mag_t tolerance;
    mag_init(tolerance);
    mag_set_ui_2exp_si(tolerance, 1, -bits);
    acb_calc_integrate_opt_t options;
    acb_calc_integrate_opt_init(options);
    options->eval_limit = most_evaluations(bits);
    ComplexBall integral;
    acb_calc_integrate(integral.get(), evaluate, &function, lower.get(), upper.get(), bits,
                       tolerance, options, bits);
    mag_clear(tolerance);
    spend_work();
    Ball result;
    arb_set(result.get(), acb_realref(integral.get()));
    return result;
}

/// Returns whether at least half of the wanted bits are known: all but some for round-off, when the
/// quadrature converges.
bool is_sharp(const Ball& ball, Precision bits) {
    mag_t bound;
    mag_init(bound);
    arb_get_mag(bound, ball.get());
    if (mag_cmp_2exp_si(bound, 0) < 0) mag_one(bound);
    mag_mul_2exp_si(bound, bound, -bits / 2);
    const bool sharp = arb_is_finite(ball.get()) && mag_cmp(arb_radref(ball.get()), bound) < 0;
    mag_clear(bound);
    return sharp;
}

/// An integrand as a function of v between two limits.
struct Integral {
    std::function<BallFunction(Precision)> integrand;
    Number from, to;
};

/// Substitutes v = L^(1/n) in an integrand with L^(p/n), p > -n, that may begin or end at the zero
/// of the line L = offset + sign tau. It is analytic there in v: tau = sign (v^n - offset), L^(p/n)
/// dtau = sign n v^(p + n - 1) dv.
Integral substituted(const ExactTerm& term, const LinearPower& factor, const Number& from,
                     const Number& to, const Ground& ground) {
    const long n = factor.exponent.below;
    ExactTerm rest = term;
    rest.factor = nullptr;
    const auto limit = [&](const Number& tau) {
        return power(value_at(factor.line(), tau), Ratio{1, n}, ground);
    };
    const auto integrand = [rest, factor, n](Precision bits) -> BallFunction {
        return [function = compile(rest, bits), offset = enclosure(factor.offset, bits), factor, n,
                bits](const Jet& v, bool analytic) {
            Jet tau;
            acb_pow_si(tau.value.get(), v.value.get(), n, bits);
            acb_sub_arb(tau.value.get(), tau.value.get(), offset.get(), bits);
            acb_mul_si(tau.value.get(), tau.value.get(), factor.sign, bits);
            Jet result = function(tau, analytic);
            ComplexBall weight;
            acb_pow_si(weight.get(), v.value.get(), factor.exponent.above + n - 1, bits);
            acb_mul_si(weight.get(), weight.get(), n * factor.sign, bits);
            acb_mul(result.value.get(), result.value.get(), weight.get(), bits);
            return result;
        };
    };
    return {integrand, limit(from), limit(to)};
}

}  // namespace

bool wants_substitution(const ExactTerm& term) {
    if (term.factor == nullptr) return false;
    const auto* linear = std::get_if<LinearPower>(&term.factor->what);
    return linear != nullptr && linear->logs == 0 && !linear->exponent.is_integer() &&
           linear->exponent.floor() >= -1;
}

Number quadrature(const ExactFunction& function, const Number& from, const Number& to,
                  const Ground& ground) {
    if (from.has_parameters() || to.has_parameters() || function.has_parameters()) {
        throw InputError("an integral of this kind with a free parameter is not built yet", {},
                         "give the parameter a value with --param");
    }
    const ExactTerm& first = function.terms().front();
    const bool substitute = function.terms().size() == 1 && wants_substitution(first);
    const Integral integral =
        substitute
            ? substituted(first, std::get<LinearPower>(first.factor->what), from, to, ground)
            : Integral{[function](Precision bits) { return compile(function, bits); }, from, to};
    const Real real([integral](Precision bits) {
        if (bits > most_bits) {
            throw MathError("cannot decide whether a number is zero, or how to round it, with 1200 "
                            "digits of an integral that has no closed form");
        }
        const Precision working = bits + 32;
        const Ball result = enclose(integral.integrand(working), enclosure(integral.from, working),
                                    enclosure(integral.to, working), working);
        if (!is_sharp(result, bits)) {
            throw MathError("cannot enclose the integral of this function");
        }
        return result;
    });
    static_cast<void>(real.enclosure(first_precision));  // refused here, where its place is known
    return number(real);
}

}  // namespace hvi::gen

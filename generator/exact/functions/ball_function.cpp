// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/functions/ball_function.hpp"

#include <map>

#include "generator/exact/numbers/arb_functions.hpp"
#include "generator/exact/numbers/number_value.hpp"
#include "generator/expr/functions.hpp"
#include "generator/read/parse.hpp"

namespace hvi::gen {

namespace {

using Wave = ExactTerm::Wave;

Jet jet_of(const Ball& constant) { return {ComplexBall(constant), {}, false}; }

void multiply(Jet& left, const Jet& right, Precision bits) {
    if (left.has_slope || right.has_slope) {
        ComplexBall other;
        acb_mul(other.get(), left.value.get(), right.slope.get(), bits);
        acb_mul(left.slope.get(), left.slope.get(), right.value.get(), bits);
        acb_add(left.slope.get(), left.slope.get(), other.get(), bits);
        left.has_slope = true;
    }
    acb_mul(left.value.get(), left.value.get(), right.value.get(), bits);
}

void add(Jet& left, const Jet& right, Precision bits) {
    acb_add(left.value.get(), left.value.get(), right.value.get(), bits);
    acb_add(left.slope.get(), left.slope.get(), right.slope.get(), bits);
    left.has_slope = left.has_slope || right.has_slope;
}

void scale(Jet& jet, const Ball& factor, Precision bits) {
    acb_mul_arb(jet.value.get(), jet.value.get(), factor.get(), bits);
    acb_mul_arb(jet.slope.get(), jet.slope.get(), factor.get(), bits);
}

/// Returns f(inner) with f' = derivative.
Jet chain(ComplexBall value, ComplexBall derivative, const Jet& inner, Precision bits) {
    Jet result{std::move(value), std::move(derivative), inner.has_slope};
    acb_mul(result.slope.get(), result.slope.get(), inner.slope.get(), bits);
    return result;
}

Jet integer_power(const Jet& base, long exponent, Precision bits) {
    ComplexBall value;
    ComplexBall derivative;
    acb_pow_si(value.get(), base.value.get(), exponent, bits);
    if (base.has_slope && exponent != 0) {
        acb_pow_si(derivative.get(), base.value.get(), exponent - 1, bits);
        acb_mul_si(derivative.get(), derivative.get(), exponent, bits);
    }
    return chain(std::move(value), std::move(derivative), base, bits);
}

/// Encloses z^exponent by |z|^exponent where the branch point 0 is in the ball, exponent > 0.
void power_around_zero(acb_t result, const acb_t z, const Ratio& exponent, Precision bits) {
    arb_t size;
    arb_init(size);
    acb_get_abs_ubound_arf(arb_midref(size), z, bits);
    mag_zero(arb_radref(size));
    arb_root_ui(size, size, static_cast<ulong>(exponent.below), bits);
    arb_pow_ui(size, size, static_cast<ulong>(exponent.above), bits);
    arb_add_error(acb_realref(result), size);
    if (!acb_is_real(z)) arb_add_error(acb_imagref(result), size);
    arb_clear(size);
}

/// Returns whether a ball touches the cut (-oo, 0] of roots and logarithms.
bool touches_cut(const acb_t z) {
    return arb_contains_zero(acb_imagref(z)) && !arb_is_positive(acb_realref(z));
}

Jet fractional_power(const Jet& base, const Ratio& exponent, bool analytic, Precision bits) {
    const acb_srcptr z = base.value.get();
    ComplexBall value;
    ComplexBall derivative;
    if (analytic && touches_cut(z)) {
        acb_indeterminate(value.get());
        return {value, value, base.has_slope};
    }
    if (exponent.above > 0 && acb_contains_zero(z)) {
        power_around_zero(value.get(), z, exponent, bits);
    } else {
        if (exponent.below == 2) {
            acb_sqrt(value.get(), z, bits);
        } else {
            acb_root_ui(value.get(), z, static_cast<ulong>(exponent.below), bits);
        }
        acb_pow_si(value.get(), value.get(), exponent.above, bits);
    }
    if (base.has_slope) {
        acb_div(derivative.get(), value.get(), z, bits);
        acb_mul_si(derivative.get(), derivative.get(), exponent.above, bits);
        acb_div_si(derivative.get(), derivative.get(), exponent.below, bits);
    }
    return chain(std::move(value), std::move(derivative), base, bits);
}

Jet power(const Jet& base, const Ratio& exponent, bool analytic, Precision bits) {
    return exponent.is_integer() ? integer_power(base, exponent.above, bits)
                                 : fractional_power(base, exponent, analytic, bits);
}

bool touches_reals_up_to_one(const acb_t z) {
    ComplexBall left;
    acb_sub_ui(left.get(), z, 1, MAG_BITS);
    return touches_cut(left.get());
}

bool on_real_cuts(const acb_t z) {
    if (!arb_contains_zero(acb_imagref(z))) return false;
    arb_t one;
    arb_init(one);
    arb_one(one);
    arb_t size;
    arb_init(size);
    arb_abs(size, acb_realref(z));
    const bool inside = arb_lt(size, one) != 0;
    arb_clear(one);
    arb_clear(size);
    return !inside;
}

bool on_imaginary_cuts(const acb_t z) {
    ComplexBall turned;
    acb_mul_onei(turned.get(), z);
    return on_real_cuts(turned.get());
}

bool touches(Cuts cuts, const acb_t z) {
    switch (cuts) {
    case Cuts::nowhere: return false;
    case Cuts::not_positive: return touches_cut(z);
    case Cuts::real_up_to_one: return touches_reals_up_to_one(z);
    case Cuts::real_beyond_one: return on_real_cuts(z);
    case Cuts::imaginary_beyond_one: return on_imaginary_cuts(z);
    }
    HVI_CHECK(false);
    return true;
}

/// A function of expr/functions.def.
struct Elementary {
    void (*value)(acb_t, const acb_t, slong);
    Cuts cuts;
    Expression derivative;  ///< as a function of x and of the value y
};

const std::map<std::string_view, Elementary>& elementary_functions() {
    static const std::map<std::string_view, Elementary> table{
#define HVI_FUNCTION(name, latex, domain, cuts, parity, runtime, derivative)                       \
    {#name, {acb_##name, Cuts::cuts, parse_expression(given("functions.def", derivative))}},
#include "generator/expr/functions.def"
    };
    return table;
}

/// Value of a derivative of the table.
class DerivativeValue {
public:
    DerivativeValue(const ComplexBall& x, const ComplexBall& y, Precision bits)
        : x_(x), y_(y), bits_(bits) {}

    [[nodiscard]] ComplexBall operator()(const Expression& expression) const {
        using Kind = Expression::Kind;
        const std::vector<Expression>& arguments = expression.arguments;
        ComplexBall result;
        switch (expression.kind) {
        case Kind::number:
            arb_set(
                acb_realref(result.get()),
                ball_of_rational(expression.numerator + "/" + expression.denominator, bits_).get());
            break;
        case Kind::symbol: return symbol(expression.name);
        case Kind::sum:
            for (const Expression& term : arguments) {
                acb_add(result.get(), result.get(), (*this)(term).get(), bits_);
            }
            break;
        case Kind::product:
            acb_one(result.get());
            for (const Expression& factor : arguments) {
                acb_mul(result.get(), result.get(), (*this)(factor).get(), bits_);
            }
            break;
        case Kind::negation: acb_neg(result.get(), (*this)(arguments[0]).get()); break;
        case Kind::reciprocal: acb_inv(result.get(), (*this)(arguments[0]).get(), bits_); break;
        case Kind::power:
            acb_pow(result.get(), (*this)(arguments[0]).get(), (*this)(arguments[1]).get(), bits_);
            break;
        case Kind::call:
            elementary_functions()
                .at(expression.name)
                .value(result.get(), (*this)(arguments[0]).get(), bits_);
            break;
        case Kind::element:
        case Kind::sum_over: HVI_CHECK(false && "indices are unrolled");
        }
        return result;
    }

private:
    [[nodiscard]] ComplexBall symbol(const std::string& name) const {
        if (name != "pi") { return name == "x" ? x_ : y_; }
        ComplexBall pi;
        acb_const_pi(pi.get(), bits_);
        return pi;
    }

    const ComplexBall& x_;
    const ComplexBall& y_;
    Precision bits_;
};

Jet called(const Elementary& function, const Jet& argument, Precision bits) {
    ComplexBall value;
    ComplexBall derivative;
    function.value(value.get(), argument.value.get(), bits);
    if (argument.has_slope) {
        derivative = DerivativeValue(argument.value, value, bits)(function.derivative);
    }
    return chain(std::move(value), std::move(derivative), argument, bits);
}

BallFunction compile_kind(const LinearPower& factor, Precision bits) {
    return [offset = enclosure(factor.offset, bits), factor, bits](const Jet& tau, bool analytic) {
        Jet line = tau;
        if (factor.sign < 0) {
            acb_neg(line.value.get(), line.value.get());
            acb_neg(line.slope.get(), line.slope.get());
        }
        acb_add_arb(line.value.get(), line.value.get(), offset.get(), bits);
        Jet result = power(line, factor.exponent, analytic, bits);
        if (factor.logs == 0) return result;
        ComplexBall value;
        ComplexBall derivative;
        acb_log_analytic(value.get(), line.value.get(), analytic ? 1 : 0, bits);
        acb_inv(derivative.get(), line.value.get(), bits);
        const Jet logarithm = chain(std::move(value), std::move(derivative), line, bits);
        multiply(result, integer_power(logarithm, factor.logs, bits), bits);
        return result;
    };
}

BallFunction compile_kind(const Pole& factor, Precision bits) {
    return [function = compile(ExactFunction(factor.polynomial), bits),
            order = static_cast<long>(factor.order), bits](const Jet& tau, bool analytic) {
        return integer_power(function(tau, analytic), -order, bits);
    };
}

BallFunction compile_kind(const Power& factor, Precision bits) {
    return [base = compile(factor.base, bits), exponent = factor.exponent, bits](const Jet& tau,
                                                                                 bool analytic) {
        return power(base(tau, analytic), exponent, analytic, bits);
    };
}

BallFunction compile_kind(const Call& factor, Precision bits) {
    const Elementary& function = elementary_functions().at(factor.name);
    return
        [inner = compile(factor.argument, bits), &function, bits](const Jet& tau, bool analytic) {
            const Jet argument = inner(tau, analytic);
            if (analytic && touches(function.cuts, argument.value.get())) {
                ComplexBall unknown;
                acb_indeterminate(unknown.get());
                return Jet{unknown, unknown, argument.has_slope};
            }
            return called(function, argument, bits);
        };
}

BallFunction compile_kind(const Product& product, Precision bits) {
    std::vector<BallFunction> factors;
    for (const FactorPointer& factor : product.factors) factors.push_back(compile(*factor, bits));
    return [factors = std::move(factors), bits](const Jet& tau, bool analytic) {
        Jet result = factors.front()(tau, analytic);
        for (std::size_t i = 1; i < factors.size(); ++i) {
            multiply(result, factors[i](tau, analytic), bits);
        }
        return result;
    };
}

/// Returns f(slope tau) for one of the functions of the table.
BallFunction of_multiple(const char* name, const Number& slope, Precision bits) {
    const Elementary& function = elementary_functions().at(name);
    return [slope = enclosure(slope, bits), &function, bits](const Jet& tau, bool /*analytic*/) {
        Jet argument = tau;
        scale(argument, slope, bits);
        return called(function, argument, bits);
    };
}

}  // namespace

BallFunction compile(const Factor& factor, Precision bits) {
    return std::visit([&](const auto& kind) { return compile_kind(kind, bits); }, factor.what);
}

BallFunction compile(const ExactTerm& term, Precision bits) {
    HVI_CHECK(!term.step);
    std::vector<BallFunction> factors;
    if (!term.rate.is_zero()) factors.push_back(of_multiple("exp", term.rate, bits));
    if (term.wave != Wave::none) {
        factors.push_back(
            of_multiple(term.wave == Wave::cos ? "cos" : "sin", term.frequency, bits));
    }
    if (term.factor != nullptr) factors.push_back(compile(*term.factor, bits));
    return [coefficient = enclosure(term.coefficient, bits), power = term.power,
            factors = std::move(factors), bits](const Jet& tau, bool analytic) {
        Jet result = power == 0 ? jet_of(coefficient) : integer_power(tau, power, bits);
        if (power != 0) scale(result, coefficient, bits);
        for (const BallFunction& factor : factors) multiply(result, factor(tau, analytic), bits);
        result.has_slope = tau.has_slope;
        return result;
    };
}

BallFunction compile(const ExactFunction& function, Precision bits) {
    std::vector<BallFunction> terms;
    for (const ExactTerm& term : function.terms()) terms.push_back(compile(term, bits));
    return [terms = std::move(terms), bits](const Jet& tau, bool analytic) {
        Jet result;
        for (const BallFunction& term : terms) add(result, term(tau, analytic), bits);
        result.has_slope = tau.has_slope;
        return result;
    };
}

Ball real_values(const BallFunction& function, const Ball& tau) {
    const Jet jet = function({ComplexBall(tau), {}, false}, false);
    Ball result;
    arb_set(result.get(), acb_realref(jet.value.get()));
    return result;
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/functions/value_at.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>

#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

using Kind = Expression::Kind;
constexpr Precision bits = 256;

bool is_zero(const Ball& x) { return arb_is_zero(x.get()) != 0; }

Ball integer(long value) {
    Ball result;
    arb_set_si(result.get(), value);
    return result;
}

/// Where a function has no real value, what is said then, and how it is computed.
struct RealFunction {
    std::string_view name;
    std::function<bool(const Ball&)> has_no_value;
    std::string_view fault;
    std::function<void(arb_ptr, arb_srcptr)> compute;
};

template <void function(arb_t, const arb_t, slong)>
void compute(arb_ptr result, arb_srcptr x) {
    function(result, x, bits);
}

bool nowhere(const Ball&) { return false; }

bool is_beyond_one(const Ball& x) {
    Ball size;
    arb_abs(size.get(), x.get());
    return arb_gt(size.get(), integer(1).get()) != 0;
}

const std::array<RealFunction, 12>& real_functions() {
    constexpr std::string_view no_angle = "an arcsine or arccosine of a number beyond 1";
    static const std::array<RealFunction, 12> table{{
        {"sqrt", [](const Ball& x) { return x.sign() < 0; }, "the square root of a negative number",
         compute<arb_sqrt>},
        {"log", [](const Ball& x) { return x.sign() < 0 || is_zero(x); },
         "the logarithm of a number that is not positive", compute<arb_log>},
        {"asin", is_beyond_one, no_angle, compute<arb_asin>},
        {"acos", is_beyond_one, no_angle, compute<arb_acos>},
        {"exp", nowhere, "", compute<arb_exp>},
        {"sin", nowhere, "", compute<arb_sin>},
        {"cos", nowhere, "", compute<arb_cos>},
        {"tan", nowhere, "", compute<arb_tan>},
        {"atan", nowhere, "", compute<arb_atan>},
        {"sinh", nowhere, "", compute<arb_sinh>},
        {"cosh", nowhere, "", compute<arb_cosh>},
        {"tanh", nowhere, "", compute<arb_tanh>},
    }};
    return table;
}

class Evaluation {
public:
    Evaluation(const SymbolValues& symbols, const std::shared_ptr<const Source>& source)
        : symbols_(symbols), source_(source) {}

    [[nodiscard]] Ball operator()(const Expression& expression) const {
        switch (expression.kind) {
        case Kind::number:
            return ball_of_rational(expression.numerator + "/" + expression.denominator, bits);
        case Kind::symbol: return symbol(expression.name);
        case Kind::sum: return fold(expression, arb_add, 0);
        case Kind::product: return fold(expression, arb_mul, 1);
        case Kind::negation: {
            Ball result;
            arb_neg(result.get(), (*this)(expression.arguments.front()).get());
            return result;
        }
        case Kind::reciprocal: return reciprocal(expression);
        case Kind::power: return power(expression);
        case Kind::call: break;
        }
        return call(expression);
    }

private:
    [[noreturn]] void refuse(const Expression& at, std::string_view fault) const {
        if (source_ == nullptr) { throw MathError(std::string(fault)); }
        throw MathError(std::string(fault), Place{source_, at.range});
    }

    [[nodiscard]] Ball symbol(const std::string& name) const {
        Ball result;
        if (name == "pi") {
            arb_const_pi(result.get(), bits);
            return result;
        }
        if (name == "e") {
            arb_const_e(result.get(), bits);
            return result;
        }
        return symbols_.at(name);
    }

    template <class Operation>
    [[nodiscard]] Ball fold(const Expression& expression, Operation operation, long start) const {
        Ball result = integer(start);
        for (const Expression& argument : expression.arguments) {
            operation(result.get(), result.get(), (*this)(argument).get(), bits);
        }
        return result;
    }

    [[nodiscard]] Ball reciprocal(const Expression& expression) const {
        const Ball below = (*this)(expression.arguments.front());
        if (is_zero(below)) { refuse(expression.arguments.front(), "a division by zero"); }
        Ball result;
        arb_inv(result.get(), below.get(), bits);
        return result;
    }

    [[nodiscard]] Ball power(const Expression& expression) const {
        const Ball base = (*this)(expression.arguments.front());
        const Ball exponent = (*this)(expression.arguments.back());
        const bool is_integer = arb_is_int(exponent.get()) != 0;
        if (is_zero(base) && exponent.sign() < 0) { refuse(expression, "a division by zero"); }
        if (base.sign() < 0 && arb_is_exact(exponent.get()) != 0 && !is_integer) {
            refuse(expression, "a fractional power of a negative number");
        }
        Ball result;
        arb_pow(result.get(), base.get(), exponent.get(), bits);
        return result;
    }

    [[nodiscard]] Ball call(const Expression& expression) const {
        const auto& functions = real_functions();
        const auto found =
            std::find_if(functions.begin(), functions.end(), [&](const RealFunction& function) {
                return function.name == expression.name;
            });
        HVI_CHECK(found != functions.end());
        const Ball argument = (*this)(expression.arguments.front());
        if (found->has_no_value(argument)) { refuse(expression, found->fault); }
        Ball result;
        found->compute(result.get(), argument.get());
        return result;
    }

    const SymbolValues& symbols_;
    const std::shared_ptr<const Source>& source_;
};

}  // namespace

Ball value_at(const Expression& expression, const SymbolValues& symbols,
              const std::shared_ptr<const Source>& source) {
    return Evaluation(symbols, source)(expression);
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/scene/value_at.hpp"

#include <string_view>

#include "generator/exact/numbers/arb_functions.hpp"
#include "generator/expr/functions.hpp"
#include "generator/expr/own_functions.hpp"
#include "generator/support/error.hpp"
#include "generator/support/work.hpp"

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

using RealFunction = void (*)(arb_t, const arb_t, slong);

RealFunction real_function(std::string_view name) {
    static const std::map<std::string_view, RealFunction> table{
#define HVI_FUNCTION(name, ...) {#name, arb_##name},
#include "generator/expr/functions.def"
        {"abs", [](arb_t y, const arb_t x, slong) { arb_abs(y, x); }},
        {"sign", [](arb_t y, const arb_t x, slong) { arb_sgn(y, x); }},
    };
    return table.at(name);
}

Ball less_one(const Ball& x) {
    Ball result;
    arb_sub_ui(result.get(), x.get(), 1, bits);
    return result;
}

Ball size(const Ball& x) {
    Ball result;
    arb_abs(result.get(), x.get());
    return result;
}

/// Returns what is provably wrong with an argument; or nothing.
std::string_view fault(RealDomain domain, const Ball& x) {
    switch (domain) {
    case RealDomain::everywhere: break;
    case RealDomain::not_negative:
        if (x.sign() < 0) { return "the square root of a negative number"; }
        break;
    case RealDomain::positive:
        if (x.sign() < 0 || is_zero(x)) { return "the logarithm of a number that is not positive"; }
        break;
    case RealDomain::up_to_one:
        if (less_one(size(x)).sign() > 0) { return "an arcsine or arccosine of a number beyond 1"; }
        break;
    case RealDomain::within_one: {
        const Ball excess = less_one(size(x));
        if (excess.sign() > 0 || is_zero(excess)) { return "an artanh of a number beyond -1 or 1"; }
        break;
    }
    case RealDomain::from_one:
        if (less_one(x).sign() < 0) { return "an arcosh of a number below 1"; }
        break;
    }
    return {};
}

class Evaluation {
public:
    Evaluation(const SymbolValues& symbols, const std::shared_ptr<const Source>& source)
        : symbols_(symbols), source_(source) {}

    [[nodiscard]] Ball operator()(const Expression& expression) const {
        spend_work();
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
        case Kind::call: return call(expression);
        case Kind::element:
        case Kind::sum_over: break;
        }
        HVI_CHECK(false && "indices are unrolled");
        return {};
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
        if (is_if(expression.name)) { return choice(expression); }
        if (is_own_function(expression.name)) { return of_user(expression); }
        const Function* const function = find_function(expression.name);
        const Ball argument = (*this)(expression.arguments.front());
        if (function->arguments == 2) {
            return of_two(expression, argument, (*this)(expression.arguments.back()));
        }
        const std::string_view wrong = fault(function->domain, argument);
        if (!wrong.empty()) { refuse(expression, wrong); }
        Ball result;
        real_function(function->name)(result.get(), argument.get(), bits);
        return result;
    }

    /// Returns any number: nothing is known of the function but its arguments.
    [[nodiscard]] Ball of_user(const Expression& expression) const {
        for (const Expression& argument : expression.arguments) { (void)(*this)(argument); }
        Ball result;
        arb_zero_pm_inf(result.get());
        return result;
    }

    [[nodiscard]] Ball of_two(const Expression& expression, const Ball& a, const Ball& b) const {
        static const std::map<std::string_view, void (*)(arb_t, const arb_t, const arb_t, slong)>
            table{{"atan2", arb_atan2}, {"min", arb_min}, {"max", arb_max}};
        if (expression.name == "atan2" && is_zero(a) && is_zero(b)) {
            refuse(expression, "the angle of the origin");
        }
        Ball result;
        table.at(expression.name)(result.get(), a.get(), b.get(), bits);
        return result;
    }

    /// Encloses both values where the comparison is not decided, and the chosen one where it is.
    [[nodiscard]] Ball choice(const Expression& expression) const {
        const auto argument = [&](std::size_t k) { return (*this)(expression.arguments.at(k)); };
        const Ball a = argument(0), b = argument(1);
        const bool is_strict = expression.name == "if<";
        const bool holds = (is_strict ? arb_lt : arb_le)(a.get(), b.get()) != 0;
        const bool fails = (is_strict ? arb_ge : arb_gt)(a.get(), b.get()) != 0;
        if (holds) { return argument(2); }
        if (fails) { return argument(3); }
        Ball result;
        arb_union(result.get(), argument(2).get(), argument(3).get(), bits);
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

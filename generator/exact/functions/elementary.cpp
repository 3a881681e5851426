// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/functions/elementary.hpp"

#include <cmath>

#include "generator/exact/functions/division_by_zero.hpp"
#include "generator/exact/numbers/arb_functions.hpp"
#include "generator/exact/numbers/number_value.hpp"
#include "generator/exact/numbers/rational.hpp"

namespace hvi::gen {

namespace {

using ArbFunction = void (*)(arb_t, const arb_t, slong);

/// Largest q of angles pi*p/q that are looked for: the field writes those with square roots.
constexpr long most_parts_of_pi = 24;

Number enclosed(const Number& argument, ArbFunction function) {
    return number(Real([argument, function](Precision bits) {
        Ball result = enclosure(argument, bits);
        function(result.get(), result.get(), bits);
        return result;
    }));
}

/// Returns the only integer p for which angle = pi p/q is possible; empty where there is none.
std::optional<long> possible_part(const Ball& angle, long q) {
    Ball pi;
    arb_const_pi(pi.get(), first_precision);
    Ball turns;
    arb_div(turns.get(), angle.get(), pi.get(), first_precision);
    arb_mul_si(turns.get(), turns.get(), q, first_precision);
    const double nearest = std::round(arf_get_d(arb_midref(turns.get()), ARF_RND_NEAR));
    if (!(std::abs(nearest) <= static_cast<double>(q))) return std::nullopt;
    const long p = static_cast<long>(nearest);
    return arb_contains_si(turns.get(), p) != 0 ? std::optional(p) : std::nullopt;
}

void refuse_parameters(const Number& argument, const char* name) {
    if (!argument.has_parameters()) { return; }
    throw InputError(std::string(name) + " of an expression with a free parameter is not built yet",
                     {}, "give the parameter a value with --param");
}

/// Returns the inverse of a circular function at an exact number: the pi p/q for which
/// `difference`, a function of cosine and sine of the angle, is 0.
template <class Difference>
Number inverse_circular(const Number& argument, const Ground& ground, const char* name,
                        ArbFunction function, Difference difference) {
    refuse_parameters(argument, name);
    const Number result = enclosed(argument, function);
    if (!is_exact(argument)) return result;
    const Ball angle = enclosure(result, first_precision);
    for (long q = 1; q <= most_parts_of_pi; ++q) {
        const auto p = possible_part(angle, q);
        if (!p) continue;
        const Number candidate = ground.pi() * Number(*p) / Number(q);
        const Number rest = difference(ground.cos(candidate), ground.sin(candidate));
        if (is_exact(rest) && rest.is_zero()) return candidate;
    }
    return result;
}

[[nodiscard]] bool exceeds_one(const Number& argument) {
    const Number rest = Number(1) - argument * argument;
    return !argument.has_parameters() && !(is_exact(rest) && rest.is_zero()) && rest.sign() < 0;
}

Number tangent(bool circular, const Number& x, const Ground& ground) {
    const Number grows = circular ? Number(0) : ground.exp(Number(2) * x);
    const Number above = circular ? ground.sin(x) : grows - Number(1);
    const Number below = circular ? ground.cos(x) : grows + Number(1);
    if (below.is_zero()) throw DivisionByZero();
    return above / below;
}

Number hyperbolic(bool even, const Number& x, const Ground& ground) {
    const Number grows = ground.exp(x);
    const Number decays = ground.exp(-x);
    return (even ? grows + decays : grows - decays) / Number(2);
}

/// Returns log(x + sqrt(x^2 + square)), where the root is rational.
std::optional<Number> area(const Number& x, long square, const Ground& ground) {
    const auto root = rational_root(x * x + Number(square), 2, ground);
    return root ? std::optional(ground.log(x + *root)) : std::nullopt;
}

Number cube_root(const Number& x, const Ground& ground) {
    refuse_parameters(x, "cbrt");
    if (!is_exact(x)) { return enclosed(x, arb_cbrt); }
    return x.sign() < 0 ? -power(-x, {1, 3}, ground) : power(x, {1, 3}, ground);
}

Number error_function(bool complement, const Number& x) {
    refuse_parameters(x, complement ? "erfc" : "erf");
    if (is_exact(x) && x.is_zero()) { return Number(complement ? 1 : 0); }
    return enclosed(x, complement ? arb_erfc : arb_erf);
}

/// Returns the angle of the point (x, y) in (-pi, pi].
Number angle_of_point(const Number& y, const Number& x, const Ground& ground) {
    const int up = y.sign(), right = x.sign();
    if (up == 0 && right == 0) { throw MathError("the origin has no angle"); }
    if (right == 0) { return Number(up) * ground.pi() / Number(2); }
    const Number main = arctangent(y / x, ground);
    return right > 0 ? main : main + Number(up < 0 ? -1 : 1) * ground.pi();
}

}  // namespace

bool compares(bool is_strict, const Number& a, const Number& b) {
    const Number difference = b - a;
    refuse_parameters(difference, "a comparison");
    return is_strict ? difference.sign() > 0 : difference.sign() >= 0;
}

Number elementary(const std::string& name, const NumberVector& arguments, const Ground& ground) {
    for (const Number& argument : arguments) { refuse_parameters(argument, name.c_str()); }
    const Number& a = arguments.front();
    const Number& b = arguments.back();
    if (name == "abs") { return a.sign() < 0 ? -a : a; }
    if (name == "sign") { return a.sign(); }
    if (name == "min") { return compares(true, b, a) ? b : a; }
    if (name == "max") { return compares(true, a, b) ? b : a; }
    HVI_CHECK(name == "atan2");
    return angle_of_point(a, b, ground);
}

Number arcsine(const Number& sine, const Ground& ground) {
    if (exceeds_one(sine)) {
        throw MathError("the arcsine of a number outside [-1, 1] is not real");
    }
    return inverse_circular(sine, ground, "asin", arb_asin,
                            [&](const Number&, const Number& sin) { return sin - sine; });
}

Number arccosine(const Number& cosine, const Ground& ground) {
    if (exceeds_one(cosine)) {
        throw MathError("the arccosine of a number outside [-1, 1] is not real");
    }
    return inverse_circular(cosine, ground, "acos", arb_acos,
                            [&](const Number& cos, const Number&) { return cos - cosine; });
}

Number arctangent(const Number& tangent, const Ground& ground) {
    return inverse_circular(
        tangent, ground, "atan", arb_atan,
        [&](const Number& cos, const Number& sin) { return sin - tangent * cos; });
}

Number area_sine(const Number& sine, const Ground& ground) {
    refuse_parameters(sine, "asinh");
    const auto exact = area(sine, 1, ground);
    return exact ? *exact : enclosed(sine, arb_asinh);
}

Number area_cosine(const Number& cosine, const Ground& ground) {
    refuse_parameters(cosine, "acosh");
    const auto exact = area(cosine, -1, ground);
    if (!exact && (cosine - Number(1)).sign() < 0) {
        throw MathError("the arcosh of a number below 1 is not real");
    }
    return exact ? *exact : enclosed(cosine, arb_acosh);
}

Number area_tangent(const Number& tangent, const Ground& ground) {
    refuse_parameters(tangent, "atanh");
    const Number above = Number(1) + tangent, below = Number(1) - tangent;
    if (above.sign() <= 0 || below.sign() <= 0) {
        throw MathError("the artanh of a number that is not between -1 and 1 is not real");
    }
    return ground.log(above / below) / Number(2);
}

Number elementary(const std::string& name, const Number& argument, const Ground& ground) {
    if (name == "sqrt") return ground.sqrt(argument);
    if (name == "exp") return ground.exp(argument);
    if (name == "log") return ground.log(argument);
    if (name == "cos") return ground.cos(argument);
    if (name == "sin") return ground.sin(argument);
    if (name == "asin") return arcsine(argument, ground);
    if (name == "acos") return arccosine(argument, ground);
    if (name == "atan") return arctangent(argument, ground);
    if (name == "cosh" || name == "sinh") return hyperbolic(name == "cosh", argument, ground);
    if (name == "log10") return ground.log(argument) / ground.log(Number(10));
    if (name == "cbrt") return cube_root(argument, ground);
    if (name == "asinh") return area_sine(argument, ground);
    if (name == "acosh") return area_cosine(argument, ground);
    if (name == "atanh") return area_tangent(argument, ground);
    if (name == "erf" || name == "erfc") return error_function(name == "erfc", argument);
    HVI_CHECK(name == "tan" || name == "tanh");
    return tangent(name == "tan", argument, ground);
}

}  // namespace hvi::gen

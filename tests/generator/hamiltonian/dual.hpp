// Values and derivatives of expressions in floating point, by automatic differentiation: what the
// exact derivatives are compared with.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "generator/expr/expression.hpp"

namespace hvi::gen {

using Real = long double;

/// value + slope * epsilon, with epsilon^2 = 0.
struct Dual {
    Real value = 0, slope = 0;

    friend Dual operator+(Dual a, Dual b) { return {a.value + b.value, a.slope + b.slope}; }
    friend Dual operator*(Dual a, Dual b) {
        return {a.value * b.value, a.value * b.slope + a.slope * b.value};
    }
};

inline Dual chain(Dual x, Real value, Real derivative) { return {value, derivative * x.slope}; }

inline Dual call(const std::string& name, Dual x) {
    const Real v = x.value;
    if (name == "cbrt") return chain(x, std::cbrt(v), std::cbrt(v) / (3 * v));
    if (name == "sqrt") return chain(x, std::sqrt(v), 1 / (2 * std::sqrt(v)));
    if (name == "exp") return chain(x, std::exp(v), std::exp(v));
    if (name == "log") return chain(x, std::log(v), 1 / v);
    if (name == "sin") return chain(x, std::sin(v), std::cos(v));
    if (name == "cos") return chain(x, std::cos(v), -std::sin(v));
    if (name == "tan") return chain(x, std::tan(v), 1 / (std::cos(v) * std::cos(v)));
    if (name == "asin") return chain(x, std::asin(v), 1 / std::sqrt(1 - v * v));
    if (name == "acos") return chain(x, std::acos(v), -1 / std::sqrt(1 - v * v));
    if (name == "atan") return chain(x, std::atan(v), 1 / (1 + v * v));
    if (name == "sinh") return chain(x, std::sinh(v), std::cosh(v));
    if (name == "cosh") return chain(x, std::cosh(v), std::sinh(v));
    if (name == "tanh") return chain(x, std::tanh(v), 1 / (std::cosh(v) * std::cosh(v)));
    return {std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::quiet_NaN()};
}

inline Dual power(Dual base, Dual exponent) {
    const Real value = std::pow(base.value, exponent.value);
    const Real by_base = exponent.value * std::pow(base.value, exponent.value - 1);
    const Real by_exponent = exponent.slope == 0 ? 0 : value * std::log(base.value);
    return {value, by_base * base.slope + by_exponent * exponent.slope};
}

using Point = std::map<std::string, Dual>;

/// Symbols other than pi and e have their values in `point`.
inline Dual evaluate(const Expression& expression, const Point& point) {
    using What = Expression::Kind;
    const auto argument = [&](std::size_t k) { return evaluate(expression.arguments[k], point); };
    switch (expression.kind) {
    case What::number:
        return {std::stold(expression.numerator) / std::stold(expression.denominator)};
    case What::symbol:
        if (expression.name == "pi") return {std::acos(Real(-1))};
        if (expression.name == "e") return {std::exp(Real(1))};
        return point.at(expression.name);
    case What::sum: {
        Dual sum;
        for (std::size_t k = 0; k < expression.arguments.size(); ++k) sum = sum + argument(k);
        return sum;
    }
    case What::product: {
        Dual product{1};
        for (std::size_t k = 0; k < expression.arguments.size(); ++k)
            product = product * argument(k);
        return product;
    }
    case What::negation: return Dual{-1} * argument(0);
    case What::reciprocal: {
        const Dual x = argument(0);
        return chain(x, 1 / x.value, -1 / (x.value * x.value));
    }
    case What::power: return power(argument(0), argument(1));
    case What::call:
        if (expression.name == "if<")
            return argument(argument(0).value < argument(1).value ? 2 : 3);
        return call(expression.name, argument(0));
    case What::element:
    case What::sum_over: break;  // of texts with indices alone
    }
    return {std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::quiet_NaN()};
}

}  // namespace hvi::gen

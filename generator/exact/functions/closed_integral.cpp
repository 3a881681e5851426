// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/functions/closed_integral.hpp"

#include "generator/exact/functions/elementary.hpp"

namespace hvi::gen {

namespace {

/// Returns an antiderivative of u^a log(u)^m at u >= 0: u^(a+1) log(u)^m/(a+1) less m/(a+1) times
/// the one of u^a log(u)^(m-1), or log(u)^(m+1)/(m+1).
Number power_log_antiderivative(const Number& u, const Ratio& a, unsigned m, const Ground& ground) {
    const Ratio next = a + Ratio{1, 1};
    if (next.above > 0 && u.is_zero()) return Number(0);
    if (next.above <= 0 && u.is_zero()) {
        throw MathError("the function is not integrable: its integral is infinite");
    }
    const Number logarithm = m > 0 || next.above == 0 ? ground.log(u) : Number(0);
    if (next.above == 0) return power(logarithm, m + 1) / Number(static_cast<long>(m) + 1);
    const Number scale = Number(1) / to_number(next);
    const Number first = power(u, next, ground) * power(logarithm, m);
    if (m == 0) return scale * first;
    return scale *
           (first - Number(static_cast<long>(m)) * power_log_antiderivative(u, a, m - 1, ground));
}

std::optional<Number> integral_of(const LinearPower& factor, unsigned k, const Number& from,
                                  const Number& to, const Ground& ground) {
    HVI_CHECK(k == 0);  // the normal form has no others
    const Number lower = value_at(factor.line(), from);
    const Number upper = value_at(factor.line(), to);
    const Number difference =
        power_log_antiderivative(upper, factor.exponent, factor.logs, ground) -
        power_log_antiderivative(lower, factor.exponent, factor.logs, ground);
    return Number(factor.sign) * difference;
}

/// Returns the angle in [0, pi) of a point (x, y) with y >= 0.
Number angle(const Number& x, const Number& y, const Ground& ground) {
    const int side = x.is_zero() ? 0 : x.sign();
    if (side == 0) return ground.pi() / Number(2);
    const Number main = arctangent(y / x, ground);
    return side > 0 ? main : main + ground.pi();
}

/// Returns the integral of 1/(u^2 + d) over [from, to]. It is the angle between (sqrt(d), from) and
/// (sqrt(d), to), divided by sqrt(d): one angle, so that it is exact more often than two.
Number arctangent_integral(const Number& d, const Number& from, const Number& to,
                           const Ground& ground) {
    const Number root = ground.sqrt(d);
    const bool backward = (to - from).sign() < 0;
    const Number difference = backward ? from - to : to - from;
    const Number result = angle(d + from * to, root * difference, ground) / root;
    return backward ? -result : result;
}

/// Returns the integral of 1/(u^2 + d)^order, by the integrals I_n of 1/(u^2 + d)^n and 2 d n
/// I_(n+1) = [u/(u^2 + d)^n] + (2n - 1) I_n.
Number quadratic_integral(const Number& d, unsigned order, const Number& from, const Number& to,
                          const Ground& ground) {
    Number result = arctangent_integral(d, from, to, ground);
    for (unsigned n = 1; n < order; ++n) {
        const Number edge = to / power(to * to + d, n) - from / power(from * from + d, n);
        result = (edge + Number(2 * static_cast<long>(n) - 1) * result) /
                 (Number(2 * static_cast<long>(n)) * d);
    }
    return result;
}

/// Returns the integral of tau^k times a pole, with tau^2 + p tau + q = u^2 + d for u = tau + p/2.
std::optional<Number> integral_of(const Pole& factor, unsigned k, const Number& from,
                                  const Number& to, const Ground& ground) {
    if (factor.polynomial.size() != 3) return std::nullopt;
    const Number half = factor.polynomial[1] / Number(2);
    const Number d = factor.polynomial[0] - half * half;
    const Number plain = quadratic_integral(d, factor.order, from + half, to + half, ground);
    if (k == 0) return plain;
    HVI_CHECK(k == 1);
    const Number lower = value_at(factor.polynomial, from);
    const Number upper = value_at(factor.polynomial, to);
    Number odd;  // integral of u/(u^2 + d)^order
    if (factor.order == 1) {
        odd = ground.log(upper / lower) / Number(2);
    } else {
        const unsigned n = factor.order - 1;
        odd = (Number(1) / power(lower, n) - Number(1) / power(upper, n)) /
              Number(2 * static_cast<long>(n));
    }
    return odd - half * plain;
}

/// Returns an antiderivative of a function at x, for functions that have an elementary one.
std::optional<Number> antiderivative(const std::string& name, const Number& x,
                                     const Ground& ground) {
    const Number one(1);
    if (name == "tan") {
        const Number cosine = ground.cos(x);
        return -ground.log(cosine * cosine) / Number(2);
    }
    if (name == "tanh") return ground.log(elementary("cosh", x, ground));
    if (name == "atan") { return x * arctangent(x, ground) - ground.log(one + x * x) / Number(2); }
    if (name == "asin") return x * arcsine(x, ground) + ground.sqrt(one - x * x);
    if (name == "acos") return x * arccosine(x, ground) - ground.sqrt(one - x * x);
    if (name == "asinh") return x * area_sine(x, ground) - ground.sqrt(x * x + one);
    if (name == "acosh") return x * area_cosine(x, ground) - ground.sqrt(x * x - one);
    return std::nullopt;
}

/// Returns the integral of tau^k log(g) by parts: tau^(k+1)/(k+1) log(g) less the integral of
/// tau^(k+1)/(k+1) g'/g, for a quadratic g without a real root.
std::optional<Number> logarithm_integral(const NumberPolynomial& g, unsigned k, const Number& from,
                                         const Number& to, const Ground& ground) {
    if (g.size() != 3 || !g.back().is_one()) return std::nullopt;
    const auto edge = [&](const Number& tau) {
        return power(tau, k + 1) * ground.log(value_at(g, tau));
    };
    const ExactFunction slope(NumberPolynomial{g[1], Number(2)});
    NumberPolynomial monomial(k + 2);
    monomial.back() = Number(1);
    const ExactFunction rest =
        slope * ExactFunction(monomial) * ExactFunction(make_factor(Pole{g, 1}));
    const Number integral = rest.integral(to, ground) - rest.integral(from, ground);
    return (edge(to) - edge(from) - integral) / Number(static_cast<long>(k) + 1);
}

std::optional<Number> integral_of(const Call& factor, unsigned k, const Number& from,
                                  const Number& to, const Ground& ground) {
    if (!factor.argument.is_polynomial()) return std::nullopt;
    const NumberPolynomial argument = factor.argument.coefficients();
    if (factor.name == "log") return logarithm_integral(argument, k, from, to, ground);
    if (k != 0 || argument.size() != 2) return std::nullopt;
    const auto upper = antiderivative(factor.name, value_at(argument, to), ground);
    if (!upper) return std::nullopt;
    const auto lower = antiderivative(factor.name, value_at(argument, from), ground);
    return (*upper - *lower) / argument[1];
}

/// Returns the integral of 1/sqrt(Q), Q = a tau^2 + b tau + c with two different roots.
Number inverse_root_integral(const NumberPolynomial& Q, const Number& discriminant,
                             const Number& from, const Number& to, const Ground& ground) {
    const Number& a = Q[2];
    const auto slope = [&](const Number& tau) { return Number(2) * a * tau + Q[1]; };
    if (a.sign() < 0) {
        const Number root = ground.sqrt(discriminant);
        const Number difference =
            arcsine(slope(from) / root, ground) - arcsine(slope(to) / root, ground);
        return difference / ground.sqrt(-a);
    }
    const Number root = ground.sqrt(a);
    const auto inner = [&](const Number& tau) {
        return Number(2) * root * ground.sqrt(value_at(Q, tau)) + slope(tau);
    };
    return ground.log(inner(to) / inner(from)) / root;
}

/// Returns the integrals J_k of tau^k/sqrt(Q) by a k J_k = [tau^(k-1) sqrt(Q)] - b (k - 1/2)
/// J_(k-1) - c (k - 1) J_(k-2).
NumberVector inverse_root_moments(const NumberPolynomial& Q, std::size_t count,
                                  const Number& discriminant, const Number& from, const Number& to,
                                  const Ground& ground) {
    NumberVector J{inverse_root_integral(Q, discriminant, from, to, ground)};
    const Number lower = ground.sqrt(value_at(Q, from));
    const Number upper = ground.sqrt(value_at(Q, to));
    for (unsigned k = 1; k < count; ++k) {
        const Number index(static_cast<long>(k));
        Number sum = power(to, k - 1) * upper - power(from, k - 1) * lower -
                     Q[1] * (index - Number(1) / Number(2)) * J[k - 1];
        if (k >= 2) sum = sum - Q[0] * (index - Number(1)) * J[k - 2];
        J.push_back(sum / (Q[2] * index));
    }
    return J;
}

/// Returns the integral of tau^k Q^(m/2) = tau^k Q^((m+1)/2)/sqrt(Q) for a quadratic Q and odd m >=
/// -1.
std::optional<Number> integral_of(const Power& factor, unsigned k, const Number& from,
                                  const Number& to, const Ground& ground) {
    const bool fits =
        factor.base.is_polynomial() && factor.exponent.below == 2 && factor.exponent.above >= -1;
    if (!fits) return std::nullopt;
    const NumberPolynomial Q = factor.base.coefficients();
    if (Q.size() != 3) return std::nullopt;
    for (const Number& coefficient : Q) {
        if (!is_exact(coefficient)) return std::nullopt;
    }
    const Number discriminant = Q[1] * Q[1] - Number(4) * Q[2] * Q[0];
    if (discriminant.is_zero()) return std::nullopt;
    const auto whole = static_cast<unsigned>((factor.exponent.above + 1) / 2);
    const NumberPolynomial above = power_of(Q, whole);
    const NumberVector J =
        inverse_root_moments(Q, above.size() + k, discriminant, from, to, ground);
    Number sum;
    for (std::size_t i = 0; i < above.size(); ++i) sum = sum + above[i] * J[i + k];
    return sum;
}

std::optional<Number> integral_of(const Product& /*factor*/, unsigned /*k*/, const Number& /*from*/,
                                  const Number& /*to*/, const Ground& /*ground*/) {
    return std::nullopt;
}

}  // namespace

std::optional<Number> closed_integral(const Factor& factor, unsigned k, const Number& from,
                                      const Number& to, const Ground& ground) {
    return std::visit([&](const auto& kind) { return integral_of(kind, k, from, to, ground); },
                      factor.what);
}

}  // namespace hvi::gen

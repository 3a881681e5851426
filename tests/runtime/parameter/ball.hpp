// Real numbers with proven bounds, by Arb, to judge what the runtime computes.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <arb.h>

#include <limits>

#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/pair.hpp>

namespace parameter {

/// A number to 1500 bits.
class Ball {
public:
    Ball() { arb_init(x_); }
    Ball(double value) : Ball() { arb_set_d(x_, value); }  // NOLINT: a number like others
    Ball(const Ball& other) : Ball() { arb_set(x_, other.x_); }
    Ball& operator=(const Ball& other) {
        arb_set(x_, other.x_);
        return *this;
    }
    ~Ball() { arb_clear(x_); }

    /// Returns the exact value. An infinite value, or one that is not a number, could be any
    /// number.
    template <class S>
    static Ball of(S value) {
        Ball sum;
        if (!hvi::detail::is_finite(value)) {
            arb_indeterminate(sum.x_);
            return sum;
        }
        slong exponent = 0;
        for (; hvi::detail::abs(value) >= 1; value /= 2) { ++exponent; }
        for (; value != 0 && hvi::detail::abs(value) < S(1) / 2; value *= 2) { --exponent; }
        while (value != 0) {
            const auto part = static_cast<double>(value);
            value -= static_cast<S>(part);
            sum = sum + part;
        }
        arb_mul_2exp_si(sum.x_, sum.x_, exponent);
        return sum;
    }
    template <class S>
    static Ball of(const hvi::detail::Pair<S>& pair) {
        return of(pair.hi) + of(pair.lo);
    }
    static Ball pi() {
        Ball result;
        arb_const_pi(result.x_, bits);
        return result;
    }

    friend Ball operator+(const Ball& a, const Ball& b) { return apply(arb_add, a, b); }
    friend Ball operator-(const Ball& a, const Ball& b) { return apply(arb_sub, a, b); }
    friend Ball operator*(const Ball& a, const Ball& b) { return apply(arb_mul, a, b); }
    friend Ball operator/(const Ball& a, const Ball& b) { return apply(arb_div, a, b); }
    friend Ball sin(const Ball& a) { return apply(arb_sin, a); }
    friend Ball cos(const Ball& a) { return apply(arb_cos, a); }
    friend Ball exp(const Ball& a) { return apply(arb_exp, a); }
    friend Ball sqrt(const Ball& a) { return apply(arb_sqrt, a); }

    /// The nearest number or one beside it.
    template <class S>
    [[nodiscard]] S rounded() const {
        S sum = 0;
        Ball rest = *this;
        for (int i = 0; i < 5; ++i) {
            const double part = arf_get_d(arb_midref(rest.x_), ARF_RND_NEAR);
            sum += static_cast<S>(part);
            rest = rest - part;
        }
        return sum;
    }

    /// Not less than |this|, or infinity where the ball says too little of it.
    [[nodiscard]] double bound() const {
        arf_t upper;
        arf_init(upper);
        arb_get_abs_ubound_arf(upper, x_, 53);
        const double result = arf_get_d(upper, ARF_RND_UP);
        arf_clear(upper);
        return result == result ? result : std::numeric_limits<double>::infinity();
    }

    /// A unit in the last place.
    template <class S>
    [[nodiscard]] Ball ulp() const {
        Ball result(1.0);
        const slong above = arf_abs_bound_lt_2exp_si(arb_midref(x_));
        arb_mul_2exp_si(result.x_, result.x_, above - hvi::detail::bits<S>);
        return result;
    }

private:
    static constexpr slong bits = 1500;

    template <class Operation>
    static Ball apply(Operation operation, const Ball& a, const Ball& b) {
        Ball result;
        operation(result.x_, a.x_, b.x_, bits);
        return result;
    }
    template <class Operation>
    static Ball apply(Operation operation, const Ball& a) {
        Ball result;
        operation(result.x_, a.x_, bits);
        return result;
    }

    arb_t x_;
};

/// Returns the distance in units of epsilon^2, relative to the exact value.
template <class S>
double relative_error(const hvi::detail::Pair<S>& value, const Ball& exact) {
    const Ball eps = Ball::of(hvi::detail::epsilon<S>);
    return ((Ball::of(value) - exact) / exact / (eps * eps)).bound();
}

/// The distance in units of epsilon^2.
template <class S>
double absolute_error(const hvi::detail::Pair<S>& value, const Ball& exact) {
    const Ball eps = Ball::of(hvi::detail::epsilon<S>);
    return ((Ball::of(value) - exact) / (eps * eps)).bound();
}

/// Returns the distance in units in the last place of the exact value.
template <class S>
double ulps(S value, const Ball& exact) {
    return ((Ball::of(value) - exact) / exact.ulp<S>()).bound();
}

}  // namespace parameter

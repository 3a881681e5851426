// Arithmetic with twice the digits, and sin, cos and exp.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include <catch2/catch.hpp>
#include <hvi/detail/numbers/pair.hpp>

#include "ball.hpp"
#include "numbers.hpp"

using hvi::detail::Pair;
using parameter::absolute_error;
using parameter::Ball;
using parameter::Numbers;
using parameter::relative_error;
using parameter::ulps;

namespace {

/// Whether the low part is at most half a unit of the high one.
template <class S>
bool is_normal(const Pair<S>& a) {
    return a.hi + a.lo == a.hi;
}

/// The largest of the errors.
class Worst {
public:
    void add(double error) { worst_ = std::fmax(worst_, error); }
    [[nodiscard]] double value() const { return worst_; }

private:
    double worst_ = 0;
};

/// The errors of the four operations.
struct Errors {
    Worst sum, difference, product, quotient;
    bool normal = true;

    template <class S>
    void add(const Pair<S>& a, const Pair<S>& b) {
        const Ball x = Ball::of(a);
        const Ball y = Ball::of(b);
        sum.add(error(a + b, x + y));
        difference.add(error(a - b, x - y));
        product.add(error(a * b, x * y));
        quotient.add(error(a / b, x / y));
    }

private:
    template <class S>
    double error(const Pair<S>& value, const Ball& exact) {
        normal = normal && is_normal(value);
        if (value.hi == 0 && exact.bound() == 0) { return 0; }
        return relative_error(value, exact);
    }
};

}  // namespace

TEMPLATE_TEST_CASE("pairs add, subtract, multiply and divide to a few units of epsilon^2", "",
                   HVI_WORK_SCALARS) {
    using S = TestType;
    const unsigned seed = 1;
    Numbers numbers(seed);
    Errors errors;
    for (int i = 0; i < 4000; ++i) {
        const auto a = numbers.pair<S>(-40, 40);
        errors.add(a, numbers.pair<S>(-40, 40));
        // Sums of which the high parts cancel, to few bits or to none.
        const auto noise = numbers.pair<S>(-2 * hvi::detail::bits<S>, 0);
        const S hi = a.hi + a.hi * noise.hi;
        errors.add(a, numbers.normal(hi));
        errors.add(a, numbers.normal(-hi));
        errors.add(a, numbers.normal(-a.hi));
        errors.add(a, Pair<S>{-a.hi, numbers.pair<S>(-30, 0).hi * a.lo});
    }
    CAPTURE(seed, errors.sum.value(), errors.product.value(), errors.quotient.value());
    CHECK(errors.normal);
    CHECK(errors.sum.value() < 0.75);
    CHECK(errors.difference.value() < 0.75);
    CHECK(errors.product.value() < 1.25);
    CHECK(errors.quotient.value() < 2.5);
}

TEMPLATE_TEST_CASE("constants are read to the last digit of a pair", "", HVI_WORK_SCALARS) {
    using S = TestType;
    const hvi::detail::Expansion pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53,
                                    -0x1.f1976b7ed8fbcp-109, 0x1.4cf98e804177dp-163,
                                    0x1.31d89cd9128a5p-217};
    const auto value = hvi::detail::to_pair<S>(pi);
    CHECK(is_normal(value));
    CHECK(relative_error(value, Ball::pi()) < 0.25);
}

TEMPLATE_TEST_CASE("sin and cos of any angle up to 2^22", "", HVI_WORK_SCALARS) {
    using S = TestType;
    const unsigned seed = 2;
    Numbers numbers(seed);
    Worst worst;
    const auto check = [&](const Pair<S>& angle) {
        const auto [sine, cosine] = sin_cos(angle);
        worst.add(absolute_error(sine, sin(Ball::of(angle))));
        worst.add(absolute_error(cosine, cos(Ball::of(angle))));
    };
    for (int i = 0; i < 1000; ++i) {
        check(numbers.pair<S>(21, 22));
        check(numbers.pair<S>(-60, 22));
    }
    CAPTURE(seed, worst.value());
    CHECK(worst.value() < 1);
}

TEMPLATE_TEST_CASE("the zeros of sin and cos keep their digits, far out as well", "",
                   HVI_WORK_SCALARS) {
    using S = TestType;
    Worst worst;
    double nearest = 1;
    const auto check = [&](const Pair<S>& angle, int k) {
        const auto [sine, cosine] = sin_cos(angle);
        const Pair<S>& value = k % 2 == 0 ? sine : cosine;
        const Ball exact = k % 2 == 0 ? sin(Ball::of(angle)) : cos(Ball::of(angle));
        nearest = std::fmin(nearest, exact.bound());
        // pi/2 is known to 2^-271.
        const bool is_exact = (Ball::of(value) - exact).bound() <= k * 0x1p-271;
        worst.add(is_exact ? 0 : relative_error(value, exact));
    };
    for (int k = 1; k < 2'600'000; k += 1 + k / 3) {
        const Ball zero = Ball::pi() * k / 2;
        const S hi = zero.rounded<S>();
        const Ball missing = zero - Ball::of(hi);
        check(Pair<S>{hi}, k);
        check(Pair<S>{-hi}, k);
        // Nearer by 24 bits.
        check(Pair<S>{hi, static_cast<S>(static_cast<float>(missing.rounded<double>()))}, k);
    }
    CAPTURE(std::log2(nearest), worst.value());
    CHECK(nearest < 0x1p-70);
    CHECK(worst.value() < 1);
}

TEMPLATE_TEST_CASE("sin and cos at 0", "", HVI_WORK_SCALARS) {
    using S = TestType;
    const auto [sine, cosine] = sin_cos(Pair<S>{});
    CHECK((sine.hi == 0 && sine.lo == 0 && cosine.hi == 1 && cosine.lo == 0));
}

TEMPLATE_TEST_CASE("exp from -700 to 700", "", HVI_WORK_SCALARS) {
    using S = TestType;
    const unsigned seed = 3;
    Numbers numbers(seed);
    Worst worst;
    const auto check = [&](const Pair<S>& exponent) {
        const Ball exact = exp(Ball::of(exponent));
        const Pair<S> value = exp(exponent);
        // The low part of the smallest doubles is cut off at 2^-1074.
        const Ball cut = std::is_same_v<S, double> ? Ball(0x1p-1074) : Ball();
        const Ball error = Ball::of(value) - exact;
        worst.add(error.bound() <= cut.bound() ? 0 : relative_error(value, exact));
    };
    for (int i = 0; i < 1000; ++i) {
        check(numbers.normal(700 * numbers.unit<S>()));
        check(numbers.pair<S>(-60, 3));
    }
    CAPTURE(seed, worst.value());
    CHECK(worst.value() < 2);
    CHECK(relative_error(exp(Pair<S>{S(709.5)}), exp(Ball(709.5))) < 2);
}

TEMPLATE_TEST_CASE("exp at 0 and at the ends", "", HVI_WORK_SCALARS) {
    using S = TestType;
    const Pair<S> one = exp(Pair<S>{});
    CHECK((one.hi == 1 && one.lo == 0));
    for (const double exponent : {-12000.0, -16384.0, -16385.0, -1e6, -1e300}) {
        const Pair<S> value = exp(Pair<S>{S(exponent)});
        CHECK((value.hi == 0 && value.lo == 0));
    }
    CHECK(exp(Pair<double>{-745.0}).hi == 0x1p-1074);
}

TEMPLATE_TEST_CASE("a pair is rounded to the scalar it was computed for", "", HVI_SCALARS) {
    using T = TestType;
    using S = hvi::detail::Work<T>;
    const Pair<S> third = Pair<S>{S(1)} / Pair<S>{S(3)};
    CHECK(ulps(hvi::detail::to_scalar<T>(third), Ball(1.0) / 3.0) <= 0.5);
}

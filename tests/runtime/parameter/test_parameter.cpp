// The coefficients of a method with a parameter.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <catch2/catch.hpp>
#include <hvi/detail/coefficients/parameter.hpp>

#include "ball.hpp"
#include "numbers.hpp"

using hvi::Status;
using hvi::detail::AtParameter;
using hvi::detail::EntireFunction;
using hvi::detail::Expansion;
using hvi::detail::Pair;
using hvi::detail::Phase;
using hvi::detail::Term;
using hvi::detail::to_scalar;
using parameter::Ball;
using parameter::Numbers;
using parameter::ulps;
using Code = Status::Code;

namespace {

/// The basis 1, cos(w t), sin(w t) at the nodes 0, 1/2, 1. With x = sin(w/4) and y = cos(w/4) it is
/// b_1 = (w - 4 x y)/(4 w x^2) and b_2 = -(w (y^2 - x^2) - 4 x y)/(2 w x^2).
struct Trigonometric {
    static constexpr std::array<Phase, 1> phases{{{Phase::Kind::angle, {{0.25}}}}};
    static constexpr std::array<Expansion, 0> constants{};
    static constexpr std::array<Term<3>, 7> terms{{
        {1, {{1, 0, 0}}},
        {1, {{0, 1, 0}}},
        {1, {{1, 0, 0}}},
        {-4, {{0, 1, 1}}},
        {1, {{1, 0, 2}}},
        {-1, {{1, 2, 0}}},
        {-4, {{0, 1, 1}}},
    }};
    static constexpr std::array<EntireFunction, 4> functions{{
        {EntireFunction::Role::pole, 1, 1},
        {EntireFunction::Role::pole, 1, 1},
        {EntireFunction::Role::weight, 2, 3},
        {EntireFunction::Role::weight, 3, 3},
    }};
    static constexpr std::size_t length = 24;
    static constexpr double switch_point = 0x1p-3;
    static constexpr Code at_zero = Code::ok;
};

constexpr std::array<unsigned char, 2> once_and_twice{1, 2};

template <class T>
T b_1(const AtParameter<Trigonometric, T>& at) {
    return to_scalar<T>(at.quotient(2, 4, once_and_twice));
}

template <class T>
T b_2(const AtParameter<Trigonometric, T>& at) {
    return to_scalar<T>(at.quotient(3, -2, once_and_twice));
}

template <class T>
Ball exact_b_1(T parameter) {
    const Ball w = Ball::of(parameter);
    return (w - 2.0 * sin(w / 2.0)) / (2.0 * w * (1.0 - cos(w / 2.0)));
}

template <class T>
Ball exact_b_2(T parameter) {
    const Ball w = Ball::of(parameter);
    return (w * cos(w / 2.0) - 2.0 * sin(w / 2.0)) / (w * cos(w / 2.0) - w);
}

/// A number with all its bits beside the double.
template <class T>
T with_all_bits(Numbers& numbers, double value) {
    return static_cast<T>(value) * (1 + numbers.unit<T>() * static_cast<T>(0x1p-20));
}

/// The code at this parameter and at the opposite one.
template <class Functions, class T>
Code code(T w) {
    const Code result = AtParameter<Functions, T>(w).status().code();
    CHECK((AtParameter<Functions, T>(-w).status().code() == result));
    return result;
}

/// The nearest number, moved by the relative distance.
template <class T>
T near(const Ball& zero, double distance) {
    return zero.rounded<T>() * (1 + static_cast<T>(distance));
}

}  // namespace

TEMPLATE_TEST_CASE("weights are right to an ulp for every parameter", "", HVI_SCALARS) {
    using T = TestType;
    const unsigned seed = 6;
    Numbers numbers(seed);
    double worst = 0;
    int refused = 0;
    const auto check = [&](T w) {
        const AtParameter<Trigonometric, T> at(w);
        if (!at.status().ok()) {
            ++refused;
            return;
        }
        worst = std::fmax(worst, ulps(b_1(at), exact_b_1(w)));
        worst = std::fmax(worst, ulps(b_2(at), exact_b_2(w)));
    };
    for (double exponent = -40; exponent < 10; exponent += 0.125) {
        check(with_all_bits<T>(numbers, std::exp2(exponent)));
        check(-with_all_bits<T>(numbers, std::exp2(exponent)));
    }
    for (int i = 0; i < 500; ++i) {
        check(static_cast<T>(20 * numbers.unit<T>()));
        check(static_cast<T>(1000 * numbers.unit<T>()));
    }
    for (const double w : {0x1p-3, 0x1.000002p-3, 0x1.fffffep-4, 1e-30, 1e-12, 0x1p20}) {
        check(static_cast<T>(w));
    }
    CAPTURE(seed, worst, refused);
    CHECK(worst < 0.501);
    CHECK(refused < 10);
}

TEMPLATE_TEST_CASE("at 0 the weights are those of the limit", "", HVI_SCALARS) {
    using T = TestType;
    for (const T w : {T(0), -T(0), T(std::numeric_limits<float>::denorm_min())}) {
        const AtParameter<Trigonometric, T> at(w);
        CHECK(at.status().ok());
        CHECK((b_1(at) == scalars::ratio<T>(1, 6) && b_2(at) == scalars::ratio<T>(2, 3)));
    }
}

TEMPLATE_TEST_CASE("near a pole there is no method, and a little further there is", "",
                   HVI_SCALARS) {
    using T = TestType;
    for (const int k : {1, 2, 3, 10, 70, 1000}) {
        const Ball pole = Ball::pi() * (4.0 * k);
        CAPTURE(k);
        CHECK((code<Trigonometric>(near<T>(pole, 0)) == Code::pole));
        CHECK((code<Trigonometric>(near<T>(pole, 1e-7)) == Code::pole));
        CHECK((code<Trigonometric>(near<T>(pole, -1e-7)) == Code::pole));
        for (const double distance : {1e-5, -1e-5}) {
            const T w = near<T>(pole, distance);
            CHECK((code<Trigonometric>(w) == Code::ok));
            const AtParameter<Trigonometric, T> at(w);
            CHECK(ulps(b_1(at), exact_b_1(w)) < 0.501);
            CHECK(ulps(b_2(at), exact_b_2(w)) < 0.501);
        }
    }
}

TEMPLATE_TEST_CASE("near a zero of a weight there is no method, and a little further there is", "",
                   HVI_SCALARS) {
    using T = TestType;
    // tan(w/2) = w/2.
    const double zero = 8.986818915818128;
    CHECK((code<Trigonometric>(static_cast<T>(zero)) == Code::zero_weight));
    CHECK((code<Trigonometric>(near<T>(zero, 5e-7)) == Code::zero_weight));
    CHECK((code<Trigonometric>(near<T>(zero, -5e-7)) == Code::zero_weight));
    for (const double distance : {2e-6, -2e-6}) {
        const T w = near<T>(zero, distance);
        CHECK((code<Trigonometric>(w) == Code::ok));
        CHECK(ulps(b_2(AtParameter<Trigonometric, T>(w)), exact_b_2(w)) < 0.501);
    }
}

TEMPLATE_TEST_CASE("what is no parameter", "", HVI_SCALARS) {
    using T = TestType;
    const T infinity = hvi::detail::infinity<T>;
    CHECK((code<Trigonometric>(infinity) == Code::not_finite));
    CHECK((code<Trigonometric>(infinity - infinity) == Code::not_finite));
    CHECK((code<Trigonometric>(T(1e7)) == Code::parameter_too_large));
    CHECK((code<Trigonometric>(T(0x1.000002p20)) == Code::parameter_too_large));
    CHECK((code<Trigonometric>(T(1e30)) == Code::parameter_too_large));
}

namespace {

/// Coefficients for x/y = exp(w): (exp(w) - 1 - w)/(w (exp(w) + 1)), pi (exp(w) - 1)/w and (exp(w)
/// - 1 - w)/w^2, and poles where exp(w) = 3, w exp(w) = 2 and -w exp(-w) = 2.
struct Exponential {
    static constexpr std::array<Phase, 1> phases{{{Phase::Kind::exponential, {{1.0}}}}};
    static constexpr std::array<Expansion, 1> constants{
        {{{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53, -0x1.f1976b7ed8fbcp-109,
           0x1.4cf98e804177dp-163, 0x1.31d89cd9128a5p-217}}}};
    static constexpr std::array<Term<4>, 15> terms{{
        {1, {{1, 0, 0, 0}}},
        {1, {{0, 0, 1, 0}}},
        {1, {{0, 1, 0, 0}}},
        {1, {{0, 0, 1, 0}}},
        {1, {{0, 1, 0, 0}}},
        {-3, {{0, 0, 1, 0}}},
        {1, {{0, 1, 0, 0}}},
        {-1, {{0, 0, 1, 0}}},
        {-1, {{1, 0, 1, 0}}},
        {1, {{0, 1, 0, 1}}},
        {-1, {{0, 0, 1, 1}}},
        {1, {{1, 1, 0, 0}}},
        {-2, {{0, 0, 1, 0}}},
        {1, {{1, 0, 1, 0}}},
        {2, {{0, 1, 0, 0}}},
    }};
    static constexpr std::array<EntireFunction, 8> functions{{
        {EntireFunction::Role::numerator, 1, 1},
        {EntireFunction::Role::numerator, 1, 0},
        {EntireFunction::Role::pole, 2, 0},
        {EntireFunction::Role::pole, 2, 0},
        {EntireFunction::Role::numerator, 3, 2},
        {EntireFunction::Role::weight, 2, 1},
        {EntireFunction::Role::pole, 2, 0},
        {EntireFunction::Role::pole, 2, 0},
    }};
    static constexpr std::size_t length = 40;
    static constexpr double switch_point = 0.5;
    static constexpr Code at_zero = Code::zero_weight;
};

}  // namespace

TEMPLATE_TEST_CASE("exponentials and constants", "", HVI_SCALARS) {
    using T = TestType;
    const unsigned seed = 7;
    Numbers numbers(seed);
    CAPTURE(seed);
    double worst = 0;
    const auto check = [&](T parameter) {
        const AtParameter<Exponential, T> at(parameter);
        if (!at.status().ok()) { return; }
        const Ball w = Ball::of(parameter);
        const Ball x = exp(w);
        const auto add = [&](const auto& value, const Ball& exact) {
            worst = std::fmax(worst, ulps(to_scalar<T>(value), exact));
        };
        add(at.quotient(4, 1, std::array<unsigned char, 3>{1, 0, 1}),
            (x - 1.0 - w) / (w * (x + 1.0)));
        add(at.quotient(5, 1, std::array<unsigned char, 2>{1, 1}), Ball::pi() * (x - 1.0) / w);
        add(at.quotient(4, 1, std::array<unsigned char, 2>{2, 1}), (x - 1.0 - w) / (w * w));
    };
    for (int i = 0; i < 300; ++i) {
        check(numbers.unit<T>());
        check(50 * numbers.unit<T>());
        check(with_all_bits<T>(numbers, std::exp2(numbers.between(-19, 0))));
    }
    CHECK(worst < 0.501);
    CHECK((AtParameter<Exponential, T>(T(1.0986123)).status().code() == Code::pole));
    CHECK((AtParameter<Exponential, T>(T(1.0986)).status().code() == Code::ok));
    const Ball pole(0x1.b488b55713c51p-1);
    for (const int sign : {1, -1}) {
        CHECK((code<Exponential>(near<T>(pole, sign * 8e-7)) == Code::pole));
        CHECK((code<Exponential>(near<T>(pole, sign * 1.4e-6)) == Code::ok));
    }
}

TEMPLATE_TEST_CASE("exponentials far out do not overflow", "", HVI_SCALARS) {
    using T = TestType;
    for (const double w : {1e3, -1e3, 0x1p20, -0x1p20}) {
        const AtParameter<Exponential, T> at(static_cast<T>(w));
        REQUIRE(at.status().ok());
        const auto value = to_scalar<T>(at.quotient(4, 1, std::array<unsigned char, 3>{1, 0, 1}));
        CHECK(ulps(value, w > 0 ? Ball(1.0) / w : -1.0 - Ball(1.0) / w) < 0.501);
    }
}

TEMPLATE_TEST_CASE("at 0, where there is no method, and near it", "", HVI_SCALARS) {
    using T = TestType;
    CHECK((code<Exponential>(T(0)) == Code::zero_weight));
    CHECK((code<Exponential>(T(0x1p-20)) == Code::zero_weight));
    CHECK((code<Exponential>(T(0x1.1p-20)) == Code::ok));
}

namespace {

/// w^2/(w^2 - 3), and its reciprocal, and a weight that vanishes with w^2 - 3.
struct Polynomial {
    static constexpr std::array<Phase, 0> phases{};
    static constexpr std::array<Expansion, 0> constants{};
    static constexpr std::array<Term<1>, 5> terms{
        {{1, {{1}}}, {1, {{2}}}, {-3, {{0}}}, {1, {{2}}}, {-3, {{0}}}}};
    static constexpr std::array<EntireFunction, 3> functions{{
        {EntireFunction::Role::pole, 1, 1},
        {EntireFunction::Role::pole, 2, 0},
        {EntireFunction::Role::weight, 2, 0},
    }};
    static constexpr std::size_t length = 3;
    static constexpr double switch_point = 0x1p-3;
    static constexpr Code at_zero = Code::pole;
};

/// A method whose coefficient has no pole at 0: w/(w^2 - 3).
struct WithoutPoleAtZero : Polynomial {
    static constexpr Code at_zero = Code::ok;
};

}  // namespace

TEMPLATE_TEST_CASE("functions that are polynomials", "", HVI_SCALARS) {
    using T = TestType;
    for (const double w : {0x1p-19, 0.0625, 0.125, 0.25, 1.0, -2.0, 1e6}) {
        const AtParameter<Polynomial, T> at(static_cast<T>(w));
        REQUIRE(at.status().ok());
        const Ball square = Ball(w) * w;
        const auto value = at.quotient(1, 1, std::array<unsigned char, 1>{2});
        CHECK(ulps(to_scalar<T>(value), (square - 3.0) / square) < 0.501);
        const auto same = at.quotient(1, 1, std::array<unsigned char, 0>{});
        CHECK(ulps(to_scalar<T>(same), square - 3.0) < 0.501);
    }
    CHECK((code<Polynomial>(T(0)) == Code::pole));
    CHECK((code<Polynomial>(sqrt(Ball(3.0)).rounded<T>()) == Code::pole));
    const AtParameter<WithoutPoleAtZero, T> at(T(0));
    CHECK(at.status().ok());
    CHECK((to_scalar<T>(at.quotient(0, 1, std::array<unsigned char, 2>{0, 1})) == T(0)));
}

TEMPLATE_TEST_CASE("a coefficient and its complement are rounded together", "", HVI_SCALARS) {
    using T = TestType;
    using S = hvi::detail::Work<T>;
    const unsigned seed = 8;
    Numbers numbers(seed);
    CAPTURE(seed);
    double worst = 0;
    const auto check = [&](const Pair<S>& exact) {
        T m = 0;
        T mt = 0;
        REQUIRE(hvi::detail::round_complementary<T>(exact, m, mt));
        CHECK((1 - m == mt && 1 - mt == m));
        const Ball x = Ball::of(exact);
        const Ball rest = 1.0 - x;
        const Ball& large = x.bound() > rest.bound() ? x : rest;
        const Ball unit = large.ulp<T>();
        worst = std::fmax(worst, ((Ball::of(m) - x) / unit).bound());
        worst = std::fmax(worst, ((Ball::of(mt) - rest) / unit).bound());
    };
    for (int i = 0; i < 500; ++i) {
        check(numbers.pair<S>(-66, 20));
        check(numbers.pair<S>(-2, 2));
    }
    const S most = hvi::detail::two_to_the<S>(hvi::detail::bits<T>);
    for (const S m : {S(0), S(1), S(-1), S(1) / 2, S(2), most, -most, 1 - most}) {
        check(Pair<S>{m});
    }
    CHECK(worst < 0.501);

    T m = 0;
    T mt = 0;
    const S huge = 2 * most;
    for (const S size : {huge, -huge, static_cast<S>(hvi::detail::infinity<S>),
                         static_cast<S>(hvi::detail::infinity<S> - hvi::detail::infinity<S>)}) {
        CHECK_FALSE(hvi::detail::round_complementary<T>(Pair<S>{size}, m, mt));
    }
}

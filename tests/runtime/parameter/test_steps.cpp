// Steps of methods with a parameter.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>
#include <hvi/generated/gauss_3.hpp>
#include <hvi/generated/gauss_4.hpp>
#include <hvi/newton.hpp>

#include "parameter/cosine_separable.hpp"
#include "parameter/gauss.hpp"
#include "parameter/half.hpp"
#include "parameter/trigonometric.hpp"
#include "parameter/with_line.hpp"
#include "parameter/with_line_separable.hpp"
#include "tests/runtime/run/systems.hpp"

using namespace hvi::generated;
using systems::One;
using Code = hvi::Status::Code;
using State = hvi::State<One>;

hvi::Status step_in_second_unit(State& x, double w, double h);

namespace {

const State start{{1.0}, {0.3}};

/// The distance of two steppers after some steps.
template <class First, class Second>
double distance(First first, Second second, double h, int steps) {
    State x = start;
    State y = start;
    for (int step = 0; step < steps; ++step) {
        REQUIRE(first.step(x, h).ok());
        REQUIRE(second.step(y, h).ok());
    }
    return std::hypot(x.q[0] - y.q[0], x.p[0] - y.p[0]);
}

/// The oscillator of frequency 1 with a term q^4/4000 in H.
struct Perturbed {
    using Vector = One;
    static constexpr double strength = 1e-3;
    void dHdq(const Vector& q, const Vector&, Vector& out) const {
        out[0] = q[0] + strength * q[0] * q[0] * q[0];
    }
    void dHdp(const Vector&, const Vector& p, Vector& out) const { out = p; }
};

/// After 200 steps of size h, from many small ones of an accurate method.
template <class Stepper>
double error(Stepper stepper, double h) {
    constexpr int parts = 64;
    constexpr int steps = 200;
    Gauss4<Perturbed> accurate;
    State x = start;
    State y = start;
    for (int step = 0; step < steps; ++step) {
        REQUIRE(stepper.step(x, h).ok());
        for (int part = 0; part < parts; ++part) { REQUIRE(accurate.step(y, h / parts).ok()); }
    }
    return std::hypot(x.q[0] - y.q[0], x.p[0] - y.p[0]);
}

template <class Stepper>
void check_refused(Stepper stepper, Code code) {
    State x = start;
    CHECK((stepper.status().code() == code));
    CHECK((stepper.step(x, 0.1).code() == code));
    CHECK(systems::same_bits(x, start));
    CHECK(stepper.coefficients().b[0] == 0.0);
}

}  // namespace

TEST_CASE("the constructor computes what --param computes") {
    using systems::Product;
    CHECK(distance(Gauss<Product>({}, 0.5), Half<Product>(), 0.1, 100) < 1e-14);
}

TEST_CASE("for w = 0 the basis is that of polynomials") {
    // 1, tau, cos, sin tend to cubic polynomials: the closed Newton-Cotes rule of four nodes.
    const WithLine<systems::Product> stepper({}, 0.0);
    REQUIRE(stepper.status().ok());
    const auto& found = stepper.coefficients();
    for (const int j : {0, 1, 2, 3}) { CHECK(found.b[j] == (j % 3 == 0 ? 0.125 : 0.375)); }
    // a_2,2 = 19/72 and a_2,3 = -5/72 of that rule.
    CHECK(found.m[1][1] * found.b[1] == Approx(19.0 / 72).epsilon(1e-15));
    CHECK(found.m[1][2] * found.b[2] == Approx(-5.0 / 72).epsilon(1e-15));
    // 1, cos, sin at Gauss' nodes tend to the Runge-Kutta method of Gauss.
    using systems::Product;
    CHECK(distance(Gauss<Product>({}, 0.0), Gauss3<Product>(), 0.1, 100) < 1e-13);
}

TEST_CASE("where there is no method, there is no step, and the state keeps its bits") {
    const double pi = std::acos(-1.0);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    using systems::Product;
    for (const int k : {-2, -1, 1, 2, 3}) {
        check_refused(WithLine<Product>({}, 3 * pi * k), Code::pole);
    }
    // tan(w/2) = w/2.
    check_refused(Trigonometric<Product>({}, 8.986818915818128), Code::zero_weight);
    check_refused(Trigonometric<Product>({}, nan), Code::not_finite);
    check_refused(Trigonometric<Product>({}, 1e300), Code::parameter_too_large);
    State x = start;
    CHECK((CosineSeparable<systems::SeparableOscillator>({}, 2 * pi).step(x, 0.1).code() ==
           Code::pole));
    CHECK(systems::same_bits(x, start));
}

TEST_CASE("a step back undoes a step", "[back]") {
    for (const double w : {0.0, 1e-9, 0.7, -2.5, 7.0}) {
        CAPTURE(w);
        Gauss<systems::Product> stepper({}, w);
        State x = start;
        REQUIRE(stepper.step(x, 0.05).ok());
        REQUIRE(stepper.step(x, -0.05).ok());
        CHECK(std::abs(x.q[0] - start.q[0]) < 1e-15);
        CHECK(std::abs(x.p[0] - start.p[0]) < 1e-15);
    }
}

TEST_CASE("the map of the oscillator has the determinant 1 for every w") {
    for (const double w : {0.0, 1e-7, 0.3, 1.0, 2.0, -5.0, 7.5, 100.0}) {
        CAPTURE(w);
        State a{{1.0}, {0.0}};
        State b{{0.0}, {1.0}};
        WithLine<systems::Oscillator, hvi::Newton> stepper({}, w);
        REQUIRE(stepper.step(a, 0.4).ok());
        REQUIRE(stepper.step(b, 0.4).ok());
        CHECK(std::abs(a.q[0] * b.p[0] - a.p[0] * b.q[0] - 1.0) < 4e-16);
    }
}

TEST_CASE("the stepper for separable systems takes the same steps") {
    using systems::SeparableOscillator;
    for (const double w : {0.0, 1.0, -4.0}) {
        CAPTURE(w);
        using General = systems::AsGeneral<SeparableOscillator>;
        CHECK(distance(WithLineSeparable<SeparableOscillator>({}, w), WithLine<General>({}, w), 0.1,
                       100) < 1e-14);
        CHECK(distance(WithLine<General, hvi::Newton>({}, w), WithLine<General>({}, w), 0.1, 100) <
              1e-14);
    }
}

TEST_CASE("an explicit stepper takes its weights from the parameter") {
    using Stepper = CosineSeparable<systems::SeparableOscillator>;
    // b_1 + b_2 = 1 and b_1 + b_2 cos(w) = sin(w)/w.
    for (const double w : {1e-3, 0.5, 3.0, 5.0}) {
        CAPTURE(w);
        const Stepper stepper({}, w);
        REQUIRE(stepper.status().ok());
        const auto& found = stepper.coefficients();
        CHECK(found.b_p[0] + found.b_p[1] == Approx(1.0).epsilon(1e-15));
        CHECK(found.b_p[1] == Approx((1 - std::sin(w) / w) / (1 - std::cos(w))).epsilon(1e-9));
        CHECK(found.b_q[0] == 1.0);
    }
    State x = start;
    REQUIRE(Stepper({}, 1.5).step(x, 0.1).ok());
    const double b_2 = (1 - std::sin(1.5) / 1.5) / (1 - std::cos(1.5));
    const double p = start.p[0] - 0.1 * (1 - b_2) * start.q[0];
    const double q = start.q[0] + 0.1 * p;
    CHECK(x.q[0] == Approx(q).epsilon(1e-15));
    CHECK(x.p[0] == Approx(p - 0.1 * b_2 * q).epsilon(1e-15));
    State y = start;
    REQUIRE(step_in_second_unit(y, 1.5, 0.1).ok());
    CHECK(systems::same_bits(x, y));
}

TEST_CASE("fitted to its frequency, large steps of an oscillator stay accurate") {
    for (const double h : {0.25, 0.5, 1.0}) {
        CAPTURE(h);
        CHECK(error(Gauss<Perturbed>({}, h), h) < error(Gauss3<Perturbed>(), h) / 30);
    }
}

// Flows of parts that are the whole H, beside their closed forms.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>

#include <catch2/catch.hpp>

#include "flows/form.hpp"
#include "flows/kerr.hpp"
#include "flows/manakov.hpp"
#include "flows/oscillator.hpp"
#include "flows/spin.hpp"

namespace {

using hvi::generated::Form;
using hvi::generated::Kerr;
using hvi::generated::Manakov;
using hvi::generated::Spin;

using Real = long double;

Real wide(double number) { return static_cast<Real>(number); }

/// Returns the flow of (a q^2 + b p^2)/2 + c q p over a time, by the matrix exponential: with X^2 =
/// -w^2 1 it is cos(w t) 1 + sin(w t)/w X. Complex numbers take w^2 of any sign.
std::array<double, 2> exact(const Form::Parameters& of, std::array<double, 2> x, double t) {
    const Real a = wide(of.a), b = wide(of.b), c = wide(of.c), time = wide(t);
    const std::complex<Real> w = std::sqrt(std::complex<Real>(a * b - c * c));
    const Real cosine = std::cos(w * time).real();
    const Real sine = std::abs(w) < 1e-10L ? time : (std::sin(w * time) / w).real();
    const Real q = wide(x[0]), p = wide(x[1]);
    return {static_cast<double>(cosine * q + sine * (c * q + b * p)),
            static_cast<double>(cosine * p - sine * (a * q + c * p))};
}

Form::Parameters parameters(double a, double b, double c) {
    Form::Parameters result;
    result.a = a;
    result.b = b;
    result.c = c;
    return result;
}

}  // namespace

TEST_CASE("the flow of a quadratic form is that of its matrix, for all signs and lengths") {
    const std::array<Form::Parameters, 8> all{parameters(2, 3, 0.5),   parameters(1, 1, 0),
                                              parameters(-2, 3, 0.5),  parameters(1, 4, 2),
                                              parameters(0, 1, 0),     parameters(1e-9, 2, 0),
                                              parameters(2, -3, 0.25), parameters(3, 2, -1)};
    for (const Form::Parameters& of : all) {
        Form stepper(of);
        for (const double h : {0.01, 0.5, -0.5, 1.2825498301618641, 3.0, -7.0}) {
            auto x = Form::initial(of);
            const auto expected = exact(of, {x.q[0], x.p[0]}, h);
            REQUIRE(stepper.step(x, h).ok());
            const double size = std::max({1.0, std::abs(expected[0]), std::abs(expected[1])});
            CAPTURE(of.a, of.b, of.c, h);
            CHECK(std::abs(x.q[0] - expected[0]) <= 2e-14 * size);
            CHECK(std::abs(x.p[0] - expected[1]) <= 2e-14 * size);
        }
    }
}

TEST_CASE("a form without a product takes zeros for its parameters") {
    using hvi::generated::Oscillator;
    for (const auto& [a, b] : {std::array{2.0, 0.0}, {0.0, 3.0}, {0.0, 0.0}}) {
        Oscillator::Parameters of;
        of.a = a;
        of.b = b;
        Oscillator stepper(of);
        auto x = Oscillator::initial(of);
        REQUIRE(stepper.step(x, 0.75).ok());
        CAPTURE(a, b);
        CHECK(std::abs(x.q[0] - (1 - 0.375 * b)) <= 1e-15);
        CHECK(std::abs(x.p[0] - (-0.5 - 0.75 * a)) <= 1e-15);
    }
}

TEST_CASE("a rotation by pi, where its shears end, is taken") {
    const Form::Parameters of = parameters(1, 1, 0);
    Form stepper(of);
    const double pi = std::acos(-1.0);
    for (const double h : {pi, -pi, pi / 2, 3 * pi, 2 * pi}) {
        auto x = Form::initial(of);
        const auto expected = exact(of, {x.q[0], x.p[0]}, h);
        REQUIRE(stepper.step(x, h).ok());
        CHECK(std::abs(x.q[0] - expected[0]) <= 1e-14);
        CHECK(std::abs(x.p[0] - expected[1]) <= 1e-14);
    }
}

TEST_CASE("a quadratic form keeps its energy over a million steps") {
    const Form::Parameters of = parameters(2, 3, 0.5);
    Form stepper(of);
    auto x = Form::initial(of);
    const double before = stepper.energy(x);
    for (int k = 0; k < 1'000'000; ++k) { REQUIRE(stepper.step(x, 0.3).ok()); }
    CHECK(std::abs(stepper.energy(x) - before) <= 2e-13 * before);
}

TEST_CASE("a function of a quadratic form turns with the speed of its derivative") {
    for (const double g : {0.7, -2.0, 0.0}) {
        Kerr::Parameters of;
        of.g = g;
        Kerr stepper(of);
        for (const double h : {0.1, -0.4, 2.0, 20.0}) {
            auto x = Kerr::initial(of);
            const Real q = wide(x.q[0]), p = wide(x.p[0]), square = q * q + p * p;
            const Real angle = (wide(of.g) * square * square - 1) * wide(h);
            const auto c = static_cast<double>(std::cos(angle));
            const auto s = static_cast<double>(std::sin(angle));
            const double q_0 = x.q[0], p_0 = x.p[0];
            REQUIRE(stepper.step(x, h).ok());
            CAPTURE(g, h);
            CHECK(std::abs(x.q[0] - (c * q_0 + s * p_0)) <= 1e-14);
            CHECK(std::abs(x.p[0] - (c * p_0 - s * q_0)) <= 1e-14);
        }
    }
}

TEST_CASE("a function of a sum of quadratic forms turns all of them with one speed") {
    const Form::Parameters plane_x = parameters(1, 1, 0);
    for (const double b : {0.5, -0.5, 2.0 / 9}) {
        Manakov::Parameters of;
        of.b = b;
        Manakov stepper(of);
        const Form::Parameters plane_y = parameters(of.a, of.b, of.c);
        for (const double h : {0.1, -0.4, 2.0, 20.0}) {
            auto at = Manakov::initial(of);
            const double x = at.q[0], y = at.q[1], px = at.p[0], py = at.p[1];
            const double Q =
                (x * x + px * px + of.a * y * y + 2 * of.c * y * py + of.b * py * py) / 2;
            const double time = (3 * of.g * Q * Q - 1) * h;
            const auto in_x = exact(plane_x, {x, px}, time), in_y = exact(plane_y, {y, py}, time);
            REQUIRE(stepper.step(at, h).ok());
            CAPTURE(b, h);
            CHECK(std::abs(at.q[0] - in_x[0]) <= 1e-13);
            CHECK(std::abs(at.p[0] - in_x[1]) <= 1e-13);
            const double size = std::max({1.0, std::abs(in_y[0]), std::abs(in_y[1])});
            CHECK(std::abs(at.q[1] - in_y[0]) <= 1e-13 * size);
            CHECK(std::abs(at.p[1] - in_y[1]) <= 1e-13 * size);
        }
    }
}

TEST_CASE("a function of one component of the angular momentum turns the body") {
    const Spin::Parameters of;
    Spin stepper(of);
    for (const double h : {0.25, -1.0, 3.0, 30.0}) {
        auto x = Spin::initial(of);
        const auto before = x;
        const Real L = wide(before.L[1]);
        const Real angle = (L / 2 + 4 * L * L * L / 5) * wide(h);
        const auto c = static_cast<double>(std::cos(angle)),
                   s = static_cast<double>(std::sin(angle));
        REQUIRE(stepper.step(x, h).ok());
        CAPTURE(h);
        // NOTE: R' = R exp(angle hat(e_2)), and L' = L x e_2 times the speed.
        for (std::size_t row = 0; row < 3; ++row) {
            const double R_1 = before.R[3 * row], R_2 = before.R[3 * row + 1];
            const double R_3 = before.R[3 * row + 2];
            CHECK(std::abs(x.R[3 * row] - (c * R_1 - s * R_3)) <= 1e-14);
            CHECK(x.R[3 * row + 1] == R_2);
            CHECK(std::abs(x.R[3 * row + 2] - (s * R_1 + c * R_3)) <= 1e-14);
        }
        CHECK(std::abs(x.L[0] - (c * before.L[0] - s * before.L[2])) <= 1e-14);
        CHECK(x.L[1] == before.L[1]);
        CHECK(std::abs(x.L[2] - (s * before.L[0] + c * before.L[2])) <= 1e-14);
    }
}

TEST_CASE("a step of flows that fails leaves the state") {
    Kerr stepper;
    auto x = Kerr::initial();
    x.q[0] = 1e200;
    const auto before = x;
    const hvi::Status status = stepper.step(x, 0.1);
    CHECK(status.code() == hvi::Status::Code::not_finite);
    CHECK(x.q == before.q);
    CHECK(x.p == before.p);
    CHECK_FALSE(stepper.step(x, std::numeric_limits<double>::infinity()).ok());
    CHECK(x.q == before.q);
    REQUIRE(stepper.step(x, 0).ok());
    CHECK(x.q == before.q);
}

TEST_CASE("a stepper of flows forgets, and takes a state of the user's as a fresh one does") {
    Kerr used, fresh;
    auto x = Kerr::initial();
    for (int k = 0; k < 5; ++k) { REQUIRE(used.step(x, 0.1).ok()); }
    auto y = x;
    y.q[0] += 0.25;
    auto z = y;
    REQUIRE(used.step(y, 0.1).ok());
    REQUIRE(fresh.step(z, 0.1).ok());
    CHECK(y.q == z.q);
    CHECK(y.p == z.p);
}

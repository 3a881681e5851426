// Flows of quadratic forms that couple degrees of freedom, beside their closed forms.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/detail/stages/form_flow.hpp>

#include "flows/general.hpp"
#include "flows/penning.hpp"
#include "flows/squeeze.hpp"
#include "flows/triangle.hpp"
#include "flows/turning.hpp"

namespace {

using hvi::generated::General;
using hvi::generated::Penning;
using hvi::generated::Squeeze;
using hvi::generated::Triangle;
using hvi::generated::Turning;

using Real = long double;
using Complex = std::complex<Real>;

Real wide(double number) { return static_cast<Real>(number); }

double size_of(const std::vector<Real>& numbers) {
    Real size = 0;
    for (const Real number : numbers) { size = std::max(size, std::abs(number)); }
    return static_cast<double>(size);
}

/// Returns the distance from what is expected of q and of p after that, beside its size.
template <class State>
double error_of(const State& x, const std::vector<Real>& expected) {
    Real error = 0;
    for (std::size_t k = 0; k < expected.size(); ++k) {
        const double number = k < x.q.size() ? x.q[k] : x.p[k - x.q.size()];
        error = std::max(error, std::abs(wide(number) - expected[k]));
    }
    return static_cast<double>(error) / size_of(expected);
}

// ---- charges in fields ----

Penning::Parameters trap(double m, double b, double k, double f) {
    Penning::Parameters result;
    result.m = m;
    result.b = b;
    result.k = k;
    result.f = f;
    return result;
}

/// Returns the state after a time. For u = x + i y the motion is m u'' = -i b u' + k u/2 + f, and
/// m z'' = -k z.
std::vector<Real> exact(const Penning::Parameters& of, const Penning::State& at, double time) {
    const Real m = wide(of.m), b = wide(of.b), k = wide(of.k), f = wide(of.f), t = wide(time);
    const Real x = wide(at.q[0]), y = wide(at.q[1]), z = wide(at.q[2]), pz = wide(at.p[2]);
    const Complex i(0, 1), u(x, y);
    const Complex v(wide(at.p[0]) / m + b * y / (2 * m), wide(at.p[1]) / m - b * x / (2 * m));
    const Complex root = std::sqrt(Complex(2 * k / m - b * b / (m * m)));
    const Complex first = (-i * b / m + root) / Real(2), second = (-i * b / m - root) / Real(2);
    // u(t) = rest + drift t + A exp(first t) + B exp(second t).
    const Complex rest = k == 0 ? Complex(0) : Complex(-2 * f / k);
    const Complex drift = k == 0 && f != 0 ? f / (i * b) : Complex(0);
    const Complex B = (first * (u - rest) - (v - drift)) / (first - second), A = u - rest - B;
    const Complex exp_1 = std::exp(first * t), exp_2 = std::exp(second * t);
    const Complex u_t = rest + drift * t + A * exp_1 + B * exp_2;
    const Complex v_t = drift + A * first * exp_1 + B * second * exp_2;
    const Complex w = std::sqrt(Complex(k / m));
    const Real cosine = std::cos(w * t).real();
    const Real sine = k == 0 ? t : (std::sin(w * t) / w).real();
    return {u_t.real(),
            u_t.imag(),
            cosine * z + sine * pz / m,
            m * v_t.real() - b * u_t.imag() / 2,
            m * v_t.imag() + b * u_t.real() / 2,
            cosine * pz - sine * k * z};
}

}  // namespace

TEST_CASE("a charge in fields moves as the closed form says, for short and long times") {
    const double pi = std::acos(-1.0);
    // NOTE: numbers in these are exact, so that a long time loses nothing but its own rounding.
    for (const auto& of : {trap(1, 2, 0, 0), trap(1, 2, 0, 0.5), trap(0.5, -4, 0.25, 0.5),
                           trap(2, 8, 1, 0), trap(1, 2, -3, 1), trap(1, 1, 8, 0)}) {
        Penning stepper(of);
        for (const double h : {1e-6, 0.01, 0.5, -0.5, pi / 2, pi, 3.0, -7.0}) {
            auto x = Penning::initial(of);
            const std::vector<Real> expected = exact(of, x, h);
            REQUIRE(stepper.step(x, h).ok());
            CAPTURE(of.m, of.b, of.k, of.f, h);
            CHECK(error_of(x, expected) <= 2e-15);
        }
    }
}

TEST_CASE("a time of many thousand turns costs no digits") {
    const auto of = trap(1, 2, 0, 0);
    Penning stepper(of);
    for (const double h : {1e3, 12345.678, -1e6}) {
        auto x = Penning::initial(of);
        const std::vector<Real> expected = exact(of, x, h);
        REQUIRE(stepper.step(x, h).ok());
        CAPTURE(h);
        CHECK(error_of(x, expected) <= 1e-15);
    }
}

TEST_CASE("a proton is stepped in units of the user's") {
    const auto of = trap(1.67262192e-27, 9.6e-19, 3.2e-14, 1.6e-16);
    Penning stepper(of);
    Penning::State x;
    x.q = {1e-4, -2e-4, 5e-5};
    x.p = {1e-23, 3e-23, -2e-23};
    for (const double h : {1e-12, 1e-9, 3e-7}) {
        auto y = x;
        const std::vector<Real> expected = exact(of, x, h);
        REQUIRE(stepper.step(y, h).ok());
        CAPTURE(h);
        for (std::size_t k = 0; k < 3; ++k) {
            CHECK(std::abs(wide(y.q[k]) - expected[k]) <= 2e-13L * 2e-4L);
            CHECK(std::abs(wide(y.p[k]) - expected[k + 3]) <= 2e-13L * 1e-22L);
        }
    }
}

TEST_CASE("the energy in fields has no drift over a million steps") {
    for (const double b : {2.0, 1.7}) {
        const auto of = trap(1, b, 0.25, 0);
        Penning stepper(of);
        auto x = Penning::initial(of);
        const double before = stepper.energy(x);
        for (int k = 0; k < 1'000'000; ++k) { REQUIRE(stepper.step(x, 0.3).ok()); }
        CAPTURE(b);
        CHECK(std::abs(stepper.energy(x) - before) <= 3e-13 * std::abs(before));
    }
}

// NOTE: of 150 forms that were tried this one had the largest drift, 7e-18 of the energy a step,
// where products with the matrix were summed without what that cuts off.
TEST_CASE("the energy of a form with all terms has no drift over a million steps") {
    General::Parameters of;
    of.s11 = 61.0 / 64, of.s12 = -19.0 / 64, of.s13 = -21.0 / 64, of.s14 = 25.0 / 64;
    of.s22 = 82.0 / 64, of.s23 = 11.0 / 64, of.s24 = -62.0 / 64;
    of.s33 = 42.0 / 64, of.s34 = -14.0 / 64, of.s44 = 79.0 / 64;
    of.l1 = of.l2 = of.l3 = of.l4 = 0;
    General stepper(of);
    auto x = General::initial(of);
    const double before = stepper.energy(x);
    for (int k = 0; k < 1'000'000; ++k) { REQUIRE(stepper.step(x, 1.5).ok()); }
    CHECK(std::abs(stepper.energy(x) - before) <= 6e-13 * before);
}

TEST_CASE("steps in fields lead back") {
    const auto of = trap(1, 1.7, 0.3, 0.2);
    Penning stepper(of);
    auto x = Penning::initial(of);
    const auto before = x;
    for (int k = 0; k < 100; ++k) { REQUIRE(stepper.step(x, 0.7).ok()); }
    for (int k = 0; k < 100; ++k) { REQUIRE(stepper.step(x, -0.7).ok()); }
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(std::abs(x.q[k] - before.q[k]) <= 1e-14);
        CHECK(std::abs(x.p[k] - before.p[k]) <= 1e-14);
    }
}

TEST_CASE("three masses with springs swing about their centre, which moves on") {
    Triangle::Parameters of;
    of.m = 2;
    of.k = 0.75;
    Triangle stepper(of);
    for (const double h : {1e-5, 0.25, -3.0, 40.0, 1e4}) {
        auto x = Triangle::initial(of);
        const Real m = wide(of.m), t = wide(h), w = std::sqrt(3 * wide(of.k) / m);
        const Real cosine = std::cos(w * t), sine = std::sin(w * t);
        const Real centre = (wide(x.q[0]) + wide(x.q[1]) + wide(x.q[2])) / 3;
        const Real p = (wide(x.p[0]) + wide(x.p[1]) + wide(x.p[2])) / 3;
        std::vector<Real> expected(6);
        for (std::size_t k = 0; k < 3; ++k) {
            const Real q_k = wide(x.q[k]) - centre, p_k = wide(x.p[k]) - p;
            expected[k] = centre + p * t / m + cosine * q_k + sine * p_k / (m * w);
            expected[k + 3] = p + cosine * p_k - sine * m * w * q_k;
        }
        REQUIRE(stepper.step(x, h).ok());
        CAPTURE(h);
        CHECK(error_of(x, expected) <= 1e-15);
    }
}

TEST_CASE("a frame turns, though q moves by q alone and p by p") {
    Turning::Parameters of;
    for (const double w : {1.0, -0.375, 0.0}) {
        of.w = w;
        Turning stepper(of);
        for (const double h : {1e-4, 0.5, std::acos(-1.0), 1e5}) {
            auto x = Turning::initial(of);
            const Real c = std::cos(wide(w) * wide(h)), s = std::sin(wide(w) * wide(h));
            const std::vector<Real> expected{
                c * wide(x.q[0]) - s * wide(x.q[1]), s * wide(x.q[0]) + c * wide(x.q[1]),
                c * wide(x.p[0]) - s * wide(x.p[1]), s * wide(x.p[0]) + c * wide(x.p[1])};
            REQUIRE(stepper.step(x, h).ok());
            CAPTURE(w, h);
            CHECK(error_of(x, expected) <= 1e-15);
        }
    }
}

TEST_CASE("a product q p stretches one and presses the other, with linear terms or without") {
    Squeeze::Parameters of;
    for (const double a : {1.0, -0.5, 0.0}) {
        of.a = a;
        Squeeze stepper(of);
        for (const double h : {1e-4, 0.5, -2.0, 10.0}) {
            auto x = Squeeze::initial(of);
            const Real t = wide(h), a_t = wide(a) * t, b = wide(of.b), c = wide(of.c);
            const Real grown = a == 0 ? t : std::expm1(a_t) / wide(a);
            const Real shrunk = a == 0 ? t : -std::expm1(-a_t) / wide(a);
            const std::vector<Real> expected{std::exp(a_t) * wide(x.q[0]) + c * grown,
                                             std::exp(-a_t) * wide(x.p[0]) - b * shrunk};
            REQUIRE(stepper.step(x, h).ok());
            CAPTURE(a, h);
            CHECK(std::abs(wide(x.q[0]) - expected[0]) <= 1e-15L * (1 + std::abs(expected[0])));
            CHECK(std::abs(wide(x.p[0]) - expected[1]) <= 1e-15L * (1 + std::abs(expected[1])));
        }
    }
}

TEST_CASE("a form with all terms is stepped by the exponential of its matrix") {
    // exp(h (J S, J l; 0 0)) (z, 1), computed by mpmath with 60 digits.
    const std::array<std::pair<double, std::vector<Real>>, 4> all{
        {{0.0625,
          {1.0612210159074885287L, -0.51818583655986623025L, 0.67027551283306022813L,
           0.055387238959291694138L}},
         {1.0,
          {0.83388144793319311249L, -0.98256969142642980876L, -0.8467178988990878703L,
           -0.64607359637178420569L}},
         {-1.0,
          {-0.042241265459463454994L, -1.0468492344851782526L, 0.74145812343865186619L,
           1.3447963242178234434L}},
         {6.0,
          {7.590207762734259607L, 13.84618605159443536L, -3.5310205538737063331L,
           13.737252171554356569L}}}};
    General stepper;
    for (const auto& [h, expected] : all) {
        auto x = General::initial();
        REQUIRE(stepper.step(x, h).ok());
        CAPTURE(h);
        CHECK(error_of(x, expected) <= 2e-15);
    }
}

TEST_CASE(
    "a time that is not finite, or that grows beyond all numbers, fails and leaves the state") {
    Squeeze stepper;
    auto x = Squeeze::initial();
    const auto before = x;
    CHECK_FALSE(stepper.step(x, 1e4).ok());
    CHECK_FALSE(stepper.step(x, 1e300).ok());
    CHECK(x.q == before.q);
    CHECK(x.p == before.p);
    REQUIRE(stepper.step(x, 1e-3).ok());
}

TEST_CASE("the matrix of a form is symplectic to twice the digits") {
    constexpr std::size_t n = 2, size = 2 * n;
    const std::array<double, 14> form{1.3, 0.5,  0.1, -1,   0.25, -0.7, 0.6,
                                      0.2, -0.5, 1.5, -0.3, 1,    2,    0.75};
    using Number = hvi::detail::Pair<double>;
    const hvi::detail::FormFlow<double, n> flow(3.7, form);
    std::array<std::array<Number, size>, size> M{};
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j < size; ++j) {
            M[i][j] = flow.entry(i, j) + Number{i == j ? 1.0 : 0.0};
        }
    }
    for (std::size_t j = 0; j < size; ++j) {
        for (std::size_t k = 0; k < size; ++k) {
            Number bracket{};
            for (std::size_t i = 0; i < n; ++i) {
                bracket = bracket + M[i][j] * M[i + n][k] - M[i + n][j] * M[i][k];
            }
            const double expected = k == j + n ? 1 : (j == k + n ? -1 : 0);
            CAPTURE(j, k);
            CHECK(std::abs((bracket - Number{expected}).hi) <= 1e-28);
        }
    }
}

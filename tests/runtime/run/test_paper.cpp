// Section 6 of the paper, with the shipped headers.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/generated/chebyshev_3.hpp>
#include <hvi/generated/gauss_2.hpp>
#include <hvi/generated/gauss_2_separable.hpp>
#include <hvi/newton.hpp>

#include "systems.hpp"

using namespace hvi::generated;
using State = hvi::State<systems::One>;

namespace {

template <class Stepper>
State one_step(Stepper stepper, State x, double h) {
    REQUIRE(stepper.step(x, h).ok());
    return x;
}

template <class Stepper>
State run(Stepper stepper, State x, double h, int steps) {
    for (int i = 0; i < steps; ++i) { REQUIRE(stepper.step(x, h).ok()); }
    return x;
}

/// The slope of the least-squares line through (log h, log error) for h = 3/5, 3/10, ..., 3/160.
template <class Stepper>
double slope(const Stepper& stepper, const State& start, double exact,
             double (*value)(const State&)) {
    std::vector<double> u, v;
    for (int n = 5; n <= 160; n *= 2) {
        u.push_back(std::log(3.0 / n));
        v.push_back(std::log(std::abs(value(run(stepper, start, 3.0 / n, n)) - exact)));
    }
    double mean_u = 0.0, mean_v = 0.0, uv = 0.0, uu = 0.0;
    for (std::size_t i = 0; i < u.size(); ++i) {
        mean_u += u[i] / static_cast<double>(u.size());
        mean_v += v[i] / static_cast<double>(v.size());
    }
    for (std::size_t i = 0; i < u.size(); ++i) {
        uv += (u[i] - mean_u) * (v[i] - mean_v);
        uu += (u[i] - mean_u) * (u[i] - mean_u);
    }
    return uv / uu;
}

double q_of(const State& x) { return x.q[0]; }
double p_of(const State& x) { return x.p[0]; }

/// A sum of two terms that may cancel: to a few units in the last place of the larger one.
void check_row(double value, double first, double second) {
    CHECK(std::abs(value - (first + second)) <= 4 * 0x1p-52 * (std::abs(first) + std::abs(second)));
}

const std::vector<double> step_sizes{0.5, 0.4, 0.3, 0.1, 0.01, -0.01, -0.25, -0.5};

}  // namespace

TEST_CASE("Cheby4 on H = q p is (6.2)") {
    for (const double h : step_sizes) {
        const double R = -(((h + 10) * h + 48) * h + 96) / (((h - 10) * h + 48) * h - 96);
        const State x = one_step(Chebyshev3<systems::Dilation>{}, {{2.0}, {2.0}}, h);
        CHECK(systems::ulps(x.q[0], 2.0 * R) <= 4);
        CHECK(systems::ulps(x.p[0], 2.0 / R) <= 4);
    }
}

TEST_CASE("GauLe4 on H = q p is (6.3)") {
    for (const double h : step_sizes) {
        const double R = ((h + 6) * h + 12) / ((h - 6) * h + 12);
        const State x = one_step(Gauss2<systems::Dilation>{}, {{2.0}, {2.0}}, h);
        CHECK(systems::ulps(x.q[0], 2.0 * R) <= 4);
        CHECK(systems::ulps(x.p[0], 2.0 / R) <= 4);
    }
}

TEMPLATE_TEST_CASE("Cheby4 on the oscillator is (6.5)", "", hvi::FixedPoint, hvi::Newton) {
    for (const double h : step_sizes) {
        const double w = 1.25;
        const double z2 = h * h * w * w;
        const double D = ((z2 - 12) * z2 + 288) * z2 + 9216;
        const double diagonal = (((-z2 + 228) * z2 - 4320) * z2 + 9216) / D;
        const double qp = h * ((36 * z2 - 1248) * z2 + 9216) / D;
        const double pq = h * w * w * ((-12 * z2 + 1248) * z2 - 9216) / D;
        const State x = one_step(Chebyshev3<systems::Oscillator, TestType>{systems::Oscillator{w}},
                                 {{2.0}, {1.0}}, h);
        check_row(x.q[0], 2.0 * diagonal, qp);
        check_row(x.p[0], 2.0 * pq, diagonal);
    }
}

TEMPLATE_TEST_CASE("GauLe4 on the oscillator is (6.6)", "", hvi::FixedPoint, hvi::Newton) {
    for (const double h : step_sizes) {
        const double w = 1.25;
        const double z2 = h * h * w * w;
        const double D = (z2 + 12) * z2 + 144;
        const double diagonal = ((z2 - 60) * z2 + 144) / D;
        const double qp = h * (-12 * z2 + 144) / D;
        const double pq = -w * w * qp;
        const State start{{2.0}, {1.0}};
        const State x =
            one_step(Gauss2<systems::Oscillator, TestType>{systems::Oscillator{w}}, start, h);
        check_row(x.q[0], 2.0 * diagonal, qp);
        check_row(x.p[0], 2.0 * pq, diagonal);
        const State y = one_step(
            Gauss2Separable<systems::SeparableOscillator, TestType>{
                systems::SeparableOscillator{w}},
            start, h);
        check_row(y.q[0], 2.0 * diagonal, qp);
        check_row(y.p[0], 2.0 * pq, diagonal);
    }
}

TEST_CASE("Figure 2: both methods are of order 4 on H = q p") {
    const State start{{2.0}, {2.0}};
    const double q = 2.0 * std::exp(3.0);
    const double p = 2.0 * std::exp(-3.0);
    const Chebyshev3<systems::Dilation> cheby;
    const Gauss2<systems::Dilation> gauss;
    CHECK(slope(cheby, start, q, q_of) == Approx(4.0064).margin(2e-3));
    CHECK(slope(cheby, start, p, p_of) == Approx(4.0064).margin(2e-3));
    CHECK(slope(gauss, start, q, q_of) == Approx(4.0050).margin(2e-3));
    CHECK(slope(gauss, start, p, p_of) == Approx(4.0051).margin(2e-3));
}

TEST_CASE("Figure 5: both methods are of order 4 on the oscillator") {
    const State start{{2.0}, {1.0}};
    const double q = 2.0 * std::cos(3.0) + std::sin(3.0);
    const double p = std::cos(3.0) - 2.0 * std::sin(3.0);
    const Chebyshev3<systems::Oscillator> cheby;
    const Gauss2<systems::Oscillator> gauss;
    CHECK(slope(cheby, start, q, q_of) == Approx(3.9968).margin(2e-3));
    CHECK(slope(cheby, start, p, p_of) == Approx(3.9988).margin(2e-3));
    CHECK(slope(gauss, start, q, q_of) == Approx(3.9949).margin(2e-3));
    CHECK(slope(gauss, start, p, p_of) == Approx(3.9948).margin(2e-3));
}

TEST_CASE("Figure 3: errors of q grow with exp(t) by truncation, those of Cheby4 a fourth") {
    const double h = 0.4;
    // (6.2) and (6.3) multiply q by R and p by 1/R.
    const double R_cheby = -(((h + 10) * h + 48) * h + 96) / (((h - 10) * h + 48) * h - 96);
    const double R_gauss = ((h + 6) * h + 12) / ((h - 6) * h + 12);
    Chebyshev3<systems::Dilation> cheby;
    Gauss2<systems::Dilation> gauss;
    State x{{2.0}, {2.0}};
    State y = x;
    for (int n = 1; n <= 50; ++n) {
        CAPTURE(n);
        REQUIRE(cheby.step(x, h).ok());
        REQUIRE(gauss.step(y, h).ok());
        const double t = n * h;
        // Rounding of a few units in the last place a step, of 2 exp(t) and of 2 exp(-t).
        const double rounding = 4 * n * 0x1p-52;
        const auto error = [&](const State& state) { return state.q[0] / (2 * std::exp(t)) - 1; };
        const auto error_p = [&](const State& state) { return state.p[0] * std::exp(t) / 2 - 1; };
        CHECK(std::abs(error(x) - std::expm1(n * (std::log(R_cheby) - h))) < rounding);
        CHECK(std::abs(error_p(x) - std::expm1(-n * (std::log(R_cheby) - h))) < rounding);
        CHECK(std::abs(error(y) - std::expm1(n * (std::log(R_gauss) - h))) < rounding);
        CHECK(std::abs(error_p(y) - std::expm1(-n * (std::log(R_gauss) - h))) < rounding);
        // R = e^h (1 + h^5/2880 + ...) and e^h (1 - h^5/720 + ...): what is left is of size h^2.
        CHECK(error(y) / error(x) == Approx(-4).epsilon(0.02));
        CHECK(error_p(y) / error_p(x) == Approx(-4).epsilon(0.02));
    }
}

TEST_CASE("Figure 4: both methods keep q p") {
    Chebyshev3<systems::Dilation> cheby;
    Gauss2<systems::Dilation> gauss;
    State x{{2.0}, {2.0}};
    State y = x;
    for (int i = 0; i < 1000; ++i) {
        REQUIRE(cheby.step(x, 0.4).ok());
        REQUIRE(gauss.step(y, 0.4).ok());
        REQUIRE(std::abs(x.q[0] * x.p[0] - 4.0) < 2e-13);
        REQUIRE(std::abs(y.q[0] * y.p[0] - 4.0) < 2e-13);
    }
}

TEST_CASE("Figure 6: errors on the oscillator are of its phase, those of Cheby4 nine sixteenths") {
    const double h = 0.5;
    const double z2 = h * h;
    const double D = ((z2 - 12) * z2 + 288) * z2 + 9216;
    // The traces and corners of (6.5) and (6.6): both have determinant 1 and one diagonal entry.
    const double angle_cheby = std::acos((((-z2 + 228) * z2 - 4320) * z2 + 9216) / D);
    const double corner = h * ((36 * z2 - 1248) * z2 + 9216) / D / std::sin(angle_cheby);
    const double angle_gauss = std::acos(((z2 - 60) * z2 + 144) / ((z2 + 12) * z2 + 144));
    Chebyshev3<systems::Oscillator> cheby;
    Gauss2<systems::Oscillator> gauss;
    State x{{2.0}, {1.0}};
    State y = x;
    double largest_cheby = 0.0, largest_gauss = 0.0;
    for (int n = 1; n <= 100; ++n) {
        CAPTURE(n);
        REQUIRE(cheby.step(x, h).ok());
        REQUIRE(gauss.step(y, h).ok());
        const double a = n * angle_cheby;
        const double b = n * angle_gauss;
        const double bound = 8 * n * 0x1p-52;
        CHECK(std::abs(x.q[0] - (2 * std::cos(a) + corner * std::sin(a))) < bound);
        CHECK(std::abs(x.p[0] - (std::cos(a) - 2 / corner * std::sin(a))) < bound);
        CHECK(std::abs(y.q[0] - (2 * std::cos(b) + std::sin(b))) < bound);
        CHECK(std::abs(y.p[0] - (std::cos(b) - 2 * std::sin(b))) < bound);
        const double exact = 2 * std::cos(n * h) + std::sin(n * h);
        largest_cheby = std::max(largest_cheby, std::abs(x.q[0] - exact));
        largest_gauss = std::max(largest_gauss, std::abs(y.q[0] - exact));
    }
    // The angles are h + h^5/1280 + ... and h - h^5/720 + ...: a ratio of 16/9.
    CHECK(largest_gauss / largest_cheby == Approx(16.0 / 9).epsilon(0.02));
}

TEST_CASE("Figure 7: the oscillator's energy, bounded with Cheby4, round-off with GauLe4") {
    Chebyshev3<systems::Oscillator> cheby;
    Gauss2<systems::Oscillator> gauss;
    State x{{2.0}, {1.0}};
    State y = x;
    double lowest = 0.0, highest = 0.0, gauss_error = 0.0;
    for (int i = 0; i < 10000; ++i) {
        REQUIRE(cheby.step(x, 0.5).ok());
        REQUIRE(gauss.step(y, 0.5).ok());
        const double error = (x.p[0] * x.p[0] + x.q[0] * x.q[0]) / 2 - 2.5;
        lowest = std::min(lowest, error);
        highest = std::max(highest, error);
        gauss_error =
            std::max(gauss_error, std::abs((y.p[0] * y.p[0] + y.q[0] * y.q[0]) / 2 - 2.5));
    }
    // The exact range is [-3.368421052631578946e-4, 8.422471153e-5].
    CHECK(lowest == Approx(-3.36842e-4).epsilon(1e-4));
    CHECK(highest == Approx(8.42247e-5).epsilon(1e-3));
    CHECK(gauss_error < 2e-14);
}

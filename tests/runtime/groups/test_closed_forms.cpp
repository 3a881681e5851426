// Bodies whose motion has a closed form, in Jacobi's elliptic functions.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <cstddef>

#include <groups/closed_free.hpp>
#include <groups/lagrange_4.hpp>

#include "tests/runtime/groups/groups.hpp"

using namespace hvi::generated;

namespace {

struct Elliptic {
    double sn, cn, dn;
};

/// Jacobi's functions of modulus k, by the arithmetic-geometric mean: Abramowitz & Stegun, 16.4.
Elliptic elliptic(double u, double k) {
    std::array<double, 12> a{1}, c{k};
    double b = std::sqrt(1 - k * k);
    std::size_t n = 0;
    while (std::abs(c[n]) > 1e-16 && n + 1 < a.size()) {
        a[n + 1] = (a[n] + b) / 2;
        c[n + 1] = (a[n] - b) / 2;
        b = std::sqrt(a[n] * b);
        ++n;
    }
    double phi = std::ldexp(a[n] * u, static_cast<int>(n)), next = phi;
    for (; n > 0; --n) {
        next = phi;
        phi = (phi + std::asin(c[n] / a[n] * std::sin(phi))) / 2;
    }
    static_cast<void>(next);
    const double sn = std::sin(phi);
    return {sn, std::cos(phi), std::sqrt(1 - k * k * sn * sn)};
}

/// The integral from 0 to t, by Boole's rule on so many parts.
template <class F>
double integral(F f, double t, int parts) {
    double sum = 0;
    const double h = t / parts;
    for (int i = 0; i < parts; ++i) {
        const double x = i * h;
        sum += h / 90 *
               (7 * f(x) + 32 * f(x + h / 4) + 12 * f(x + h / 2) + 32 * f(x + 3 * h / 4) +
                7 * f(x + h));
    }
    return sum;
}

/// Returns the distance of two angles modulo whole turns.
double apart(double a, double b) { return std::abs(std::remainder(a - b, 2 * std::acos(-1.0))); }

}  // namespace

TEST_CASE("Jacobi's functions solve their differential equations") {
    for (const double k : {0.1, 0.6, 0.95}) {
        for (const double u : {0.3, 1.7, 4.0}) {
            const auto [sn, cn, dn] = elliptic(u, k);
            CHECK(sn * sn + cn * cn == Approx(1));
            const double h = 1e-5;
            const double slope = (elliptic(u + h, k).sn - elliptic(u - h, k).sn) / (2 * h);
            CHECK(slope == Approx(cn * dn).margin(1e-8));
        }
    }
}

// Landau & Lifshitz, Mechanics, section 37, for M^2 > 2 E I_2, with moments I = 1, 2, 3.
TEST_CASE("a free body follows elliptic functions, and turns about its angular momentum") {
    const double M_squared = 1.25, two_E = 0.25 + 1.0 / 3, M = std::sqrt(M_squared);
    const double k = std::sqrt((2 - 1) * (two_E * 3 - M_squared) / ((3 - 2) * (M_squared - two_E)));
    const double rate = std::sqrt((3 - 2) * (M_squared - two_E) / 6);
    const auto L_at = [&](double t) {
        const auto [sn, cn, dn] = elliptic(rate * t, k);
        return std::array{std::sqrt((two_E * 3 - M_squared) / 2) * cn,
                          2 * std::sqrt((two_E * 3 - M_squared) / (2 * (3 - 2))) * sn,
                          3 * std::sqrt((M_squared - two_E) / (3 * 2)) * dn};
    };
    // The azimuth of the third axis about M: phi' = M (I_1 w_1^2 + I_2 w_2^2)/(L_1^2 + L_2^2).
    const auto precession = [&](double t) {
        const auto L = L_at(t);
        return M * (L[0] * L[0] + L[1] * L[1] / 2) / (L[0] * L[0] + L[1] * L[1]);
    };
    ClosedFree stepper;
    auto x = ClosedFree::initial();
    const std::array unit{0.5 / M, 0.0, 1 / M};  // along M, in space
    const std::array across{-unit[2], 0.0,
                            unit[0]};  // to the third axis at the start, but for sign
    const auto azimuth = [&](const auto& R) {
        const double along = R[2] * across[0] + R[5] * across[1] + R[8] * across[2];
        const std::array third{unit[1] * across[2] - unit[2] * across[1],
                               unit[2] * across[0] - unit[0] * across[2],
                               unit[0] * across[1] - unit[1] * across[0]};
        return std::atan2(R[2] * third[0] + R[5] * third[1] + R[8] * third[2], along);
    };
    const double start = azimuth(x.R);
    for (int step = 1; step <= 400; ++step) {
        REQUIRE(stepper.step(x, 0.05).ok());
        if (step % 50 != 0) { continue; }
        const double t = 0.05 * step;
        const auto L = L_at(t);
        for (std::size_t i = 0; i < 3; ++i) { CHECK(std::abs(x.L[i] - L[i]) < 2e-12); }
        CHECK(apart(azimuth(x.R) - start, integral(precession, t, 4000)) < 2e-12);
    }
}

// A = m g l = 1, spin a = L_3, let go at rest: with b = a u_0 the height u of the axis moves by
// u'^2 = 2 (u_0 - u)(u - u_1)(u_3 - u); Goldstein, Classical Mechanics, section 5.7.
TEST_CASE("a Lagrange top nutates by an elliptic function, and precesses") {
    const double a = 3, u0 = std::sqrt(3.0) / 2, b = a * u0;
    const double root = std::sqrt(std::pow(a, 4) + 16 - 8 * a * a * u0);
    const double u1 = (a * a - root) / 4, u3 = (a * a + root) / 4;
    const double k = std::sqrt((u0 - u1) / (u3 - u1));
    const auto height = [&](double t) {
        const auto [sn, cn, dn] = elliptic(std::sqrt((u3 - u1) / 2) * t, k);
        return u1 + (u0 - u1) * (cn / dn) * (cn / dn);
    };
    const auto precession = [&](double t) {
        const double u = height(t);
        return (b - a * u) / (1 - u * u);
    };
    LagrangeGauss4 stepper;
    auto x = LagrangeGauss4::initial();
    const double start = std::atan2(x.R[5], x.R[2]);
    for (int step = 1; step <= 500; ++step) {
        REQUIRE(stepper.step(x, 0.02).ok());
        if (step % 50 != 0) { continue; }
        const double t = 0.02 * step;
        CHECK(std::abs(x.R[8] - height(t)) < 2e-12);
        CHECK(apart(std::atan2(x.R[5], x.R[2]) - start, integral(precession, t, 8000)) < 2e-11);
    }
}

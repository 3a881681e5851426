// Quadratic Hamiltonians of one degree of freedom: a step is one linear map.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>
#include <scene/iterated_shifted.hpp>
#include <scene/shifted.hpp>
#include <scene/shifted_verlet.hpp>
#include <scene/trig3_oscillator.hpp>

#include "scenes.hpp"

using namespace hvi::generated;

namespace {

struct Matrix {
    double a, b, c, d;
};

/// Of a map without offset.
template <class Stepper>
Matrix matrix(Stepper& stepper, double h) {
    typename Stepper::State first{{1.0}, {0.0}};
    typename Stepper::State second{{0.0}, {1.0}};
    REQUIRE(stepper.step(first, h).ok());
    REQUIRE(stepper.step(second, h).ok());
    return {first.q[0], second.q[0], first.p[0], second.p[0]};
}

/// How far a determinant is from 1, in numbers of 64 bits or more.
long double defect(const Matrix& R) {
    const auto product = [](double x, double y) {
        return static_cast<long double>(x) * static_cast<long double>(y);
    };
    return std::abs(product(R.a, R.d) - product(R.b, R.c) - 1.0L);
}

}  // namespace

TEST_CASE("the matrix of Gauss with two stages is that of (6.6)") {
    for (const double w : {1.0, 3.0, 0.1}) {
        for (const double h : {0.1, -0.25, 2.0}) {
            HarmonicOscillator::Parameters parameters;
            parameters.omega = w;
            HarmonicOscillator stepper{parameters};
            const Matrix R = matrix(stepper, h);
            const double z2 = h * h * w * w;
            const double below = z2 * z2 + 12 * z2 + 144;
            CHECK(R.a == Approx((z2 * z2 - 60 * z2 + 144) / below).epsilon(1e-14));
            CHECK(R.b == Approx((-12 * h * z2 + 144 * h) / below).epsilon(1e-14));
            CHECK(R.c == Approx((12 * h * z2 * w * w - 144 * h * w * w) / below).epsilon(1e-14));
            CHECK(R.d == Approx(R.a).epsilon(1e-15));
            CHECK(defect(R) < 1e-15L);  // of the columns, rounded
        }
    }
}

TEST_CASE("Example 6.1: the matrix of q p is diagonal, of determinant 1") {
    Qp stepper;
    for (const double h : {0.1, 0.5, -1.0}) {
        const Matrix R = matrix(stepper, h);
        CHECK(R.b == 0.0);
        CHECK(R.c == 0.0);
        CHECK(R.a == Approx(-(h * h * h + 10 * h * h + 48 * h + 96) /
                            (h * h * h - 10 * h * h + 48 * h - 96))
                         .epsilon(1e-14));
        CHECK(defect(R) < 1e-15L);
    }
}

TEST_CASE("terms that are linear in q and p, and a product") {
    Shifted tabulated;
    IteratedShifted iterated;
    Shifted::State x{{0.5}, {-0.25}};
    IteratedShifted::State y{{0.5}, {-0.25}};
    for (int i = 0; i < 1000; ++i) {
        const double h = i < 500 ? 0.1 : -0.05;
        REQUIRE(tabulated.step(x, h).ok());
        REQUIRE(iterated.step(y, h).ok());
    }
    CHECK(x.q[0] == Approx(y.q[0]).epsilon(1e-11));
    CHECK(x.p[0] == Approx(y.p[0]).epsilon(1e-11));

    // A kick, a drift, a kick, of H = p^2/2 + q^2/2 + q - 3 p.
    ShiftedVerlet verlet;
    ShiftedVerlet::State z{{0.5}, {-0.25}};
    REQUIRE(verlet.step(z, 0.1).ok());
    const double half = -0.25 - 0.05 * (0.5 + 1);
    const double q = 0.5 + 0.1 * (half - 3);
    CHECK(z.q[0] == Approx(q).epsilon(1e-15));
    CHECK(z.p[0] == Approx(half - 0.05 * (q + 1)).epsilon(1e-15));
}

TEST_CASE("the energy of an oscillator over a million steps") {
    HarmonicOscillator stepper;
    HarmonicOscillator::State x = HarmonicOscillator::initial();
    for (int i = 0; i < 1'000'000; ++i) { REQUIRE(stepper.step(x, 0.1).ok()); }
    CHECK(std::abs(2 * stepper.energy(x) - 1.0) < 5e-13);
}

TEST_CASE("where a method has no step, the status says so") {
    // trig3 has a pole on the oscillator at z = 7.38... (see `check`); beside it there are steps.
    Trig3Oscillator stepper;
    Trig3Oscillator::State x = Trig3Oscillator::initial();
    const Trig3Oscillator::State start = x;
    CHECK_FALSE(stepper.step(x, std::numeric_limits<double>::infinity()).ok());
    CHECK_FALSE(stepper.step(x, std::numeric_limits<double>::quiet_NaN()).ok());
    CHECK(scenes::same_bits(x, start));
    CHECK(stepper.step(x, 7.0).ok());
    CHECK(stepper.step(x, 8.0).ok());
    CHECK_FALSE(stepper.step(x, 1e200).ok());
}

TEST_CASE("maps of float and long double are symplectic too") {
    BasicHarmonicOscillator<float> single;
    BasicHarmonicOscillator<float>::State x{{1.0F}, {0.0F}};
    for (int i = 0; i < 100'000; ++i) { REQUIRE(single.step(x, 0.125F).ok()); }
    CHECK(x.q[0] * x.q[0] + x.p[0] * x.p[0] == Approx(1.0).epsilon(1e-4));
    BasicHarmonicOscillator<long double> extended;
    BasicHarmonicOscillator<long double>::State y{{1.0L}, {0.0L}};
    for (int i = 0; i < 100'000; ++i) { REQUIRE(extended.step(y, 0.1L).ok()); }
    CHECK(std::abs(y.q[0] * y.q[0] + y.p[0] * y.p[0] - 1) < 1e-15L);
}

// Quadratic Hamiltonians: a step is one linear map.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>
#include <hvi/generated/gauss_2.hpp>
#include <hvi/generated/gauss_3.hpp>
#include <hvi/generated/lobatto_3.hpp>
#include <hvi/generated/trig3.hpp>
#include <scene/chain_gauss.hpp>
#include <scene/chain_lobatto.hpp>
#include <scene/chain_radau.hpp>
#include <scene/chain_trig3.hpp>
#include <scene/coupled_pair.hpp>
#include <scene/hyperbolic.hpp>
#include <scene/iterated_chain_radau.hpp>
#include <scene/iterated_rotating.hpp>
#include <scene/iterated_rotating_radau.hpp>
#include <scene/iterated_shifted.hpp>
#include <scene/magnet.hpp>
#include <scene/rotating.hpp>
#include <scene/rotating_lobatto.hpp>
#include <scene/rotating_radau.hpp>
#include <scene/saddle.hpp>
#include <scene/shifted.hpp>
#include <scene/shifted_verlet.hpp>
#include <scene/singular_mass.hpp>
#include <scene/trig3_oscillator.hpp>

#include "scenes.hpp"

using namespace hvi::generated;

namespace {

struct Matrix {
    double a, b, c, d;
};

/// Returns the matrix of a map without offset.
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

/// Three masses in a row, with terms that are linear in q and p, as a user writes them.
struct ChainByHand {
    using Vector = std::array<double, 3>;
    static void dHdq(const Vector& q, const Vector&, Vector& out) {
        out[0] = 2 * (q[0] - q[1]) + 0.4 * q[0] + 1.0 / 3;
        out[1] = -2 * (q[0] - q[1]) + 4.0 / 3 * (q[1] - q[2]) - 1;
        out[2] = -4.0 / 3 * (q[1] - q[2]) + q[2];
    }
    static void dHdp(const Vector&, const Vector& p, Vector& out) {
        out[0] = p[0] + 0.2 * p[1] + 0.5;
        out[1] = 0.2 * p[0] + 0.5 * p[1];
        out[2] = 3 * p[2] - 0.75;
    }
};

struct SingularMassByHand {
    using Vector = std::array<double, 2>;
    static void dHdq(const Vector& q, const Vector&, Vector& out) {
        out[0] = q[0] + q[1] / 7 + 1;
        out[1] = 2 * q[1] / 3 + q[0] / 7;
    }
    static void dHdp(const Vector&, const Vector& p, Vector& out) { out[0] = out[1] = p[0] + p[1]; }
};

/// In a rotating frame, with terms that are linear in q and p.
struct RotatingByHand {
    using Vector = std::array<double, 2>;
    static void dHdq(const Vector& q, const Vector& p, Vector& out) {
        out[0] = p[1] + p[0] / 3 + 2 * q[0] + 1.0 / 3;
        out[1] = -p[0] + 2 * q[1] - 1;
    }
    static void dHdp(const Vector& q, const Vector& p, Vector& out) {
        out[0] = p[0] - q[1] + q[0] / 3 + 0.5;
        out[1] = p[1] + q[0] - 0.75;
    }
};

/// H = (p1 - w q2)^2/2 + (p2 + w q1)^2/2 with w = 1/2.
struct MagnetByHand {
    using Vector = std::array<double, 2>;
    static void dHdq(const Vector& q, const Vector& p, Vector& out) {
        out[0] = (p[1] + q[0] / 2) / 2;
        out[1] = -(p[0] - q[1] / 2) / 2;
    }
    static void dHdp(const Vector& q, const Vector& p, Vector& out) {
        out[0] = p[0] - q[1] / 2;
        out[1] = p[1] + q[0] / 2;
    }
};

/// How far two steppers are from each other after steps forth and back of two sizes.
template <class Tabulated, class Iterated>
double difference(Iterated iterated) {
    Tabulated tabulated;
    typename Tabulated::State x;
    for (std::size_t k = 0; k < x.q.size(); ++k) {
        x.q[k] = 0.5 - 0.3 * static_cast<double>(k);
        x.p[k] = 0.25 * static_cast<double>(k) - 0.125;
    }
    auto y = x;
    for (int i = 0; i < 1000; ++i) {
        const double h = i < 700 ? 0.1 : -0.05;
        const hvi::Status status = tabulated.step(x, h);
        REQUIRE(status.ok());
        CHECK(status.iterations == 0);
        REQUIRE(iterated.step(y, h).ok());
    }
    return scenes::distance_of_states(x, y);
}

/// Checks that after an edit of x, and after reset(), the next step equals that of a fresh stepper.
template <class Stepper>
void check_forgetting(const Stepper& stepper, const typename Stepper::State& x) {
    for (const bool is_edited : {true, false}) {
        Stepper used = stepper;
        typename Stepper::State edited = x;
        if (is_edited) {
            edited.p[1] = -edited.p[1];
        } else {
            used.reset();
        }
        typename Stepper::State fresh = edited;
        REQUIRE(used.step(edited, 0.1).ok());
        REQUIRE(Stepper().step(fresh, 0.1).ok());
        CHECK(scenes::same_bits(edited, fresh));
    }
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

TEST_CASE("coupled degrees of freedom: the map is the step that is iterated") {
    CHECK(difference<ChainGauss>(Gauss2<ChainByHand>()) < 1e-13);
    CHECK(difference<ChainLobatto>(Lobatto3<ChainByHand>()) < 1e-13);
    CHECK(difference<ChainTrig3>(Trig3<ChainByHand>()) < 1e-13);
    // Not symmetric: the first shear and the last one differ.
    CHECK(difference<ChainRadau>(IteratedChainRadau()) < 1e-13);
}

TEST_CASE("a singular matrix of inverse masses: there are no shears, and the map is right") {
    // NOTE: p1 - p2 goes on growing, to about 60.
    CHECK(difference<SingularMass>(Gauss2<SingularMassByHand>()) < 1e-11);
}

TEST_CASE("a step that turns one mode by half a period: there are no shears") {
    // The modes q1 + q2 and q1 - q2 have w^2 = 1 and 3; with h = 2 the matrix (6.6) of the latter
    // is -1, and the other one turns.
    CoupledPair stepper;
    for (const double h : {2.0, -2.0}) {
        CoupledPair::State x{{1.0, 0.25}, {0.5, -0.125}};
        const double z2 = h * h;
        const double below = z2 * z2 + 12 * z2 + 144;
        const double a = (z2 * z2 - 60 * z2 + 144) / below;
        const double b = h * (144 - 12 * z2) / below;
        const double q = x.q[0] + x.q[1], p = x.p[0] + x.p[1];
        const double dq = x.q[0] - x.q[1], dp = x.p[0] - x.p[1];
        REQUIRE(stepper.step(x, h).ok());
        CHECK(x.q[0] + x.q[1] == Approx(a * q + b * p).epsilon(1e-14));
        CHECK(x.p[0] + x.p[1] == Approx(a * p - b * q).epsilon(1e-14));
        CHECK(x.q[0] - x.q[1] == Approx(-dq).epsilon(1e-14));
        CHECK(x.p[0] - x.p[1] == Approx(-dp).epsilon(1e-14));
    }
}

TEST_CASE("what the map of coupled masses remembers") {
    ChainGauss stepper;
    ChainGauss::State x{{0.5, -0.25, 1.0}, {0.125, 0.75, -0.5}};
    const ChainGauss::State start = x;
    REQUIRE(stepper.step(x, 0.0).ok());
    CHECK(scenes::same_bits(x, start));
    REQUIRE(stepper.step(x, 0.1).ok());
    REQUIRE(stepper.step(x, -0.1).ok());
    CHECK(scenes::distance_of_states(x, start) < 1e-15);

    for (int i = 0; i < 100; ++i) { REQUIRE(stepper.step(x, 0.1).ok()); }
    check_forgetting(stepper, x);
}

TEST_CASE("steps that coupled masses do not have leave the state") {
    using Code = hvi::Status::Code;
    // The midpoint rule has a pole on p^2/2 - q^2/2 at h = 2, and its coefficients are exact.
    Saddle stepper;
    Saddle::State x{{0.5, -0.25}, {0.125, 0.75}};
    const Saddle::State start = x;
    CHECK(stepper.step(x, 2.0).code() == Code::singular);
    CHECK(stepper.step(x, std::numeric_limits<double>::infinity()).code() == Code::not_finite);
    CHECK(stepper.step(x, std::numeric_limits<double>::quiet_NaN()).code() == Code::not_finite);
    CHECK(scenes::same_bits(x, start));
    for (std::size_t k = 0; k < 2; ++k) {
        Saddle::State lost = start;
        lost.q[k] = std::numeric_limits<double>::infinity();
        const Saddle::State before = lost;
        CHECK(stepper.step(lost, 0.5).code() == Code::not_finite);
        CHECK(scenes::same_bits(lost, before));
    }
    CHECK(stepper.step(x, 1.0).ok());
}

TEST_CASE("products of q and p: the map is the step that is iterated") {
    CHECK(difference<Rotating>(IteratedRotating()) < 1e-12);
    CHECK(difference<RotatingLobatto>(Lobatto3<RotatingByHand>()) < 1e-12);
    CHECK(difference<RotatingRadau>(IteratedRotatingRadau()) < 1e-12);
    CHECK(difference<Magnet>(Gauss3<MagnetByHand>()) < 1e-12);
}

TEST_CASE("products of q and p in float and long double") {
    const auto change = [](auto stepper, auto h) {
        using Number = typename decltype(stepper)::Scalar;
        typename decltype(stepper)::State x;
        x.q = {Number(0.5), Number(-0.25)};
        x.p = {Number(0.125), Number(0.75)};
        const auto energy = stepper.energy(x);
        for (int i = 0; i < 100'000; ++i) { REQUIRE(stepper.step(x, h).ok()); }
        return std::abs(stepper.energy(x) / energy - 1);
    };
    CHECK(change(BasicRotating<float>(), 0.125F) < 5e-6F);
    CHECK(change(BasicRotating<long double>(), 0.1L) < 5e-17L);
}

TEST_CASE("what a step by a matrix remembers") {
    RotatingLobatto stepper;
    const RotatingLobatto::State start{{0.5, -0.25}, {0.125, 0.75}};
    RotatingLobatto::State x = start;
    REQUIRE(stepper.step(x, 0.0).ok());
    CHECK(scenes::same_bits(x, start));
    REQUIRE(stepper.step(x, 0.1).ok());
    REQUIRE(stepper.step(x, -0.1).ok());
    CHECK(scenes::distance_of_states(x, start) < 1e-15);

    for (int i = 0; i < 100; ++i) { REQUIRE(stepper.step(x, 0.1).ok()); }
    RotatingLobatto goes_on = stepper, begins;
    RotatingLobatto::State next = x, alone = x;
    bool differ = false;
    for (int i = 0; i < 20; ++i) {
        REQUIRE(goes_on.step(next, 0.1).ok());
        REQUIRE(begins.step(alone, 0.1).ok());
        differ = differ || !scenes::same_bits(next, alone);
    }
    CHECK(differ);  // by what the sums cut off
    check_forgetting(stepper, x);
}

TEST_CASE("with shears at one step size and none at another, one memory is alive") {
    // See above: no shears at h = 2.
    CoupledPair stepper;
    CoupledPair::State x{{1.0, 0.3}, {0.7, -0.1}};
    for (int i = 0; i < 10; ++i) { REQUIRE(stepper.step(x, 2.0).ok()); }
    CoupledPair::State kept = x, other = x;
    other.q[0] += 1;
    REQUIRE(stepper.step(other, 0.1).ok());
    CoupledPair::State fresh = kept;
    REQUIRE(stepper.step(kept, 2.0).ok());
    REQUIRE(CoupledPair().step(fresh, 2.0).ok());
    CHECK(scenes::same_bits(kept, fresh));

    for (int i = 0; i < 10; ++i) { REQUIRE(stepper.step(x, 0.1).ok()); }
    kept = other = x;
    other.q[0] += 1;
    REQUIRE(stepper.step(other, 2.0).ok());
    fresh = kept;
    REQUIRE(stepper.step(kept, 0.1).ok());
    REQUIRE(CoupledPair().step(fresh, 0.1).ok());
    CHECK(scenes::same_bits(kept, fresh));
}

TEST_CASE("steps that a matrix does not have leave the state") {
    using Code = hvi::Status::Code;
    // The midpoint rule multiplies q1 by (1 + h/2)/(1 - h/2), and q2 by (1 - h/4)/(1 + h/4).
    Hyperbolic stepper;
    const Hyperbolic::State start{{0.5, -0.25}, {0.125, 0.75}};
    Hyperbolic::State x = start;
    REQUIRE(stepper.step(x, 1.0).ok());
    CHECK(x.q[0] == Approx(3 * start.q[0]).epsilon(1e-15));
    CHECK(x.p[0] == Approx(start.p[0] / 3).epsilon(1e-15));
    CHECK(x.q[1] == Approx(0.6 * start.q[1]).epsilon(1e-15));
    CHECK(x.p[1] == Approx(start.p[1] / 0.6).epsilon(1e-15));

    x = start;
    CHECK(stepper.step(x, 2.0).code() == Code::singular);
    CHECK(stepper.step(x, std::numeric_limits<double>::infinity()).code() == Code::not_finite);
    CHECK(stepper.step(x, std::numeric_limits<double>::quiet_NaN()).code() == Code::not_finite);
    CHECK(scenes::same_bits(x, start));
    Hyperbolic::State lost = start;
    lost.q[0] = std::numeric_limits<double>::max();
    const Hyperbolic::State before = lost;
    CHECK(stepper.step(lost, 1.0).code() == Code::not_finite);
    CHECK(scenes::same_bits(lost, before));

    // A failed step leaves nothing behind.
    Hyperbolic::State fresh = start;
    REQUIRE(stepper.step(x, 1.0).ok());
    REQUIRE(Hyperbolic().step(fresh, 1.0).ok());
    CHECK(scenes::same_bits(x, fresh));
}

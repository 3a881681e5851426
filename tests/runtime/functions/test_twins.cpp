// Scenes that call the functions that few scenes call, against the same in other functions, and
// against motions and derivatives by hand.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>
#include <functions/bouncing.hpp>
#include <functions/bouncings.hpp>
#include <functions/in_lanes.hpp>
#include <functions/kinks.hpp>
#include <functions/kinks_lanes.hpp>
#include <functions/newton.hpp>
#include <functions/smooth.hpp>
#include <functions/twin.hpp>
#include <functions/wide_bouncing.hpp>
#include <functions/wide_smooth.hpp>
#include <functions/wide_twin.hpp>
#include <hvi/ensemble.hpp>

using namespace hvi::generated;

namespace {

using hvi::math::Widest;
constexpr double eps = std::numeric_limits<double>::epsilon();

template <class A, class B>
double distance(const A& x, const B& y) {
    const auto apart = [](Widest a, Widest b) { return std::abs(static_cast<double>(a - b)); };
    double largest = 0;
    for (std::size_t k = 0; k < x.q.size(); ++k) {
        largest = std::fmax(largest, apart(Widest(x.q[k]), Widest(y.q[k])));
        largest = std::fmax(largest, apart(Widest(x.p[k]), Widest(y.p[k])));
    }
    return largest;
}

/// The step as it is in the numbers of a stepper.
template <class Stepper>
hvi::Status step(Stepper& stepper, typename Stepper::State& x, double h) {
    return stepper.step(x, static_cast<typename Stepper::Scalar>(h));
}

/// Returns the distance after `steps` steps from equal states.
template <class A, class B>
double apart(A a, B b, double h, int steps) {
    auto x = A::initial();
    auto y = B::initial();
    for (int i = 0; i < steps; ++i) {
        REQUIRE(step(a, x, h).ok());
        REQUIRE(step(b, y, h).ok());
    }
    return distance(x, y);
}

/// dH/dq of a state at rest.
template <class Stepper>
std::vector<double> slopes(double q, double s) {
    const typename Stepper::System system{typename Stepper::Parameters{}};
    typename Stepper::Vector at{q, s}, result{};
    system.dHdq(at, result);
    return {result[0], result[1]};
}

}  // namespace

TEST_CASE("a scene steps as its twin in other functions does") {
    CHECK(apart(Smooth(), Twin(), 0.1, 50) < 400 * eps);
    CHECK(apart(NewtonSmooth(), Twin(), 0.1, 50) < 400 * eps);
    CHECK(apart(LanesSmooth(), Twin(), 0.1, 50) < 400 * eps);
    const Smooth smooth;
    const Twin twin;
    CHECK(smooth.energy(Smooth::initial()) == Approx(twin.energy(Twin::initial())).epsilon(1e-15));
}

TEST_CASE("and in the widest numbers in more digits") {
    const double most = hvi::detail::bits<Widest> > 64 ? 1e-29 : 1e-15;
    CHECK(apart(BasicWideSmooth<Widest>(), BasicWideTwin<Widest>(), 0.125, 20) < most);
    CHECK(apart(BasicWideSmooth<Widest>(), Smooth(), 0.125, 20) < 400 * eps);
}

TEST_CASE("a body in the potential |q| falls on a parabola, up to the kink") {
    Bouncing stepper;
    BasicWideBouncing<Widest> wide;
    auto x = Bouncing::initial();
    auto y = BasicWideBouncing<Widest>::initial();
    constexpr double h = 0.125;
    for (int i = 1; i <= 11; ++i) {  // to 1.375 < sqrt(2)
        REQUIRE(stepper.step(x, h).ok());
        REQUIRE(step(wide, y, h).ok());
        const double t = i * h;
        CHECK(x.q[0] == 1 - t * t / 2);
        CHECK(x.p[0] == -t);
        CHECK(distance(x, y) == 0);
    }
    REQUIRE(stepper.step(x, h).ok());
    REQUIRE(stepper.step(x, h).ok());
    CHECK(x.q[0] < 0);
    const double below = x.p[0];
    REQUIRE(stepper.step(x, h).ok());
    CHECK(x.p[0] == below + h);
}

TEST_CASE("trajectories on both sides of a kink go side by side") {
    std::vector<Bouncings::Trajectory> starts;
    for (int i = 0; i < 8; ++i) { starts.push_back({{i - 3.5}, {0.25}}); }
    hvi::Ensemble<Bouncings> ensemble(starts);
    ensemble.advance(0.125, 100, 1);
    for (std::size_t i = 0; i < starts.size(); ++i) {
        Bouncing one;
        Bouncing::State x{{starts[i].q[0]}, {starts[i].p[0]}};
        for (int step = 0; step < 100; ++step) { REQUIRE(one.step(x, 0.125).ok()); }
        CHECK(distance(ensemble.state(i), x) < 4 * eps);
    }
}

TEST_CASE("derivatives on all sides of kinks, where what is not chosen has none") {
    // Derivatives of 2|q| + 3 sign(s) + 5 min(q, s^2) + 7 max(q, s) + 11 if(q<0, q^3, sqrt(q)) + 13
    // if(s>=1, log(s), 0), by hand.
    const std::vector<std::vector<double>> known{
        {4, 3, 2 + 5 + 7 + 11.0 / 4, 13.0 / 3},  // q < s^2, s < q
        {4, 1, 2 + 7 + 11.0 / 4, 10 + 13},       // s^2 < q, at s = 1
        {4, -1, 2 + 7 + 11.0 / 4, -10},          // log(s) is none
        {-2, -1, -2 + 5 + 132, 7},               // sqrt(q) is none, q < s
        {-1, -2, -2 + 5 + 7 + 33, 0},
        {1, 4, 2 + 5 + 11.0 / 2, 7 + 13.0 / 4},
    };
    for (const auto& row : known) {
        CAPTURE(row[0], row[1]);
        const auto found = slopes<Kinks>(row[0], row[1]);
        CHECK(found[0] == Approx(row[2]).epsilon(1e-15));
        CHECK(found[1] == Approx(row[3]).epsilon(1e-15));
    }
}

TEST_CASE("stages in lanes choose as stages one by one") {
    for (const double start : {-2.0, 0.5, 2.0}) {
        Kinks plain;
        KinksLanes lanes;
        Kinks::State x{{start, 1.25}, {0.5, -0.25}};
        KinksLanes::State y{{start, 1.25}, {0.5, -0.25}};
        for (int i = 0; i < 3; ++i) {
            REQUIRE(plain.step(x, 1.0 / 128).ok());
            REQUIRE(lanes.step(y, 1.0 / 128).ok());
        }
        CHECK(distance(x, y) < 100 * eps);
    }
}

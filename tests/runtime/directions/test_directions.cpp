// Directions that steps carry along, beside dual numbers that differentiate the same steps.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <driver/dual.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <type_traits>
#include <vector>

#include <directions/composed_nonseparable.hpp>
#include <directions/driven_midpoint.hpp>
#include <directions/driven_pendulum.hpp>
#include <directions/driven_verlet.hpp>
#include <directions/dual_composed_nonseparable.hpp>
#include <directions/dual_driven_midpoint.hpp>
#include <directions/dual_driven_pendulum.hpp>
#include <directions/dual_driven_verlet.hpp>
#include <directions/dual_euler_henon.hpp>
#include <directions/dual_gauss_3_kepler.hpp>
#include <directions/dual_gauss_comet.hpp>
#include <directions/dual_gauss_planet.hpp>
#include <directions/dual_kahan_li_kepler.hpp>
#include <directions/dual_kepler.hpp>
#include <directions/dual_lobatto_henon.hpp>
#include <directions/dual_midpoint_kepler.hpp>
#include <directions/dual_nonseparable.hpp>
#include <directions/dual_radau_nonseparable.hpp>
#include <directions/dual_stiff_pair.hpp>
#include <directions/dual_stiff_spring.hpp>
#include <directions/dual_verlet_comet.hpp>
#include <directions/dual_verlet_henon.hpp>
#include <directions/euler_henon.hpp>
#include <directions/fixed_point_kepler.hpp>
#include <directions/gauss_3_kepler.hpp>
#include <directions/gauss_bead.hpp>
#include <directions/gauss_chain.hpp>
#include <directions/gauss_comet.hpp>
#include <directions/gauss_kepler.hpp>
#include <directions/gauss_nonseparable.hpp>
#include <directions/gauss_oscillator.hpp>
#include <directions/gauss_planet.hpp>
#include <directions/gauss_springs.hpp>
#include <directions/kahan_li_kepler.hpp>
#include <directions/lobatto_henon.hpp>
#include <directions/midpoint_kepler.hpp>
#include <directions/radau_nonseparable.hpp>
#include <directions/stiff_pair.hpp>
#include <directions/stiff_spring.hpp>
#include <directions/verlet_chain.hpp>
#include <directions/verlet_comet.hpp>
#include <directions/verlet_henon.hpp>

#include <catch2/catch.hpp>

namespace {

using namespace hvi::generated;

template <class Stepper>
constexpr std::size_t degrees = std::tuple_size_v<typename Stepper::Vector>;

/// Component of a state: q, then p.
template <class State>
auto& component(State& x, std::size_t k) {
    return k < x.q.size() ? x.q[k] : x.p[k - x.q.size()];
}

template <class Stepper>
using States = std::vector<typename Stepper::State>;

/// Where the scene begins; without one, in the middle of a swing.
template <class Stepper, class = void>
struct Start {
    static typename Stepper::State state() {
        typename Stepper::State x{};
        x.q[0] = 1;
        x.p[0] = 0.5;
        return x;
    }
};
template <class Stepper>
struct Start<Stepper, std::void_t<decltype(Stepper::initial())>> {
    static typename Stepper::State state() { return Stepper::initial(); }
};

/// The columns of a derivative that is the identity.
template <class Stepper>
States<Stepper> units() {
    States<Stepper> all(2 * degrees<Stepper>);
    for (std::size_t k = 0; k < all.size(); ++k) { component(all[k], k) = 1; }
    return all;
}

template <class Stepper>
States<Stepper> columns_after(double h, int steps) {
    Stepper stepper;
    typename Stepper::State x = Start<Stepper>::state();
    States<Stepper> D = units<Stepper>();
    for (int step = 0; step < steps; ++step) { REQUIRE(stepper.step(x, D, h).ok()); }
    return D;
}

/// The largest difference from the derivative by dual numbers, over the largest entry.
template <class Stepper, class Dual>
double difference(double h, int steps) {
    Dual stepper{typename Dual::Parameters{}};
    typename Dual::State x = Start<Dual>::state();
    constexpr std::size_t n = 2 * degrees<Stepper>;
    for (std::size_t k = 0; k < n; ++k) {
        std::fill_n(component(x, k).by, n, 0);
        component(x, k).by[k] = 1;
    }
    for (int step = 0; step < steps; ++step) { REQUIRE(stepper.step(x, h).ok()); }
    const States<Stepper> D = columns_after<Stepper>(h, steps);
    double largest = 0, error = 0;
    for (std::size_t row = 0; row < n; ++row) {
        for (std::size_t column = 0; column < n; ++column) {
            const double entry = component(x, row).by[column];
            largest = std::max(largest, std::abs(entry));
            error = std::max(error, std::abs(entry - component(D[column], row)));
        }
    }
    return error / largest;
}

/// dq^dp of two directions.
template <class State>
double form(const State& a, const State& b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.q.size(); ++k) { sum += a.q[k] * b.p[k] - a.p[k] * b.q[k]; }
    return sum;
}

/// The largest entry of D^T J D - J over the square of the largest of D.
template <class Stepper>
double defect(double h, int steps) {
    const States<Stepper> D = columns_after<Stepper>(h, steps);
    constexpr std::size_t n = degrees<Stepper>;
    double largest = 1, error = 0;
    for (std::size_t a = 0; a < 2 * n; ++a) {
        for (std::size_t b = 0; b < 2 * n; ++b) {
            largest = std::max(largest, std::abs(component(D[a], b)));
            const double expected = b == a + n ? 1 : a == b + n ? -1 : 0;
            error = std::max(error, std::abs(form(D[a], D[b]) - expected));
        }
    }
    return error / (largest * largest);
}

/// How far <lambda, d> is from constant, relative to the norms of both.
template <class Stepper>
double change_of_product(double h, int steps) {
    Stepper stepper;
    States<Stepper> x{Start<Stepper>::state()};
    std::array<typename Stepper::State, 1> d{};
    for (std::size_t k = 0; k < 2 * degrees<Stepper>; ++k) {
        component(d[0], k) = 1 / (1.0 + static_cast<double>(k));
    }
    const auto start = d[0];
    for (int step = 0; step < steps; ++step) {
        x.push_back(x.back());
        REQUIRE(stepper.step(x.back(), d, h).ok());
    }
    typename Stepper::State lambda{};
    for (std::size_t k = 0; k < 2 * degrees<Stepper>; ++k) {
        component(lambda, k) = k % 2 == 0 ? 1 : -0.5;
    }
    const auto product = [](auto& a, auto& b) {
        double sum = 0;
        for (std::size_t k = 0; k < 2 * degrees<Stepper>; ++k) {
            sum += component(a, k) * component(b, k);
        }
        return sum;
    };
    const double after = product(lambda, d[0]);
    double size = 0;
    for (std::size_t k = 0; k < 2 * degrees<Stepper>; ++k) {
        size += std::abs(component(lambda, k) * component(d[0], k));
    }
    for (int step = steps; step-- > 0;) {
        REQUIRE(stepper.pull_back(x[static_cast<std::size_t>(step)], lambda, h).ok());
    }
    return std::abs(product(lambda, start) - after) / size;
}

TEST_CASE("directions are carried by the derivative of the steps") {
    using hvi::driver::Dual;
    CHECK(difference<GaussNonseparable, BasicDualNonseparable<Dual<2>>>(0.01, 50) < 1e-13);
    CHECK(difference<GaussKepler, BasicDualKepler<Dual<4>>>(0.05, 100) < 1e-13);
    CHECK(difference<FixedPointKepler, BasicDualKepler<Dual<4>>>(0.05, 100) < 1e-13);
    CHECK(difference<LobattoHenon, BasicDualLobattoHenon<Dual<4>>>(0.1, 100) < 1e-13);
    CHECK(difference<VerletHenon, BasicDualVerletHenon<Dual<4>>>(0.1, 100) < 1e-13);
    CHECK(difference<EulerHenon, BasicDualEulerHenon<Dual<4>>>(0.1, 100) < 1e-13);
    CHECK(difference<KahanLiKepler, BasicDualKahanLiKepler<Dual<4>>>(0.05, 100) < 1e-13);
}

TEST_CASE("directions are carried by stages of any number, of which some solve nothing") {
    using hvi::driver::Dual;
    CHECK(difference<Gauss3Kepler, BasicDualGauss3Kepler<Dual<4>>>(0.05, 100) < 1e-13);
    CHECK(difference<MidpointKepler, BasicDualMidpointKepler<Dual<4>>>(0.05, 100) < 1e-13);
    CHECK(difference<RadauNonseparable, BasicDualRadauNonseparable<Dual<2>>>(0.01, 50) < 1e-13);
    CHECK(difference<ComposedNonseparable, BasicDualComposedNonseparable<Dual<2>>>(0.01, 50) <
          1e-13);
}

TEST_CASE("directions look at H at the times of the stages") {
    using hvi::driver::Dual;
    CHECK(difference<DrivenPendulum, BasicDualDrivenPendulum<Dual<2>>>(0.1, 100) < 1e-13);
    CHECK(difference<DrivenMidpoint, BasicDualDrivenMidpoint<Dual<2>>>(0.1, 100) < 1e-13);
    CHECK(difference<DrivenVerlet, BasicDualDrivenVerlet<Dual<2>>>(0.1, 100) < 1e-13);
}

TEST_CASE("directions in scaled time have parts along the time and its momentum") {
    using hvi::driver::Dual;
    CHECK(difference<VerletComet, BasicDualVerletComet<Dual<6>>>(0.1, 100) < 1e-12);
    CHECK(difference<GaussComet, BasicDualGaussComet<Dual<6>>>(0.1, 100) < 1e-12);
    CHECK(difference<GaussPlanet, BasicDualGaussPlanet<Dual<6>>>(0.2, 100) < 1e-12);
    CHECK(defect<VerletComet>(0.1, 1000) < 1e-12);
    CHECK(defect<GaussPlanet>(0.2, 1000) < 1e-12);
    CHECK(change_of_product<VerletComet>(0.1, 201) < 1e-11);
    CHECK(change_of_product<GaussComet>(0.1, 201) < 1e-11);
    CHECK(change_of_product<GaussPlanet>(0.2, 201) < 1e-11);
}

TEST_CASE("directions of stiff motion, where sweeps diverge, are solved for at once") {
    using hvi::driver::Dual;
    // NOTE: a step is ten radians of the spring, and three of the pair.
    CHECK(difference<StiffSpring, BasicDualStiffSpring<Dual<2>>>(0.1, 50) < 1e-12);
    CHECK(difference<StiffPair, BasicDualStiffPair<Dual<2>>>(0.1, 50) < 1e-12);
    CHECK(defect<StiffSpring>(0.1, 1000) < 1e-12);
    CHECK(defect<StiffPair>(0.1, 1000) < 1e-12);
    CHECK(change_of_product<StiffSpring>(0.1, 101) < 1e-12);
}

TEST_CASE("the derivative of steps is symplectic to round-off") {
    CHECK(defect<GaussNonseparable>(0.01, 100'000) < 1e-12);
    CHECK(defect<GaussKepler>(0.05, 2000) < 1e-13);
    CHECK(defect<FixedPointKepler>(0.05, 2000) < 1e-13);
    CHECK(defect<KahanLiKepler>(0.05, 2000) < 1e-13);
    CHECK(defect<LobattoHenon>(0.1, 2000) < 1e-13);
    CHECK(defect<VerletHenon>(0.1, 100'000) < 1e-12);
    CHECK(defect<EulerHenon>(0.1, 2000) < 1e-13);
    CHECK(defect<GaussOscillator>(0.1, 2000) < 1e-13);
    CHECK(defect<DrivenPendulum>(0.1, 2000) < 1e-13);
    CHECK(defect<GaussBead>(0.1, 2000) < 1e-13);
}

TEST_CASE("covectors are pulled back by the transposed derivative") {
    CHECK(change_of_product<GaussNonseparable>(0.01, 1001) < 1e-12);
    CHECK(change_of_product<GaussKepler>(0.05, 401) < 1e-12);
    CHECK(change_of_product<FixedPointKepler>(0.05, 401) < 1e-12);
    CHECK(change_of_product<KahanLiKepler>(0.05, 401) < 1e-12);
    CHECK(change_of_product<LobattoHenon>(0.1, 1001) < 1e-12);
    CHECK(change_of_product<VerletHenon>(0.1, 1001) < 1e-12);
    CHECK(change_of_product<EulerHenon>(0.1, 1001) < 1e-12);
    CHECK(change_of_product<GaussOscillator>(0.1, 1001) < 1e-12);
    CHECK(change_of_product<DrivenPendulum>(0.1, 1001) < 1e-12);
    CHECK(change_of_product<GaussBead>(0.1, 1001) < 1e-12);
}

/// <lambda, d> at the end of a run of many masses and at its beginning, relative to the size.
template <class Chain>
double change_of_product_of_chain(double h, int steps) {
    Chain stepper;
    std::vector<typename Chain::State> x{Chain::initial()}, d{x.front()};
    typename Chain::State lambda = x.front();
    for (std::size_t k = 0; k < lambda.q.size(); ++k) {
        const auto angle = static_cast<double>(k);
        d.front().q[k] = std::sin(angle);
        d.front().p[k] = std::cos(2 * angle);
        lambda.q[k] = std::cos(3 * angle);
        lambda.p[k] = std::sin(5 * angle);
    }
    const auto start = d.front();
    double size = 0;
    const auto product = [&](const auto& a, const auto& b) {
        double sum = 0;
        for (std::size_t k = 0; k < a.q.size(); ++k) {
            sum += a.q[k] * b.q[k] + a.p[k] * b.p[k];
            size += std::abs(a.q[k] * b.q[k]) + std::abs(a.p[k] * b.p[k]);
        }
        return sum;
    };
    for (int step = 0; step < steps; ++step) {
        x.push_back(x.back());
        REQUIRE(stepper.step(x.back(), d, h).ok());
    }
    const double after = product(lambda, d.front());
    for (int step = steps; step-- > 0;) {
        REQUIRE(stepper.pull_back(x[static_cast<std::size_t>(step)], lambda, h).ok());
    }
    return std::abs(product(lambda, start) - after) / size;
}

TEST_CASE("directions of many masses whose sums stay loops") {
    CHECK(change_of_product_of_chain<VerletChain>(0.1, 51) < 1e-13);
    CHECK(change_of_product_of_chain<GaussChain>(0.1, 21) < 1e-13);
    CHECK(change_of_product_of_chain<GaussSprings>(0.1, 21) < 1e-13);
}

TEST_CASE("a state moves with the bits of a step without directions") {
    const double h = 0.1;
    VerletHenon with, without;
    VerletHenon::State x = VerletHenon::initial(), y = x;
    std::vector<VerletHenon::State> D = units<VerletHenon>();
    for (int step = 0; step < 100; ++step) {
        REQUIRE(with.step(x, D, h).ok());
        REQUIRE(without.step(y, h).ok());
    }
    CHECK(x.q == y.q);
    CHECK(x.p == y.p);
}

/// Steps with so many directions, which are multiples of one.
template <class Stepper>
void go_with(std::size_t count) {
    const double h = 0.1;
    Stepper stepper, alone;
    typename Stepper::State x = Start<Stepper>::state(), y = x;
    States<Stepper> D(count), one(1);
    one[0].q[0] = 1;
    for (std::size_t k = 0; k < count; ++k) { D[k].q[0] = static_cast<double>(k + 1); }
    for (int step = 0; step < 20; ++step) {
        REQUIRE(stepper.step(x, D, h).ok());
        REQUIRE(alone.step(y, one, h).ok());
    }
    for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t i = 0; i < 2 * degrees<Stepper>; ++i) {
            const double expected = static_cast<double>(k + 1) * component(one[0], i);
            CHECK(component(D[k], i) == Approx(expected).epsilon(1e-13).margin(1e-13));
        }
    }
}

TEMPLATE_TEST_CASE("any number of directions goes along, each as if alone", "", VerletHenon,
                   KahanLiKepler, GaussKepler, Gauss3Kepler, LobattoHenon, DrivenPendulum,
                   DrivenMidpoint, DrivenVerlet, StiffSpring) {
    for (const std::size_t count : {0U, 1U, 2U, 3U, 5U, 7U, 8U, 9U, 17U}) {
        go_with<TestType>(count);
    }
}

TEMPLATE_TEST_CASE("directions that stay behind for a while are taken along from where they are",
                   "", VerletHenon, GaussKepler, DrivenVerlet) {
    const double h = 0.1;
    TestType stepper, fresh;
    typename TestType::State x = Start<TestType>::state();
    States<TestType> D(9), first(1);
    for (typename TestType::State& d : D) { d.q[0] = 1; }
    REQUIRE(stepper.step(x, D, h).ok());
    first[0] = D[0];
    REQUIRE(stepper.step(x, first, h).ok());
    States<TestType> E = D;
    typename TestType::State y = x;
    REQUIRE(stepper.step(x, D, h).ok());
    REQUIRE(fresh.step(y, E, h).ok());
    for (std::size_t k = 0; k < D.size(); ++k) {
        for (std::size_t i = 0; i < 2 * degrees<TestType>; ++i) {
            CHECK(component(D[k], i) == Approx(component(E[k], i)).epsilon(1e-14).margin(1e-14));
        }
    }
}

TEST_CASE("parameters are those of the stepper") {
    GaussKepler::Parameters heavy;
    heavy.mu = 4;
    // Time scales with mu^(-1/2): with mu = 4 and half the step all q are those of mu = 1.
    GaussKepler stepper(heavy), usual;
    GaussKepler::State x = GaussKepler::initial(heavy), y = GaussKepler::initial();
    auto D = units<GaussKepler>(), E = D;
    for (int step = 0; step < 50; ++step) {
        REQUIRE(stepper.step(x, D, 0.025).ok());
        REQUIRE(usual.step(y, E, 0.05).ok());
    }
    CHECK(D[0].q[0] == Approx(E[0].q[0]).epsilon(1e-12));
    CHECK(D[2].q[1] == Approx(E[2].q[1] / 2).epsilon(1e-12));
    CHECK(D[0].p[1] == Approx(2 * E[0].p[1]).epsilon(1e-12));
}

TEST_CASE("a step that fails leaves directions and covectors as they are") {
    GaussKepler stepper;
    GaussKepler::State x = GaussKepler::initial();
    auto D = units<GaussKepler>();
    GaussKepler::State lambda = D[1];
    const auto x_before = x;
    const auto D_before = D;
    CHECK(stepper.step(x, D, std::numeric_limits<double>::infinity()).code() ==
          hvi::Status::Code::not_finite);
    CHECK(stepper.pull_back(x, lambda, std::numeric_limits<double>::infinity()).code() ==
          hvi::Status::Code::not_finite);
    D[2].p[0] = std::nan("");
    CHECK(!stepper.step(x, D, 0.1).ok());
    D[2].p[0] = D_before[2].p[0];
    CHECK(x.q == x_before.q);
    CHECK(x.p == x_before.p);
    for (std::size_t k = 0; k < D.size(); ++k) {
        CHECK(D[k].q == D_before[k].q);
        CHECK(D[k].p == D_before[k].p);
    }
    CHECK(lambda.q == D[1].q);
    CHECK(stepper.step(x, D, 0).ok());
    CHECK(D[0].q == D_before[0].q);
    CHECK(stepper.step(x, D, 0.1).ok());
}

}  // namespace

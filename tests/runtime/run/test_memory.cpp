// The memory of a stepper, which belongs to a state.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Core>
#include <catch2/catch.hpp>
#include <hvi/generated/gauss_2.hpp>
#include <hvi/generated/gauss_2_separable.hpp>
#include <hvi/generated/gauss_4.hpp>
#include <hvi/generated/lobatto_3_separable.hpp>
#include <hvi/generated/stormer_verlet_separable.hpp>
#include <hvi/generated/symplectic_euler_separable.hpp>
#include <hvi/generated/trig3.hpp>
#include <hvi/newton.hpp>

#include "systems.hpp"

using namespace hvi::generated;

namespace {

using State = hvi::State<systems::Two>;
const State orbit{{1.0, 0.2}, {0.1, 0.9}};

template <class Stepper>
void steps(Stepper& stepper, State& x, double h, int count) {
    for (int i = 0; i < count; ++i) { REQUIRE(stepper.step(x, h).ok()); }
}

template <class Stepper>
void check_edited_state() {
    Stepper stepper;
    State x = orbit;
    steps(stepper, x, 0.1, 7);
    x.p[1] = std::nextafter(x.p[1], 2.0);
    State y = x;
    Stepper fresh;
    for (int i = 0; i < 3; ++i) {
        steps(stepper, x, 0.1, 1);
        steps(fresh, y, 0.1, 1);
        REQUIRE(systems::same_bits(x, y));
    }
    // An edit of q alone, and of the sign of a zero.
    x.q[0] = 0.0;
    x.q[1] = 1.0;
    steps(stepper, x, 0.1, 1);
    x.q[0] = x.p[0] = -0.0;
    y = x;
    fresh = Stepper{};
    steps(stepper, x, 0.1, 1);
    steps(fresh, y, 0.1, 1);
    CHECK(systems::same_bits(x, y));
}

template <class Stepper>
void check_reset() {
    Stepper stepper;
    State x = orbit;
    steps(stepper, x, 0.1, 7);
    State y = x;
    Stepper fresh;
    stepper.reset();
    steps(stepper, x, 0.1, 2);
    steps(fresh, y, 0.1, 2);
    CHECK(systems::same_bits(x, y));
}

template <class Stepper>
void check_failures_and_zero(Stepper stepper, hvi::State<systems::One> x) {
    const auto before = x;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double h : {nan, infinity, -infinity}) {
        const hvi::Status status = stepper.step(x, h);
        CHECK(status.code() == hvi::Status::Code::not_finite);
        CHECK(systems::same_bits(x, before));
    }
    for (const double h : {10.0, 1e4, 1e160, 1e308, -1e308}) {
        const hvi::Status status = stepper.step(x, h);
        CHECK_FALSE(status.ok());
        CHECK(systems::same_bits(x, before));
    }
    const hvi::Status status = stepper.step(x, 0.0);
    CHECK(status.ok());
    CHECK(systems::same_bits(x, before));
    auto fresh = stepper;
    fresh.reset();
    auto y = x;
    REQUIRE(stepper.step(x, 0.01).ok());
    REQUIRE(fresh.step(y, 0.01).ok());
    CHECK(systems::same_bits(x, y));
}

}  // namespace

TEST_CASE("an edited state gets the bits of a fresh stepper") {
    check_edited_state<Gauss2<systems::AsGeneral<systems::Kepler>>>();
    check_edited_state<Gauss2Separable<systems::Kepler>>();
    check_edited_state<Lobatto3Separable<systems::Kepler>>();
    check_edited_state<StormerVerletSeparable<systems::Kepler>>();
    check_edited_state<SymplecticEulerSeparable<systems::Kepler>>();
    check_edited_state<Trig3<systems::AsGeneral<systems::Kepler>>>();
}

TEST_CASE("the factors of Newton's method belong to a state and a step size, too") {
    using Stepper = Gauss2<systems::Product, hvi::Newton>;
    Stepper stepper;
    hvi::State<systems::One> x{{0.7}, {-0.4}};
    for (int i = 0; i < 5; ++i) { REQUIRE(stepper.step(x, 0.1).ok()); }
    x.q[0] += 0.5;
    auto y = x;
    Stepper fresh;
    REQUIRE(stepper.step(x, 0.1).ok());
    REQUIRE(fresh.step(y, 0.1).ok());
    CHECK(systems::same_bits(x, y));
    auto z = x;
    REQUIRE(stepper.step(x, 0.4).ok());
    REQUIRE(Gauss2<systems::Product>{}.step(z, 0.4).ok());
    CHECK(std::abs(x.q[0] - z.q[0]) < 1e-15);
}

TEST_CASE("reset() forgets") {
    check_reset<Gauss2Separable<systems::Kepler>>();
    check_reset<Lobatto3Separable<systems::Kepler>>();
    check_reset<StormerVerletSeparable<systems::Kepler>>();
}

TEST_CASE("a step that fails leaves the state as it was, one of size 0 does nothing") {
    const hvi::State<systems::One> inside{{0.9}, {0.5}};
    check_failures_and_zero(Gauss2Separable<systems::Fenced>{}, inside);
    check_failures_and_zero(Lobatto3Separable<systems::Fenced>{}, inside);
    check_failures_and_zero(StormerVerletSeparable<systems::Fenced>{}, inside);
    check_failures_and_zero(Gauss2<systems::AsGeneral<systems::Fenced>>{}, inside);
    check_failures_and_zero(Gauss4<systems::Product>{}, inside);
}

TEST_CASE("a gradient that is not a number is a status") {
    hvi::State<systems::One> x{{2.0}, {0.5}};
    const auto before = x;
    CHECK(Gauss2Separable<systems::Fenced>{}.step(x, 0.1).code() == hvi::Status::Code::not_finite);
    CHECK(Lobatto3Separable<systems::Fenced>{}.step(x, 0.1).code() ==
          hvi::Status::Code::not_finite);
    CHECK(StormerVerletSeparable<systems::Fenced>{}.step(x, 0.1).code() ==
          hvi::Status::Code::not_finite);
    CHECK(systems::same_bits(x, before));
}

TEST_CASE("a force that is not a number at the end of a step is a status") {
    // q goes from 0.9 to 1.05; the stages between stay below 1.
    hvi::State<systems::One> x{{0.9}, {2.0}};
    const auto before = x;
    CHECK(Lobatto3Separable<systems::Fenced>{}.step(x, 0.08).code() ==
          hvi::Status::Code::not_finite);
    CHECK(StormerVerletSeparable<systems::Fenced>{}.step(x, 0.08).code() ==
          hvi::Status::Code::not_finite);
    CHECK(systems::same_bits(x, before));
}

TEST_CASE("a new step size starts from the slope at the step's start") {
    struct Recording {
        using Vector = systems::One;
        double* first;  // the position of the first evaluation since it was set to NaN
        void dHdq(const Vector& q, Vector& out) const {
            if (std::isnan(*first)) { *first = q[0]; }
            out[0] = std::sin(q[0]);
        }
        void dHdp(const Vector& p, Vector& out) const { out = p; }
    };
    constexpr double unset = std::numeric_limits<double>::quiet_NaN();
    double first = unset;
    Gauss2Separable<Recording> stepper{Recording{&first}};
    hvi::State<systems::One> x{{0.5}, {1.0}};
    double last = 0.0;
    for (const double h : {0.1, 0.1, 0.1, 0.2, 0.2, -0.2}) {
        first = unset;
        const double start = x.q[0];
        REQUIRE(stepper.step(x, h).ok());
        CHECK((first == start) == (h != last));
        last = h;
    }
}

TEST_CASE("after a failure the next step is that of a fresh stepper") {
    Gauss2Separable<systems::Fenced> stepper;
    hvi::State<systems::One> x{{0.5}, {0.1}};
    for (int i = 0; i < 3; ++i) { REQUIRE(stepper.step(x, 0.1).ok()); }
    REQUIRE_FALSE(stepper.step(x, 1e6).ok());
    auto y = x;
    REQUIRE(stepper.step(x, 0.1).ok());
    REQUIRE(Gauss2Separable<systems::Fenced>{}.step(y, 0.1).ok());
    CHECK(systems::same_bits(x, y));
}

TEST_CASE("an explicit step evaluates each force once") {
    long forces = 0, velocities = 0;
    StormerVerletSeparable<systems::Kepler> verlet{systems::Kepler{&forces, &velocities}};
    State x = orbit;
    steps(verlet, x, 0.1, 10);
    CHECK(forces == 11);  // the first step has none kept
    CHECK(velocities == 10);
    x.q[0] += 1.0;
    steps(verlet, x, 0.1, 1);
    CHECK(forces == 13);

    forces = velocities = 0;
    SymplecticEulerSeparable<systems::Kepler> euler{systems::Kepler{&forces, &velocities}};
    steps(euler, x, 0.1, 10);
    CHECK(forces == 10);
    CHECK(velocities == 10);
}

TEST_CASE("lobatto:3 keeps the force at the end of a step") {
    long forces = 0;
    Lobatto3Separable<systems::Kepler> stepper{systems::Kepler{&forces, nullptr}};
    State x = orbit;
    steps(stepper, x, 0.1, 1);
    forces = 0;
    long iterations = 0;
    for (int i = 0; i < 10; ++i) {
        const hvi::Status status = stepper.step(x, 0.1);
        REQUIRE(status.ok());
        iterations += status.iterations;
    }
    // Each sweep evaluates the force at Q_2, the last one of a step only when something changed.
    CHECK(forces <= 10 + iterations);
}

TEST_CASE("every component is looked at, and copied, however many there are") {
    const double bad[] = {std::numeric_limits<double>::infinity(), std::nan("")};
    for (std::ptrdiff_t n = 1; n <= 9; ++n) {
        Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(n, -8e307, 8e307);
        Eigen::VectorXd copied = Eigen::VectorXd::Zero(n);
        CHECK(hvi::detail::finite(v, v));
        hvi::detail::copy(v, copied);
        CHECK(hvi::detail::same_bits(v, copied));
        for (std::ptrdiff_t k = 0; k < n; ++k) {
            for (const double value : bad) {
                copied[k] = value;
                CHECK_FALSE(hvi::detail::finite(v, copied));
                CHECK_FALSE(hvi::detail::finite(copied, v));
            }
            copied[k] = v[k];
        }
    }
}

TEST_CASE("starting values are worth iterations") {
    long kept = 0, fresh = 0;
    Gauss4<systems::AsGeneral<systems::Kepler>> stepper;
    State x = orbit;
    for (int i = 0; i < 20; ++i) {
        State y = x;
        const hvi::Status cold = Gauss4<systems::AsGeneral<systems::Kepler>>{}.step(y, 0.05);
        const hvi::Status warm = stepper.step(x, 0.05);
        REQUIRE(cold.ok());
        REQUIRE(warm.ok());
        if (i > 0) {
            fresh += cold.iterations;
            kept += warm.iterations;
        }
    }
    CHECK(kept + 19 < fresh);
}

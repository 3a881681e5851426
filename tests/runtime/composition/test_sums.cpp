// Explicit compositions of high order: what rounding cuts off is kept, with the state that it is
// of.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cfenv>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>
#include <catch2/catch.hpp>
#include <composition/adjoint_euler_blanes_moan_6.hpp>
#include <composition/driven_kahan_li_8.hpp>
#include <composition/kepler_blanes_moan_6.hpp>
#include <composition/kepler_kahan_li_8.hpp>
#include <composition/kepler_yoshida_8.hpp>
#include <composition/verlet_kahan_li_8.hpp>

#include "tests/runtime/run/systems.hpp"
#include "tests/runtime/scalars/scalars.hpp"

using namespace hvi::generated;

namespace {

/// H = p^2/2: no force at all.
template <class T>
struct Free {
    using Vector = std::array<T, 1>;
    constexpr void dHdq(const Vector&, Vector& out) const { out[0] = 0; }
    constexpr void dHdp(const Vector& p, Vector& out) const { out[0] = p[0]; }
};

/// Polynomials and quotients of polynomials: the compiler takes these steps as well.
template <class AnyVector = std::array<double, 2>>
struct Well {
    using Vector = AnyVector;
    constexpr void dHdq(const Vector& q, Vector& out) const {
        const double r2 = 1 + q[0] * q[0] + q[1] * q[1];
        out[0] = q[0] / (r2 * r2);
        out[1] = q[1] / (r2 * r2);
    }
    constexpr void dHdp(const Vector& p, Vector& out) const {
        out[0] = p[0];
        out[1] = p[1];
    }
};
using State = hvi::State<std::array<double, 2>>;
constexpr State in_well{{1.0, 0.0}, {0.0, 0.25}};

template <class Stepper, class StateOf>
constexpr bool steps(Stepper& stepper, StateOf& x, typename Stepper::Scalar h, int count) {
    bool ok = true;
    for (int i = 0; i < count; ++i) { ok = ok && stepper.step(x, h).ok(); }
    return ok;
}

template <class Stepper>
constexpr State after(int count) {
    Stepper stepper;
    State x = in_well;
    return steps(stepper, x, 0.0625, count) ? x : State{};
}

template <class StateOf>
bool same(const StateOf& x, const StateOf& y) {
    return hvi::detail::same_bits(x.q, y.q) && hvi::detail::same_bits(x.p, y.p);
}

/// Returns the distance of doubles from equal steps in long double, relative to the size of q and
/// p.
template <template <class, class> class Stepper>
double rounding(double h, int count) {
    Stepper<double, std::array<double, 2>> stepper;
    Stepper<long double, std::array<long double, 2>> wide_stepper;
    auto x = stepper.initial();
    auto y = wide_stepper.initial();
    for (std::size_t k = 0; k < 2; ++k) {
        y.q[k] = static_cast<long double>(x.q[k]);
        y.p[k] = static_cast<long double>(x.p[k]);
    }
    REQUIRE(steps(stepper, x, h, count));
    REQUIRE(steps(wide_stepper, y, static_cast<long double>(h), count));
    long double sum = 0, size = 0;
    for (std::size_t k = 0; k < 2; ++k) {
        const long double dq = static_cast<long double>(x.q[k]) - y.q[k];
        const long double dp = static_cast<long double>(x.p[k]) - y.p[k];
        sum += dq * dq + dp * dp;
        size += y.q[k] * y.q[k] + y.p[k] * y.p[k];
    }
    return static_cast<double>(std::sqrt(sum / size));
}

/// The root of the mean square of that over steps a little shorter, which rounding meets anew.
template <template <class, class> class Stepper>
double usual_rounding(double h, int count) {
    constexpr int runs = 16;
    double sum = 0;
    for (int i = 0; i < runs; ++i) {
        const double one = rounding<Stepper>(h * (1 - i * 0.007), count);
        sum += one * one;
    }
    return std::sqrt(sum / runs);
}

/// Checks an edit of one number against a new stepper.
template <class Stepper, class Edit>
void check_edit(const Edit& edit) {
    Stepper stepper;
    State x = in_well;
    REQUIRE(steps(stepper, x, 0.0625, 50));
    const State unedited = x;
    edit(x);
    State y = x;
    Stepper fresh;
    for (int i = 0; i < 20; ++i) {
        REQUIRE(steps(stepper, x, 0.0625, 1));
        REQUIRE(steps(fresh, y, 0.0625, 1));
        REQUIRE(same(x, y));
    }
    CHECK_FALSE(same(unedited, x));
}

template <class Stepper>
void check_memory() {
    check_edit<Stepper>([](State& x) { x.q[0] = std::nextafter(x.q[0], 9.0); });
    check_edit<Stepper>([](State& x) { x.q[1] = std::nextafter(x.q[1], 9.0); });
    check_edit<Stepper>([](State& x) { x.p[0] = std::nextafter(x.p[0], 9.0); });
    check_edit<Stepper>([](State& x) { x.p[1] = std::nextafter(x.p[1], 9.0); });

    // Remembered values show in the bits.
    Stepper stepper, forgetful, unasked;
    State x = in_well, y = in_well;
    REQUIRE(steps(stepper, x, 0.0625, 50));
    REQUIRE(steps(forgetful, y, 0.0625, 50));
    forgetful.reset();
    State z = y;
    REQUIRE(steps(stepper, x, 0.0625, 20));
    REQUIRE(steps(forgetful, y, 0.0625, 20));
    REQUIRE(steps(unasked, z, 0.0625, 20));
    CHECK(same(y, z));
    CHECK_FALSE(same(x, y));
}

using Verlet = VerletKahanLi8<Well<>>;
using AdjointEuler = AdjointEulerBlanesMoan6<Well<>>;

}  // namespace

TEMPLATE_TEST_CASE("a free particle goes as far as its time", "", HVI_SCALARS) {
    // From 1000 in 2^17 steps of 2^-7: the weights add up to 1 but for their rounding. Numbers of
    // the size of q are 1024 eps apart; plain sums are off by 2e8 eps.
    const TestType velocity = scalars::ratio<TestType>(1, 3);
    VerletKahanLi8<Free<TestType>> stepper;
    hvi::State<std::array<TestType, 1>> x{{1000}, {velocity}};
    REQUIRE(steps(stepper, x, TestType(0.0078125), 131072));
    const TestType off = hvi::detail::abs(x.q[0] - (1000 + 1024 * velocity));
    CHECK(scalars::at_most(off, 2048 * scalars::eps<TestType>));
    CHECK(x.p[0] == velocity);
}

TEST_CASE("rounding stays far below that of 17 sums a step") {
    // 5e-12, 6e-12 and 8e-12 with plain sums.
    CHECK(usual_rounding<BasicKeplerKahanLi8>(0.05, 4000) < 8e-13);
    CHECK(usual_rounding<BasicKeplerYoshida8>(0.02, 10000) < 1e-12);
    CHECK(usual_rounding<BasicKeplerBlanesMoan6>(0.02, 10000) < 5e-13);
}

TEST_CASE("remainders belong to a state, and reset() forgets them") {
    check_memory<Verlet>();
    check_memory<AdjointEuler>();
}

TEST_CASE("a step that fails, and one of size 0, leave remainders as they are") {
    Verlet stepper, untroubled;
    State x = in_well, y = in_well;
    REQUIRE(steps(stepper, x, 0.0625, 50));
    REQUIRE(steps(untroubled, y, 0.0625, 50));
    for (const double h : {1e200, 1e308, -1e308, HUGE_VAL}) {
        CHECK(stepper.step(x, h).code() == hvi::Status::Code::not_finite);
        REQUIRE(same(x, y));
    }
    REQUIRE(stepper.step(x, 0.0).ok());
    REQUIRE(steps(stepper, x, 0.0625, 50));
    REQUIRE(steps(untroubled, y, 0.0625, 50));
    CHECK(same(x, y));
}

TEST_CASE("a gradient that is no number is a status") {
    VerletKahanLi8<systems::Fenced> stepper;
    hvi::State<systems::One> x{{0.9}, {0.5}};
    const auto before = x;
    CHECK(stepper.step(x, 1.0).code() == hvi::Status::Code::not_finite);
    CHECK(same(x, before));
}

TEST_CASE("sums that do not round to nearest are a status") {
    Verlet stepper;
    State x = in_well;
    REQUIRE(std::fesetround(FE_UPWARD) == 0);
    const hvi::Status status = stepper.step(x, 0.0625);
    REQUIRE(std::fesetround(FE_TONEAREST) == 0);
    CHECK(status.code() == hvi::Status::Code::unsafe_arithmetic);
    CHECK(same(x, in_well));
}

TEST_CASE("a compiler that takes the steps comes to the same end") {
    constexpr State x = after<Verlet>(12);
    CHECK(same(x, after<Verlet>(12)));
    constexpr State y = after<AdjointEuler>(12);
    CHECK(same(y, after<AdjointEuler>(12)));
}

TEST_CASE("vectors of Eigen take the same steps") {
    VerletKahanLi8<Well<Eigen::VectorXd>> stepper;
    hvi::State<Eigen::VectorXd> x{Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d(0.0, 0.25)};
    REQUIRE(steps(stepper, x, 0.0625, 50));
    const State y = after<Verlet>(50);
    CHECK((x.q[0] == y.q[0] && x.q[1] == y.q[1] && x.p[0] == y.p[0] && x.p[1] == y.p[1]));

    // Another dimension is another state.
    hvi::State<Eigen::VectorXd> z{Eigen::VectorXd::Zero(3), Eigen::VectorXd::Zero(3)};
    REQUIRE(stepper.step(z, 0.0625).ok());
    CHECK(z.q == Eigen::VectorXd::Zero(3));
    z.p.resize(2);
    CHECK(stepper.step(z, 0.0625).code() == hvi::Status::Code::dimension_mismatch);
}

TEST_CASE("a force or velocity is kept for the next step") {
    long forces = 0, velocities = 0;
    State x{{1.0, 0.2}, {0.1, 0.9}};
    VerletKahanLi8<systems::Kepler> verlet{{&forces, &velocities}};
    REQUIRE(steps(verlet, x, 0.05, 10));
    CHECK(forces == 171);
    CHECK(velocities == 170);
    forces = velocities = 0;
    AdjointEulerBlanesMoan6<systems::Kepler> euler{{&forces, &velocities}};
    REQUIRE(steps(euler, x, 0.05, 10));
    CHECK(forces == 100);
    CHECK(velocities == 101);
}

TEST_CASE("forces that depend on the time") {
    // q'' = cos(2t), from rest at 1000: q = 1000 + (1 - cos 2t)/4.
    DrivenKahanLi8 stepper;
    DrivenKahanLi8::State x{};
    x.q[0] = 1000;
    REQUIRE(steps(stepper, x, 0.015625, 64 * 200));
    CHECK(x.t == 200);
    CHECK(std::abs(x.q[0] - 1000 - (1 - std::cos(400.0)) / 4) < 3e-13);
    // The time is a part of the state.
    x.t = 3;
    auto y = x;
    DrivenKahanLi8 fresh;
    REQUIRE(steps(stepper, x, 0.015625, 20));
    REQUIRE(steps(fresh, y, 0.015625, 20));
    CHECK(same(x, y));
}

// The order that compositions have, on problems that are separable and not, explicit and implicit.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstddef>

#include <catch2/catch.hpp>
#include <composition/driven_yoshida_4.hpp>
#include <composition/kepler_blanes_moan_6.hpp>
#include <composition/kepler_gauss_kahan_li_8.hpp>
#include <composition/kepler_kahan_li_8.hpp>
#include <composition/kepler_suzuki_4.hpp>
#include <composition/kepler_yoshida_4.hpp>
#include <composition/kepler_yoshida_6.hpp>
#include <composition/kepler_yoshida_8.hpp>
#include <composition/nonseparable_blanes_moan_6.hpp>
#include <composition/nonseparable_yoshida_6.hpp>
#include <composition/oscillator_gauss_yoshida_6.hpp>
#include <composition/oscillator_yoshida_8.hpp>

#include "tests/runtime/composition/order.hpp"

using namespace hvi::generated;
using Wide = long double;

namespace {

template <class Stepper>
double order(Wide until, int steps) {
    return hvi::tests::order<Stepper>(Stepper::initial(), until, steps);
}

/// Returns evaluations of dH/dq a step, without the first evaluation of all.
template <class Stepper>
double evaluations() {
    Stepper stepper;
    auto x = Stepper::initial();
    for (int i = 0; i < 101; ++i) { REQUIRE(stepper.step(x, 0.01L).ok()); }
    return static_cast<double>(stepper.evaluations() - 1) / 101;
}

}  // namespace

TEST_CASE("explicit steps on Kepler's problem") {
    CHECK(order<BasicKeplerYoshida4<Wide>>(6, 1600) == Approx(4).margin(0.05));
    CHECK(order<BasicKeplerSuzuki4<Wide>>(6, 800) == Approx(4).margin(0.05));
    CHECK(order<BasicKeplerYoshida6<Wide>>(6, 800) == Approx(6).margin(0.05));
    CHECK(order<BasicKeplerBlanesMoan6<Wide>>(6, 400) == Approx(6).margin(0.05));
    CHECK(order<BasicKeplerYoshida8<Wide>>(6, 800) == Approx(8).margin(0.1));
    CHECK(order<BasicKeplerKahanLi8<Wide>>(6, 400) == Approx(8).margin(0.25));
}

TEST_CASE("they evaluate a force for each of their steps") {
    CHECK(evaluations<BasicKeplerYoshida4<Wide>>() == 3);
    CHECK(evaluations<BasicKeplerSuzuki4<Wide>>() == 5);
    CHECK(evaluations<BasicKeplerYoshida6<Wide>>() == 7);
    // A step of symplectic Euler and the adjoint one before it have a force in common.
    CHECK(evaluations<BasicKeplerBlanesMoan6<Wide>>() == 10);
    CHECK(evaluations<BasicKeplerYoshida8<Wide>>() == 15);
    CHECK(evaluations<BasicKeplerKahanLi8<Wide>>() == 17);
}

TEST_CASE("implicit steps") {
    CHECK(order<BasicNonseparableYoshida6<Wide>>(2, 100) == Approx(6).margin(0.05));
    CHECK(order<BasicNonseparableBlanesMoan6<Wide>>(2, 50) == Approx(6).margin(0.1));
    // A method of order 4 is composed for order 8.
    CHECK(order<BasicKeplerGaussKahanLi8<Wide>>(3, 100) == Approx(8).margin(0.1));
}

TEST_CASE("steps of a quadratic H are one map") {
    // (1, 0) after the time 2.
    const auto error = [](auto stepper, int steps) {
        typename decltype(stepper)::State x{{1}, {0}};
        for (int i = 0; i < steps; ++i) { REQUIRE(stepper.step(x, Wide(2) / steps).ok()); }
        return std::hypot(x.q[0] - std::cos(Wide(2)), x.p[0] + std::sin(Wide(2)));
    };
    const auto explicit_order = std::log2(error(BasicOscillatorYoshida8<Wide>{}, 20) /
                                          error(BasicOscillatorYoshida8<Wide>{}, 40));
    CHECK(static_cast<double>(explicit_order) == Approx(8).margin(0.1));
    const auto linear_order = std::log2(error(BasicOscillatorGaussYoshida6<Wide>{}, 20) /
                                        error(BasicOscillatorGaussYoshida6<Wide>{}, 40));
    CHECK(static_cast<double>(linear_order) == Approx(6).margin(0.1));
    BasicOscillatorGaussYoshida6<Wide> stepper;
    auto x = BasicOscillatorGaussYoshida6<Wide>::initial();
    CHECK(stepper.step(x, 0.1L).iterations == 0);
}

TEST_CASE("explicit time goes on with each of the steps") {
    // q'' = cos(2t), from rest at 0: q = (1 - cos 2t)/4.
    const auto error = [](int steps) {
        BasicDrivenYoshida4<Wide> stepper;
        BasicDrivenYoshida4<Wide>::State x{};
        for (int i = 0; i < steps; ++i) { REQUIRE(stepper.step(x, Wide(3) / steps).ok()); }
        CHECK(static_cast<double>(x.t) == 3);
        return std::abs(x.q[0] - (1 - std::cos(Wide(6))) / 4);
    };
    CHECK(static_cast<double>(std::log2(error(200) / error(400))) == Approx(4).margin(0.1));
}

TEST_CASE("a step of size -h leads back") {
    const auto off = [](auto stepper) {
        const auto start = decltype(stepper)::initial();
        auto x = start;
        for (int i = 0; i < 10; ++i) { REQUIRE(stepper.step(x, 0.01L).ok()); }
        for (int i = 0; i < 10; ++i) { REQUIRE(stepper.step(x, -0.01L).ok()); }
        return hvi::tests::distance(x, start);
    };
    CHECK(off(BasicKeplerYoshida8<Wide>{}) < 1e-17L);
    CHECK(off(BasicKeplerBlanesMoan6<Wide>{}) < 1e-17L);
    CHECK(off(BasicKeplerGaussKahanLi8<Wide>{}) < 1e-17L);
    CHECK(off(BasicNonseparableYoshida6<Wide>{}) < 1e-17L);
}

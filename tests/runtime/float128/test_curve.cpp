// The derivative of steps of the general Galerkin form for any H is symplectic: in double by dual
// numbers, and in __float128 by differences.
// SPDX-License-Identifier: GPL-2.0-or-later
// NOTE: loops over small numbers copy them, which dual numbers are not.
#pragma GCC diagnostic ignored "-Wrange-loop-construct"

#include <array>
#include <cstddef>

#include <catch2/catch.hpp>
#include <driver/dual.hpp>
#include <driver/edge_symplectic.hpp>
#include <wide/curve.hpp>
#include <wide/curve_of_pendulums.hpp>

#include "numbers.hpp"

using namespace hvi::generated;
using namespace float128;

namespace {

using Steps = BasicWideCurve<Widest>;

Steps::State stepped(Widest q, Widest p) {
    Steps stepper;
    Steps::State x;
    x.q[0] = q;
    x.p[0] = p;
    CHECK(stepper.step(x, ratio(1, 4)).ok());
    return x;
}

/// The derivative of f at 0: central differences, extrapolated.
template <class F>
Widest derivative(F f) {
    constexpr std::size_t levels = 8;
    std::array<Widest, levels> table{};
    Widest h = ratio(1, 256);
    for (Widest& difference : table) {
        difference = (f(h) - f(-h)) / (2 * h);
        h /= 2;
    }
    Widest power = 1;
    for (std::size_t column = 1; column < levels; ++column) {
        power *= 4;
        for (std::size_t i = 0; i + column < levels; ++i) {
            table[i] = (power * table[i + 1] - table[i]) / (power - 1);
        }
    }
    return table[0];
}

}  // namespace

TEST_CASE("a step of the general form keeps areas to the last bits of __float128") {
    const Widest q = ratio(1, 2), p = ratio(1, 4);
    const auto by_q = [&](auto part) {
        return derivative([&](Widest d) { return part(stepped(q + d, p)); });
    };
    const auto by_p = [&](auto part) {
        return derivative([&](Widest d) { return part(stepped(q, p + d)); });
    };
    const auto q_of = [](const Steps::State& x) { return x.q[0]; };
    const auto p_of = [](const Steps::State& x) { return x.p[0]; };
    const Widest determinant = by_q(q_of) * by_p(p_of) - by_q(p_of) * by_p(q_of);
    CHECK(near(determinant, 1, is_quad ? Widest(1e-30L) : 10'000 * eps));
}

TEST_CASE("steps of the general form are symplectic, by dual numbers") {
    using Dual = hvi::driver::Dual<4>;
    using Pendulums = BasicWideCurveOfPendulums<Dual, std::array<Dual, 2>>;
    const auto defect =
        hvi::driver::SymplecticDefect<Pendulums>().of(Pendulums::initial(), 0.03125, 100);
    REQUIRE(defect);
    CHECK(*defect < 1e-15);
}

TEST_CASE("a symmetric rule undoes its steps in __float128") {
    Steps stepper;
    Steps::State x = Steps::initial();
    const Steps::State begin = x;
    for (const Widest h : {ratio(1, 16), ratio(-1, 16)}) {
        for (int i = 0; i < 100; ++i) { REQUIRE(stepper.step(x, h).ok()); }
    }
    CHECK(at_most(distance(x, begin), 1000 * eps));
}

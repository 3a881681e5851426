// Steps that the compiler computes.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>

#include <catch2/catch.hpp>
#include <hvi/generated/stormer_verlet_separable.hpp>
#include <scene/verlet_henon_heiles.hpp>

using namespace hvi::generated;

namespace {

struct Oscillator {
    using Vector = std::array<double, 1>;
    constexpr void dHdq(const Vector& q, Vector& out) const { out[0] = q[0]; }
    constexpr void dHdp(const Vector& p, Vector& out) const { out[0] = p[0]; }
};

template <class Stepper>
constexpr typename Stepper::State after(typename Stepper::State x, double h, int steps) {
    Stepper stepper;
    for (int i = 0; i < steps; ++i) {
        if (!stepper.step(x, h).ok()) { return {}; }
    }
    return x;
}

}  // namespace

TEST_CASE("explicit steps of polynomials are constant expressions") {
    constexpr auto x = after<VerletHenonHeiles>(VerletHenonHeiles::initial(), 0.125, 64);
    static_assert(x.q[0] != 0.0);
    volatile int steps = 64;
    const auto y = after<VerletHenonHeiles>(VerletHenonHeiles::initial(), 0.125, steps);
    CHECK(x.q[0] == Approx(y.q[0]).epsilon(1e-13));
    CHECK(x.p[1] == Approx(y.p[1]).epsilon(1e-13));

    // One step from (1, 0) with h = 1/2: p = -1/4, q = 7/8, p = -1/4 - 7/32.
    constexpr auto z = after<StormerVerletSeparable<Oscillator>>({{1.0}, {0.0}}, 0.5, 1);
    static_assert(z.q[0] == 0.875 && z.p[0] == -0.46875);
}

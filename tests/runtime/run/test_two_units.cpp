// Equal headers in two translation units; see second_unit.cpp. Here a header without a solver, with
// its own copy of State and Status, comes before the runtime, there after it.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>
#include <hvi/generated/gauss_2.hpp>
#include <hvi/generated/stormer_verlet_separable.hpp>
#include <hvi/generated/symplectic_euler_separable.hpp>

#include "systems.hpp"

hvi::Status step_in_second_unit(hvi::State<systems::One>& x, double h);

TEST_CASE("two units share a state") {
    using Verlet = hvi::generated::StormerVerletSeparable<systems::SeparableOscillator>;
    hvi::State<systems::One> x{{2.0}, {1.0}};
    hvi::State<systems::One> y = x;
    REQUIRE(Verlet{}.step(x, 0.1).ok());
    REQUIRE(step_in_second_unit(y, 0.1).ok());
    CHECK(systems::same_bits(x, y));
    REQUIRE(hvi::generated::Gauss2<systems::Oscillator>{}.step(x, 0.1).ok());
}

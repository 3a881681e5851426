// The energy where a compiler contracts a product and a sum to one operation.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include <catch2/catch.hpp>
#include <large/springs.hpp>
#include <large/springs_in_lanes.hpp>
#include <large/springs_one_by_one.hpp>

namespace generated = hvi::generated;

namespace {

/// Returns the relative change in 100 000 steps.
template <class Stepper, class State>
double change_of_energy(Stepper stepper, State x) {
    const double before = stepper.energy(x);
    for (int step = 0; step < 100'000; ++step) {
        if (!stepper.step(x, 0.05).ok()) { return 1; }
    }
    return std::abs(stepper.energy(x) / before - 1);
}

}  // namespace

// NOTE: if h v were rounded in the stages alone, the energy would change by 8e-14 in each case.
TEST_CASE("the energy of linear springs does not drift") {
    generated::Springs::Parameters parameters;
    parameters.N = 16;
    CHECK(change_of_energy(generated::Springs(parameters),
                           generated::Springs::initial(parameters)) < 3e-14);
    CHECK(change_of_energy(generated::SpringsInLanes(), generated::SpringsInLanes::initial()) <
          3e-14);
    CHECK(change_of_energy(generated::SpringsOneByOne(), generated::SpringsOneByOne::initial()) <
          3e-14);
}

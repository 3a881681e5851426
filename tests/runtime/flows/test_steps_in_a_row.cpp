// Steps in a row, which share the flow at their ends, beside single steps.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstdint>

#include <catch2/catch.hpp>
#include <hvi/detail/trajectories/flat.hpp>
#include <hvi/integrate.hpp>

#include "flows/free_kahan_li.hpp"
#include "flows/henon.hpp"
#include "flows/molecule_strang.hpp"
#include "flows/orbit.hpp"
#include "flows/planets.hpp"
#include "flows/ring_kahan_li.hpp"
#include "tests/runtime/flows/largest_difference.hpp"

namespace {

namespace made = hvi::generated;
using hvi::test::largest_difference;

/// Compares steps in a row with single ones, and with the way back.
template <class Stepper>
void check_steps_in_a_row(double h, std::int64_t steps, double tolerance) {
    const auto start = Stepper::initial({});
    Stepper single, row;
    auto x = start, y = start;
    for (std::int64_t k = 0; k < steps; ++k) { REQUIRE(single.step(x, h).ok()); }
    const hvi::Run run = row.advance(y, h, steps);
    REQUIRE(run.ok());
    CHECK(run.steps == steps);
    const auto& there = hvi::detail::flat<Stepper>(y);
    CHECK(largest_difference(hvi::detail::flat<Stepper>(x), there) <= tolerance);
    CHECK(largest_difference(hvi::detail::flat<Stepper>(start), there) > 1e3 * tolerance);
    REQUIRE(row.advance(y, -h, steps).ok());
    CHECK(largest_difference(hvi::detail::flat<Stepper>(start), hvi::detail::flat<Stepper>(y)) <=
          tolerance);
}

}  // namespace

TEST_CASE("steps in a row end where single steps end, and go back the way they came") {
    check_steps_in_a_row<made::Planets>(100, 1000, 1e-11);
    check_steps_in_a_row<made::RingKahanLi>(0.02, 500, 1e-12);
    check_steps_in_a_row<made::FreeKahanLi>(0.125, 400, 1e-12);
    check_steps_in_a_row<made::MoleculeStrang>(0.02, 500, 1e-10);
}

TEST_CASE("one step in a row has the bits of a single one, and none leaves the state") {
    made::Planets single, row;
    auto x = made::Planets::initial(), y = x;
    CHECK(row.advance(y, 50, 0).ok());
    CHECK(row.advance(y, 50, 0).steps == 0);
    CHECK(row.advance(y, 50, -3).steps == 0);
    CHECK(largest_difference(x, y) == 0);
    for (int k = 0; k < 10; ++k) {
        REQUIRE(single.step(x, 50).ok());
        REQUIRE(row.advance(y, 50, 1).ok());
    }
    CHECK(largest_difference(x, y) == 0);
    CHECK(row.advance(y, 0, 5).steps == 5);
    CHECK(largest_difference(x, y) == 0);
}

TEST_CASE("integrate takes steps in a row where nobody looks at them") {
    made::Planets row, whole;
    auto x = made::Planets::initial(), y = x;
    REQUIRE(row.advance(x, 50, 300).steps == 300);
    const hvi::Run run = hvi::integrate(whole, y, 0.0, 50.0, 300);
    CHECK(run.steps == 300);
    CHECK(largest_difference(x, y) == 0);
}

TEST_CASE("a step that fails in a row leaves the state after the last good step") {
    // NOTE: beyond its saddles Henon and Heiles's potential falls like -y^3/3, and y soon
    // overflows.
    auto x = made::Henon::initial();
    x.q = {0, 2};
    x.p = {0, 1};
    auto y = x;
    made::Henon single, row;
    std::int64_t good = 0;
    while (good < 1000 && single.step(x, 0.1).ok()) { ++good; }
    const hvi::Run run = row.advance(y, 0.1, 1000);
    CHECK(good > 5);
    CHECK(good < 1000);
    CHECK(run.steps == good);
    CHECK(run.status.code() == hvi::Status::Code::not_finite);
    CHECK(largest_difference(x, y) == 0);
}

TEST_CASE("a step of one flow has nothing to join") {
    STATIC_REQUIRE_FALSE(hvi::detail::Advances<made::Orbit>::value);
    STATIC_REQUIRE(hvi::detail::Advances<made::Planets>::value);
}

TEST_CASE("the energy of steps in a row does not drift from that of more digits") {
    using Long = made::BasicPlanets<long double>;
    made::Planets row;
    Long longer;
    auto x = made::Planets::initial();
    auto y = Long::initial();
    for (int k = 0; k < 10; ++k) {
        REQUIRE(row.advance(x, 50, 10000).ok());
        REQUIRE(longer.advance(y, 50, 10000).ok());
        const long double exact = longer.energy(y);
        CHECK(std::abs((static_cast<long double>(row.energy(x)) - exact) / exact) < 5e-15L);
    }
}

// Compositions with the adjoint of a rule that is not its own: their order, and steps back.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstddef>

#include <catch2/catch.hpp>
#include <rules/adjoint_bead.hpp>
#include <rules/adjoint_hoop.hpp>
#include <rules/adjoint_newton.hpp>
#include <rules/adjoint_nonseparable.hpp>
#include <rules/adjoint_pendulum.hpp>
#include <rules/adjoint_tableau_hoop.hpp>

#include "tests/runtime/composition/order.hpp"

using namespace hvi::generated;
using Wide = long double;

namespace {

template <class State>
State start() {
    State x;
    for (std::size_t k = 0; k < x.q.size(); ++k) {
        x.q[k] = Wide(3) / 10 + Wide(k) / 7;
        x.p[k] = Wide(4) / 10 - Wide(k) / 9;
    }
    return x;
}

template <class Stepper>
double order(Wide until, int steps) {
    return hvi::tests::order<Stepper>(start<typename Stepper::State>(), until, steps);
}

/// How far steps forth and back lead from the start.
template <class Stepper>
Wide way_back() {
    Stepper stepper;
    const auto begin = start<typename Stepper::State>();
    auto x = begin;
    for (const Wide h : {Wide(1) / 4, Wide(-1) / 4}) {
        for (int i = 0; i < 10; ++i) { REQUIRE(stepper.step(x, h).ok()); }
    }
    return hvi::tests::distance(x, begin);
}

template <template <class...> class Stepper, class... Rest>
void check_composition(Wide until, int steps) {
    using Wider = Stepper<Wide, Rest...>;
    CHECK(order<Wider>(until, steps) == Approx(6).margin(0.3));
    CHECK(way_back<Wider>() < 1e-16L);
}

}  // namespace

TEST_CASE("every second step is one of the adjoint: the order is 6, and steps lead back") {
    check_composition<BasicAdjointNonseparable>(2, 8);
    check_composition<BasicAdjointNewton>(2, 8);
    check_composition<BasicAdjointPendulum>(4, 8);
}

TEST_CASE("and where H depends on the time its nodes are 1 - c_i") {
    check_composition<BasicAdjointBead>(2, 8);
}

TEST_CASE("the same of Lagrangians, by rules and by tableaux") {
    check_composition<BasicAdjointHoop>(2, 8);
    check_composition<BasicAdjointTableauHoop>(2, 8);
}

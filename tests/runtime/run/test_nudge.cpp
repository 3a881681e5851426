// Iterations come to rest from one side in one step, and from the other side in the next.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/fixed_point.hpp>
#include <hvi/state.hpp>

#include "contracting_stages.hpp"

namespace {

/// Stages that can be nudged, and remember by what.
struct Nudged : contracting::Stages {
    bool side = false;
    double scale = 1;  ///< the size of W against Q
    std::vector<double> factors;
    std::vector<int> sweeps_before;
};

/// Q = 1 + scale W, W = (rate Q)/scale: for a large W as above, for a small one Q does not see it.
struct Coupled : contracting::Coupled<Nudged> {
    void nudge(double factor) {
        s.W *= factor;
        s.factors.push_back(factor);
        s.sweeps_before.push_back(s.sweeps);
    }
    void positions() {
        const double before = s.Q;
        s.Q = 1 + s.scale * s.W;
        s.change.q[0] = std::abs(s.Q - before);
    }
    void forces() {
        ++s.sweeps;
        s.W = s.rate * s.Q;
    }
};

hvi::Status solved(Nudged& s) {
    hvi::FixedPoint::Iteration<contracting::Vector> sweeps;
    return sweeps.solve(Coupled{{s}});
}

}  // namespace

TEST_CASE("slopes are moved once, to the other side in each step, when they are about to rest") {
    Nudged s;
    s.rate = 0.1;
    for (int step = 0; step < 4; ++step) {
        s.W = 0;
        s.side = step % 2 == 1;
        REQUIRE(solved(s).ok());
        CHECK(s.W == s.rate * s.Q);
    }
    REQUIRE(s.factors.size() == 4);
    for (std::size_t step = 0; step < 4; ++step) {
        CHECK(s.factors[step] == (step % 2 == 1 ? 1 + 0x1p-49 : 1 - 0x1p-49));
    }
    // 0.1^k is below 2^-53 from k = 16 on.
    CHECK(s.sweeps_before.front() >= 15);
    CHECK(s.sweeps_before.front() <= 18);
}

TEST_CASE("where few sweeps are enough none is added") {
    Nudged s;
    s.rate = 1e-4;
    REQUIRE(solved(s).ok());
    CHECK(s.factors.empty());
}

TEST_CASE("slopes that were moved too little for the stages to see are computed anew") {
    // In eight sweeps from far away; then scale W is below a unit of Q, and so is what moves it.
    Nudged s;
    s.rate = 0.01;
    s.scale = 0.01;
    s.W = 1e20;
    REQUIRE(solved(s).ok());
    REQUIRE(s.factors.size() == 1);
    CHECK(s.W == s.rate * s.Q);
}

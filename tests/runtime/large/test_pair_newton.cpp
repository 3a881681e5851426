// Newton's method of large scenes whose stages have momenta, by products of second derivatives,
// against Newton's method with matrices of the same scenes written out.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>
#include <large/driven_pairs.hpp>
#include <large/driven_pairs_out.hpp>
#include <large/hard_yoshida.hpp>
#include <large/hard_yoshida_out.hpp>
#include <large/nls.hpp>
#include <large/nls_2.hpp>
#include <large/nls_2_out.hpp>
#include <large/nls_3.hpp>
#include <large/nls_3_out.hpp>
#include <large/nls_auto.hpp>
#include <large/nls_fixed.hpp>
#include <large/nls_out.hpp>
#include <large/nls_verlet.hpp>
#include <large/nls_verlet_out.hpp>
#include <large/nls_yoshida.hpp>
#include <large/nls_yoshida_out.hpp>
#include <large/relativistic.hpp>
#include <large/relativistic_3.hpp>
#include <large/relativistic_3_out.hpp>
#include <large/relativistic_fixed.hpp>
#include <large/relativistic_out.hpp>

namespace {

using namespace hvi::generated;
using Failure = hvi::Status::Code;

/// How far apart 20 steps by loops and written out end, as a part of the largest number. `solves`
/// is how many systems of equations a step has; each takes few iterations, as those with the right
/// second derivatives do.
template <class Loops, class WrittenOut>
double apart_after_steps(double h, int solves = 1) {
    Loops loops(typename Loops::Parameters{});
    WrittenOut written_out(typename WrittenOut::Parameters{});
    auto x = Loops::initial();
    auto y = WrittenOut::initial();
    double distance = 0, size = 0;
    for (int step = 0; step < 20; ++step) {
        const hvi::Status status = loops.step(x, h);
        REQUIRE(status.ok());
        CHECK(status.iterations <= 16 * solves);
        REQUIRE(written_out.step(y, h).ok());
        for (std::size_t k = 0; k < y.q.size(); ++k) {
            distance = std::max({distance, std::abs(x.q[k] - y.q[k]), std::abs(x.p[k] - y.p[k])});
            size = std::max({size, std::abs(y.q[k]), std::abs(y.p[k])});
        }
    }
    return distance / size;
}

/// How far D^T J D is from J, for the derivative D of a step by its start from differences.
template <class Stepper>
double distance_from_symplectic(long double h) {
    const auto start = Stepper::initial();
    const std::size_t n = start.q.size();
    const auto ends_at = [&](std::size_t k, long double shift) {
        auto x = start;
        (k < n ? x.q[k] : x.p[k - n]) += shift;
        REQUIRE(Stepper(typename Stepper::Parameters{}).step(x, h).ok());
        return x;
    };
    const long double shift = 1e-6L;
    std::vector<decltype(ends_at(0, shift))> D;
    for (std::size_t k = 0; k < 2 * n; ++k) {
        auto above = ends_at(k, shift);
        const auto below = ends_at(k, -shift);
        for (std::size_t l = 0; l < n; ++l) {
            above.q[l] = (above.q[l] - below.q[l]) / (2 * shift);
            above.p[l] = (above.p[l] - below.p[l]) / (2 * shift);
        }
        D.push_back(above);
    }
    long double largest = 0;
    for (std::size_t a = 0; a < 2 * n; ++a) {
        for (std::size_t b = 0; b < 2 * n; ++b) {
            long double sum = b == a + n ? -1 : a == b + n ? 1 : 0;
            for (std::size_t l = 0; l < n; ++l) {
                sum += D[a].q[l] * D[b].p[l] - D[a].p[l] * D[b].q[l];
            }
            largest = std::max(largest, std::abs(sum));
        }
    }
    return static_cast<double>(largest);
}

}  // namespace

TEST_CASE("Newton's method by products for H that is not separable, as with matrices") {
    CHECK(apart_after_steps<Nls, NlsOut>(0.2) < 1e-14);
    CHECK(apart_after_steps<Nls2, Nls2Out>(0.2) < 1e-14);
    CHECK(apart_after_steps<Nls3, Nls3Out>(0.2) < 1e-14);
    CHECK(apart_after_steps<NlsYoshida, NlsYoshidaOut>(0.2, 3) < 1e-14);
}

TEST_CASE("Newton's method by products where blocks are solved in turn") {
    CHECK(apart_after_steps<NlsVerlet, NlsVerletOut>(0.02, 2) < 1e-13);
}

TEST_CASE("Newton's method by products for a kinetic energy that is not quadratic") {
    CHECK(apart_after_steps<Relativistic, RelativisticOut>(0.2) < 1e-14);
    CHECK(apart_after_steps<Relativistic3, Relativistic3Out>(0.2) < 1e-14);
}

TEST_CASE("Newton's method by products for pairs of all, with the time") {
    CHECK(apart_after_steps<DrivenPairs, DrivenPairsOut>(0.2) < 1e-13);
}

TEST_CASE(
    "Newton's method by products in a composition where the equations for positions are left") {
    CHECK(apart_after_steps<HardYoshida, HardYoshidaOut>(0.5, 3) < 1e-12);
}

TEST_CASE("fixed points do not converge where Newton's method by products does") {
    const auto check = [](auto stepper, auto x, double h) {
        const auto start = x;
        CHECK(stepper.step(x, h).code() == Failure::not_converged);
        CHECK(x.q == start.q);
        CHECK(x.p == start.p);
    };
    check(NlsFixed(), NlsFixed::initial(), 0.2);
    check(RelativisticFixed(), RelativisticFixed::initial(), 0.2);
}

TEST_CASE("without a wish fixed points hand over to Newton's method by products") {
    CHECK(apart_after_steps<NlsAuto, NlsOut>(0.2) < 1e-14);
    CHECK(apart_after_steps<NlsAuto, NlsOut>(0.05, 3) < 1e-14);
}

TEST_CASE("a step that Newton's method by products does not solve leaves the state as it is") {
    Nls stepper;
    auto x = Nls::initial();
    x.q[3] = std::numeric_limits<double>::max();
    const auto start = x;
    CHECK(!stepper.step(x, 0.2).ok());
    CHECK(x.q == start.q);
    CHECK(x.p == start.p);
    x = Nls::initial();
    CHECK(stepper.step(x, 0.2).ok());
}

TEST_CASE("equations that GMRES does not solve are not taken for solved") {
    Nls3::Parameters parameters;
    parameters.N = 100;
    Nls3 stepper(parameters);
    auto x = Nls3::initial(parameters);
    const auto start = x;
    CHECK(stepper.step(x, 20).code() == Failure::not_converged);
    CHECK(x.q == start.q);
    CHECK(x.p == start.p);
}

TEST_CASE("steps of Newton's method by products are symplectic") {
    CHECK(distance_from_symplectic<BasicNls<long double>>(0.2L) < 1e-9);
    CHECK(distance_from_symplectic<BasicNls3<long double>>(0.2L) < 1e-9);
    CHECK(distance_from_symplectic<BasicRelativistic3<long double>>(0.2L) < 1e-9);
}

TEST_CASE("what Newton's method by products conserves does not drift") {
    constexpr int steps = 10000;
    Nls stepper;
    auto x = Nls::initial();
    const double norm = stepper.norm(x);
    double largest = 0;
    for (int step = 0; step < steps; ++step) {
        REQUIRE(stepper.step(x, 0.2).ok());
        largest = std::max(largest, std::abs(stepper.norm(x) / norm - 1));
    }
    // The midpoint rule conserves what is quadratic; rounding alone is left, as a walk.
    CHECK(largest < 100 * std::numeric_limits<double>::epsilon());

    Relativistic3 chain;
    auto y = Relativistic3::initial();
    // NOTE: the motion from the start of the scene is chaotic, and where the error is largest is
    // seen at times that rounding decides.
    for (auto* part : {&y.q, &y.p}) {
        for (double& value : *part) { value /= 4; }
    }
    const double energy = chain.energy(y);
    std::array<double, 2> error{};  // of the first half and of the other
    for (int step = 0; step < steps; ++step) {
        REQUIRE(chain.step(y, 0.05).ok());
        double& half = error[2 * step < steps ? 0 : 1];
        half = std::max(half, std::abs(chain.energy(y) / energy - 1));
    }
    CHECK(error[0] > 0);
    CHECK(error[1] < 1.5 * error[0]);
}

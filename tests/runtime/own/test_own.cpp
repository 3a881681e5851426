// Scenes with functions of their own, against the same in closed form.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/ensemble.hpp>
#include <own/chain.hpp>
#include <own/chain_fixed.hpp>
#include <own/chain_gauss.hpp>
#include <own/chain_newton.hpp>
#include <own/closed.hpp>
#include <own/closed_chain.hpp>
#include <own/closed_composed.hpp>
#include <own/closed_explicit.hpp>
#include <own/closed_gauss.hpp>
#include <own/closed_of_pairs.hpp>
#include <own/closed_pairs.hpp>
#include <own/closed_waves.hpp>
#include <own/closed_wide.hpp>
#include <own/composed.hpp>
#include <own/ensemble.hpp>
#include <own/explicit.hpp>
#include <own/fixed.hpp>
#include <own/in_lanes.hpp>
#include <own/newton.hpp>
#include <own/pairs.hpp>
#include <own/pairs_newton.hpp>
#include <own/taylor.hpp>
#include <own/wavy.hpp>
#include <own/wavy_lanes.hpp>
#include <own/wavy_newton.hpp>
#include <own/widest.hpp>

using namespace hvi::generated;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Returns the distance of the numbers that both states have.
template <class A, class B>
double distance(const A& x, const B& y) {
    using Widest = hvi::math::Widest;
    REQUIRE(x.q.size() == y.q.size());
    double largest = 0;
    for (std::size_t k = 0; k < x.q.size(); ++k) {
        for (const Widest apart :
             {Widest(x.q[k]) - Widest(y.q[k]), Widest(x.p[k]) - Widest(y.p[k])}) {
            largest = std::fmax(largest, std::abs(static_cast<double>(apart)));
        }
    }
    return largest;
}

template <class Stepper>
typename Stepper::State moved(Stepper stepper, double h, int steps) {
    auto x = Stepper::initial();
    for (int i = 0; i < steps; ++i) {
        REQUIRE(stepper.step(x, static_cast<typename Stepper::Scalar>(h)).ok());
    }
    return x;
}

/// After so many steps from where both scenes begin, which move by much more.
template <class A, class B>
double apart(double h, int steps) {
    const auto end = moved(A(), h, steps);
    CHECK(distance(end, A::initial()) > 0.1);
    return distance(end, moved(B(), h, steps));
}

/// A matrix of one degree of freedom.
struct Entry {
    double value = 0;
    double& operator()(std::size_t, std::size_t) { return value; }
};

/// d2H/dq2, d2H/dqdp and d2H/dp2.
template <class Stepper>
std::vector<double> second_derivatives(double q_at, double p_at) {
    const typename Stepper::System system{typename Stepper::Parameters{}};
    const typename Stepper::Vector q{q_at}, p{p_at};
    Entry qq, qp, pp;
    system.d2Hdq2(q, p, qq);
    system.d2Hdqdp(q, p, qp);
    system.d2Hdp2(q, p, pp);
    return {qq.value, qp.value, pp.value};
}

}  // namespace

TEST_CASE("a potential in a header moves a body as its closed form does") {
    CHECK(apart<OwnExplicit, ClosedExplicit>(0.05, 100) < 200 * eps);
    CHECK(apart<OwnComposed, ClosedComposed>(0.05, 100) < 200 * eps);
    CHECK(apart<OwnFixed, Closed>(0.05, 100) < 200 * eps);
    CHECK(apart<OwnNewton, Closed>(0.05, 100) < 200 * eps);
    CHECK(apart<OwnTaylor, Closed>(0.05, 100) < 200 * eps);
    CHECK(apart<OwnLanes, Closed>(0.05, 100) < 200 * eps);
}

TEST_CASE("the energy and invariants call it too") {
    const auto x = moved(OwnExplicit(), 0.05, 10);
    CHECK(OwnExplicit().energy(x) == Approx(ClosedExplicit().energy(x)).epsilon(1e-14));
    CHECK(OwnExplicit().well(x) == Approx(ClosedExplicit().well(x)).epsilon(1e-14));
}

TEST_CASE("in other numbers it is the template of these") {
    using hvi::math::Widest;
    CHECK(apart<BasicOwnExplicit<long double>, BasicClosedExplicit<long double>>(0.05, 100) <
          1e-16);
    CHECK(apart<BasicOwnExplicit<float>, BasicClosedExplicit<float>>(0.05, 100) < 1e-4);
    const double most = hvi::detail::bits<Widest> > 64 ? 1e-30 : 1e-16;
    CHECK(apart<BasicOwnWide<Widest>, BasicClosedWide<Widest>>(0.05, 40) < most);
}

TEST_CASE("trajectories side by side are those alone") {
    std::vector<OwnEnsemble::Trajectory> starts(11, OwnEnsemble::initial());
    for (std::size_t i = 0; i < starts.size(); ++i) {
        starts[i].q[0] += 0.01 * static_cast<double>(i);
    }
    hvi::Ensemble<OwnEnsemble> all(starts);
    all.advance(0.05, 40, 1);
    for (std::size_t i = 0; i < all.size(); ++i) {
        auto x = ClosedExplicit::initial();
        x.q[0] += 0.01 * static_cast<double>(i);
        ClosedExplicit alone;
        for (int k = 0; k < 40; ++k) { REQUIRE(alone.step(x, 0.05).ok()); }
        CHECK(distance(all.state(i), x) < 200 * eps);
    }
}

TEST_CASE("functions of two arguments have mixed derivatives") {
    CHECK(apart<OwnWaves, ClosedWaves>(0.1, 50) < 200 * eps);
    CHECK(apart<OwnWavesNewton, ClosedWaves>(0.1, 50) < 200 * eps);
    CHECK(apart<OwnWavesLanes, ClosedWaves>(0.1, 50) < 200 * eps);
    const auto x = OwnWaves::initial();
    CHECK(OwnWaves().energy(x) == Approx(ClosedWaves().energy(x)).epsilon(1e-14));
    const auto own = second_derivatives<OwnWavesNewton>(0.7, -0.4);
    const auto closed = second_derivatives<ClosedWaves>(0.7, -0.4);
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(std::abs(closed[k]) > 0.01);
        CHECK(own[k] == Approx(closed[k]).epsilon(1e-14));
    }
}

TEST_CASE("sums over springs and over pairs call a potential in a header") {
    CHECK(apart<OwnChain, ClosedChain>(0.05, 100) < 1000 * eps);
    CHECK(apart<OwnPairs, ClosedPairs>(0.05, 100) < 1000 * eps);
    const auto x = OwnChain::initial();
    CHECK(OwnChain().energy(x) == Approx(ClosedChain().energy(x)).epsilon(1e-13));
    CHECK(OwnPairs().energy(x) == Approx(ClosedPairs().energy(x)).epsilon(1e-13));
    CHECK(apart<OwnChainGauss, ClosedChainGauss>(0.05, 100) < 1000 * eps);
    CHECK(apart<OwnChainFixed, ClosedChainGauss>(0.05, 100) < 1000 * eps);
    CHECK(apart<OwnChainNewton, ClosedChainGauss>(0.05, 100) < 1000 * eps);
    CHECK(apart<OwnPairsNewton, ClosedPairsGauss>(0.05, 100) < 1000 * eps);
}

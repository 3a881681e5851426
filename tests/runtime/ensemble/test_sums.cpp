// Explicit compositions of high order: each trajectory carries what rounding cuts off from it.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cfenv>
#include <cmath>

#include <catch2/catch.hpp>

#include "steppers.hpp"

using namespace ensemble_test;

namespace {

/// Returns the largest distance of an ensemble of doubles from steppers of one trajectory in long
/// double, relative to the size of q and p. Both start at equal doubles.
template <class Many, class WideOne>
double rounding(double h, int steps) {
    const auto x = starts<Many>(10);
    hvi::Ensemble<Many> ensemble(x);
    ensemble.advance(h, steps);
    REQUIRE(ensemble.ok());
    long double worst = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        WideOne stepper;
        typename WideOne::State y;
        for (std::size_t k = 0; k < dimension<Many>; ++k) {
            y.q[k] = static_cast<long double>(x[i].q[k]);
            y.p[k] = static_cast<long double>(x[i].p[k]);
        }
        for (int step = 0; step < steps; ++step) {
            REQUIRE(stepper.step(y, static_cast<long double>(h)).ok());
        }
        long double sum = 0, size = 0;
        for (std::size_t k = 0; k < dimension<Many>; ++k) {
            const long double dq = static_cast<long double>(ensemble.state(i).q[k]) - y.q[k];
            const long double dp = static_cast<long double>(ensemble.state(i).p[k]) - y.p[k];
            sum += dq * dq + dp * dp;
            size += y.q[k] * y.q[k] + y.p[k] * y.p[k];
        }
        worst = std::fmax(worst, std::sqrt(sum / size));
    }
    return static_cast<double>(worst);
}

}  // namespace

TEST_CASE("rounding of an ensemble stays far below that of 17 sums a step") {
    // 1.4e-11, 2.8e-13 and 2.5e-13 with plain sums.
    CHECK(rounding<made::KahanLiKeplers, made::BasicKahanLiKepler<long double>>(0.02, 4000) <
          2e-12);
    CHECK(rounding<made::Yoshida6Chains, made::BasicYoshida6Chain<long double>>(0.02, 4000) <
          8e-14);
    CHECK(rounding<made::AdjointEulerPendulums, made::BasicAdjointEulerPendulum<long double>>(
              0.02, 4000) < 2e-14);
}

TEST_CASE("free particles go as far as their time") {
    // Numbers of the size of q are 1024 eps apart, and 17 plain sums in each of 2^17 steps round.
    std::vector<made::KahanLiFrees::Trajectory> x(11, made::KahanLiFrees::initial());
    for (std::size_t i = 0; i < x.size(); ++i) { x[i].p[0] = 1 / (3.0 + static_cast<double>(i)); }
    hvi::Ensemble<made::KahanLiFrees> ensemble(x);
    ensemble.advance(0.0078125, 131072);
    REQUIRE(ensemble.ok());
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double off = ensemble.state(i).q[0] - (1000 + 1024 * x[i].p[0]);
        CHECK(std::abs(off) <= 2048 * 0x1p-52);
        CHECK(ensemble.state(i).p[0] == x[i].p[0]);
    }
}

TEMPLATE_TEST_CASE("remainders go from one call of advance() to the next", "", KahanLiKepler,
                   Yoshida6Chain, AdjointEulerPendulum) {
    using Many = typename TestType::Many;
    const auto x = starts<Many>(9);
    hvi::Ensemble<Many> at_once(x), in_parts(x), from_states(x);
    at_once.advance(0.0625, 60);
    in_parts.advance(0.0625, 20);
    in_parts.advance(0.0625, 40);
    from_states.advance(0.0625, 20);
    std::vector<typename Many::Trajectory> half_way;
    for (std::size_t i = 0; i < x.size(); ++i) { half_way.push_back(from_states.state(i)); }
    hvi::Ensemble<Many> others(half_way);
    others.advance(0.0625, 40);
    bool all_forget = true;
    for (std::size_t i = 0; i < x.size(); ++i) {
        CHECK(same_bits(at_once.state(i), in_parts.state(i)));
        all_forget = all_forget && same_bits(at_once.state(i), others.state(i));
    }
    CHECK_FALSE(all_forget);  // what there is to be carried shows in the bits
}

TEMPLATE_TEST_CASE("sums that do not round to nearest stop all", "", KahanLiKepler, Gauss4Kepler) {
    using Many = typename TestType::Many;
    const auto x = starts<Many>(9);
    hvi::Ensemble<Many> ensemble(x);
    ensemble.advance(0.0625, 3, 1);
    const auto before = ensemble;
    REQUIRE(std::fesetround(FE_UPWARD) == 0);
    ensemble.advance(0.0625, 3, 1);
    REQUIRE(std::fesetround(FE_TONEAREST) == 0);
    for (std::size_t i = 0; i < x.size(); ++i) {
        CHECK(ensemble.status(i).code() == hvi::Status::Code::unsafe_arithmetic);
        CHECK(ensemble.steps(i) == 3);
        CHECK(same_bits(ensemble.state(i), before.state(i)));
    }
}

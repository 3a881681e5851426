// Rules on quadratic Hamiltonians: a step is one linear map.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <catch2/catch.hpp>
#include <rules/chain.hpp>
#include <rules/composed_oscillator.hpp>
#include <rules/composed_rotating.hpp>
#include <rules/iterated_chain.hpp>
#include <rules/iterated_composed_rotating.hpp>
#include <rules/iterated_rotating.hpp>
#include <rules/one_oscillator.hpp>
#include <rules/rotating.hpp>

using namespace hvi::generated;

namespace {

/// How far two steppers are from each other after steps forth and back of two sizes.
template <class Tabulated, class Iterated>
double difference() {
    Tabulated tabulated;
    Iterated iterated;
    typename Tabulated::State x;
    typename Iterated::State y;
    for (std::size_t k = 0; k < x.q.size(); ++k) {
        x.q[k] = y.q[k] = 0.5 - 0.3 * static_cast<double>(k);
        x.p[k] = y.p[k] = 0.25 * static_cast<double>(k) - 0.125;
    }
    double result = 0;
    for (int i = 0; i < 1000; ++i) {
        const double h = i < 700 ? 0.1 : -0.05;
        const hvi::Status status = tabulated.step(x, h);
        REQUIRE(status.ok());
        CHECK(status.iterations == 0);
        REQUIRE(iterated.step(y, h).ok());
        for (std::size_t k = 0; k < x.q.size(); ++k) {
            result = std::max({result, std::abs(x.q[k] - y.q[k]), std::abs(x.p[k] - y.p[k])});
        }
    }
    return result;
}

/// The largest entry of D^T J D - J for the matrix D of a step without offset.
template <class Stepper>
double defect(double h) {
    using State = typename Stepper::State;
    constexpr std::size_t n = std::tuple_size_v<typename Stepper::Vector>;
    std::array<State, 2 * n> D;
    for (std::size_t k = 0; k < 2 * n; ++k) {
        D[k].q.fill(0);
        D[k].p.fill(0);
        (k < n ? D[k].q[k] : D[k].p[k - n]) = 1;
        REQUIRE(Stepper().step(D[k], h).ok());
    }
    const auto product = [](double a, double b) {
        return static_cast<long double>(a) * static_cast<long double>(b);
    };
    double largest = 0;
    for (std::size_t i = 0; i < 2 * n; ++i) {
        for (std::size_t j = 0; j < 2 * n; ++j) {
            long double sum = j == i + n ? -1 : (i == j + n ? 1 : 0);
            for (std::size_t k = 0; k < n; ++k) {
                sum += product(D[i].q[k], D[j].p[k]) - product(D[i].p[k], D[j].q[k]);
            }
            largest = std::max(largest, static_cast<double>(std::abs(sum)));
        }
    }
    return largest;
}

/// Returns the largest relative change in `steps` steps of the form that a map (A B; C D) with
/// determinant 1 conserves: B p^2 + (A - D) q p - C q^2.
template <class Stepper>
double drift(double h, int steps) {
    typename Stepper::State first{{1}, {0}}, second{{0}, {1}}, x{{0.75}, {-0.5}};
    REQUIRE(Stepper().step(first, h).ok());
    REQUIRE(Stepper().step(second, h).ok());
    const auto conserved = [&] {
        const double q = x.q[0], p = x.p[0];
        return second.q[0] * p * p + (first.q[0] - second.p[0]) * q * p - first.p[0] * q * q;
    };
    const double begin = conserved();
    Stepper stepper;
    double result = 0;
    for (int i = 0; i < steps; ++i) {
        REQUIRE(stepper.step(x, h).ok());
        result = std::max(result, std::abs(conserved() / begin - 1));
    }
    return result;
}

}  // namespace

TEST_CASE("the map of a rule is its step, whatever h was before") {
    CHECK(difference<RuleChain, IteratedRuleChain>() < 1e-13);
    CHECK(difference<RuleRotating, IteratedRuleRotating>() < 1e-13);
    CHECK(difference<ComposedRuleRotating, IteratedComposedRotating>() < 1e-13);
}

TEST_CASE("one function and two Gauss nodes on the oscillator, by hand") {
    // V = P_1 = P_2 as H is p^2/2 + q^2/2, and (4.6d) says V = p - h sum_i b_i (1 - c_i) Q_i with
    // Q_i = q + c_i h V, where the sum of b_i c_i (1 - c_i) is 1/6.
    for (const double h : {0.01, 0.5, -2.0}) {
        OneOscillator stepper;
        OneOscillator::State x{{0.75}, {-1.25}};
        const double V = (x.p[0] - h * x.q[0] / 2) / (1 + h * h / 6);
        const double q = x.q[0] + h * V, p = x.p[0] - h * (x.q[0] + h * V / 2);
        REQUIRE(stepper.step(x, h).ok());
        CHECK(std::abs(x.q[0] - q) < 1e-15 * (1 + std::abs(h * V)));
        CHECK(std::abs(x.p[0] - p) < 1e-15 * (1 + h * h));
    }
}

TEST_CASE("maps of rules are symplectic as far as rounding lets see") {
    for (const double h : {0.01, 0.3, 1.5, -1.0}) {
        CAPTURE(h);
        CHECK(defect<OneOscillator>(h) < 1e-15);
        CHECK(defect<ComposedRuleOscillator>(h) < 1e-15);
        CHECK(defect<RuleRotating>(h) < 4e-15);
        CHECK(defect<ComposedRuleRotating>(h) < 4e-15);
    }
}

TEST_CASE("what the map conserves does not drift") {
    // NOTE: rounding makes it walk; a map that is rounded would let it drift by 1e-11.
    CHECK(drift<OneOscillator>(0.1, 100000) < 2e-13);
    CHECK(drift<ComposedRuleOscillator>(0.3, 100000) < 2e-13);
}

// Splittings of H in parts that do not commute: orders, what is kept, and the way back.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <cstddef>

#include <catch2/catch.hpp>

#include "flows/charged_gauss.hpp"
#include "flows/charged_kahan_li.hpp"
#include "flows/disturbed_10_6_4.hpp"
#include "flows/disturbed_2.hpp"
#include "flows/disturbed_8_4.hpp"
#include "flows/disturbed_gauss.hpp"
#include "flows/free_gauss.hpp"
#include "flows/free_kahan_li.hpp"
#include "flows/free_strang.hpp"
#include "flows/ring_8_4.hpp"
#include "flows/ring_gauss.hpp"
#include "flows/ring_kahan_li.hpp"
#include "flows/ring_strang.hpp"
#include "flows/three_kahan_li.hpp"
#include "flows/top_gauss.hpp"
#include "flows/top_kahan_li.hpp"

namespace {

namespace made = hvi::generated;

template <class Stepper>
auto after(double until, int steps, typename Stepper::Parameters parameters = {}) {
    Stepper stepper(parameters);
    auto x = Stepper::initial(parameters);
    for (int k = 0; k < steps; ++k) { REQUIRE(stepper.step(x, until / steps).ok()); }
    return x;
}

template <class Numbers>
double distance(const Numbers& left, const Numbers& right) {
    double largest = 0;
    for (std::size_t k = 0; k < left.size(); ++k) {
        largest = std::max(largest, std::abs(left[k] - right[k]));
    }
    return largest;
}

template <class Left, class Right>
double error(const Left& x, const Right& reference) {
    return std::max(distance(x.q, reference.q), distance(x.p, reference.p));
}

/// Returns the order that the error shows between two numbers of steps.
template <class Stepper, class Reference>
double order(const Reference& reference, double until, int steps) {
    const double coarse = error(after<Stepper>(until, steps), reference);
    const double fine = error(after<Stepper>(until, 2 * steps), reference);
    return std::log2(coarse / fine);
}

}  // namespace

// NOTE: the references are of another method, gauss:8, which solves equations of the whole H.

TEST_CASE("splittings of three parts have the order that they have for two") {
    const auto reference = after<made::RingGauss>(1, 100);
    CHECK(order<made::RingStrang>(reference, 1, 40) == Approx(2).margin(0.05));
    CHECK(order<made::Ring84>(reference, 1, 20) == Approx(4).margin(0.15));
    CHECK(order<made::RingKahanLi>(reference, 1, 5) == Approx(8).margin(0.6));
}

TEST_CASE("a splitting stays near what single parts do not keep") {
    made::RingStrang stepper;
    auto x = made::RingStrang::initial();
    const double norm = stepper.norm(x);
    for (int k = 0; k < 10'000; ++k) { REQUIRE(stepper.step(x, 0.05).ok()); }
    // NOTE: the hops of q alone, and of p alone, do not keep the norm.
    CHECK(std::abs(stepper.norm(x) - norm) < 1e-2);
    CHECK(std::abs(stepper.norm(x) - norm) > 1e-12);
}

TEST_CASE("errors of splittings for small parts fall with the part as their orders say") {
    const auto energy_error = [&](auto stepper, double eps, int steps) {
        using Stepper = decltype(stepper);
        typename Stepper::Parameters parameters;
        parameters.eps = eps;
        Stepper it(parameters);
        auto x = Stepper::initial(parameters);
        const double before = it.energy(x);
        double largest = 0;
        for (int k = 0; k < steps; ++k) {
            REQUIRE(it.step(x, 8.0 / steps).ok());
            largest = std::max(largest, std::abs(it.energy(x) - before));
        }
        return largest;
    };
    // saba:2 has the error eps h^4 + eps^2 h^2; the first is seen where eps is small, the second
    // where h is.
    const double small = energy_error(made::Disturbed2{}, 1e-8, 8);
    CHECK(std::log2(small / energy_error(made::Disturbed2{}, 1e-8, 16)) == Approx(4).margin(0.3));
    const double large = energy_error(made::Disturbed2{}, 0.2, 400);
    CHECK(std::log2(large / energy_error(made::Disturbed2{}, 0.2, 800)) == Approx(2).margin(0.1));
    // (8, 4): eps h^8, and eps^2 h^4.
    const double eighth = energy_error(made::Disturbed84{}, 1e-4, 6);
    CHECK(std::log2(eighth / energy_error(made::Disturbed84{}, 1e-4, 12)) == Approx(8).margin(1.0));
    const double fourth = energy_error(made::Disturbed84{}, 0.2, 100);
    CHECK(std::log2(fourth / energy_error(made::Disturbed84{}, 0.2, 200)) == Approx(4).margin(0.2));
    // (10, 6, 4): with a large part the last one.
    const double last = energy_error(made::Disturbed1064{}, 0.2, 40);
    CHECK(std::log2(last / energy_error(made::Disturbed1064{}, 0.2, 80)) == Approx(4).margin(0.6));
}

TEST_CASE("splittings for small parts come to the solution") {
    const auto reference = after<made::DisturbedGauss>(10, 200);
    CHECK(error(after<made::Disturbed1064>(10, 40), reference) < 1e-11);
    CHECK(error(after<made::Disturbed84>(10, 100), reference) < 1e-9);
}

TEST_CASE("a free body is split in turns about its three axes") {
    const auto reference = after<made::FreeGauss>(4, 400);
    const auto distance_of = [&](const auto& x) {
        return std::max(distance(x.R, reference.R), distance(x.L, reference.L));
    };
    const double coarse = distance_of(after<made::FreeStrang>(4, 40));
    const double fine = distance_of(after<made::FreeStrang>(4, 80));
    CHECK(std::log2(coarse / fine) == Approx(2).margin(0.05));
    CHECK(distance_of(after<made::FreeKahanLi>(4, 20)) < 1e-9);
}

TEST_CASE("turns keep the momentum of a free body to round-off over many steps") {
    made::FreeKahanLi stepper;
    auto x = made::FreeKahanLi::initial();
    const double J_1 = stepper.J_1(x), J_2 = stepper.J_2(x), J_3 = stepper.J_3(x);
    const double energy = stepper.energy(x);
    for (int k = 0; k < 20'000; ++k) { REQUIRE(stepper.step(x, 0.25).ok()); }
    CHECK(std::abs(stepper.J_1(x) - J_1) < 2e-14);
    CHECK(std::abs(stepper.J_2(x) - J_2) < 2e-14);
    CHECK(std::abs(stepper.J_3(x) - J_3) < 2e-14);
    CHECK(std::abs(stepper.energy(x) - energy) < 1e-9);
    double defect = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            double sum = i == j ? -1 : 0;
            for (std::size_t k = 0; k < 3; ++k) { sum += x.R[3 * i + k] * x.R[3 * j + k]; }
            defect = std::max(defect, std::abs(sum));
        }
    }
    CHECK(defect < 1e-13);
}

TEST_CASE("bodies that do not meet turn as each of them alone") {
    // NOTE: the last one turns by more than 1 in some flows, which then are small for none of them.
    made::ThreeKahanLi together;
    auto x = made::ThreeKahanLi::initial();
    std::array<made::FreeKahanLi, 3> alone;
    std::array<made::FreeKahanLi::State, 3> y;
    for (std::size_t k = 0; k < 3; ++k) {
        y[k] = made::FreeKahanLi::initial();
        y[k].L = x.L[k];
    }
    for (int step = 0; step < 20; ++step) {
        REQUIRE(together.step(x, 0.25).ok());
        for (std::size_t k = 0; k < 3; ++k) { REQUIRE(alone[k].step(y[k], 0.25).ok()); }
    }
    for (std::size_t k = 0; k < 3; ++k) {
        CAPTURE(k);
        CHECK(distance(x.R[k], y[k].R) < 1e-11);
        CHECK(distance(x.L[k], y[k].L) < 1e-11);
    }
}

TEST_CASE("a heavy top is split in three turns and a torque") {
    const auto reference = after<made::TopGauss>(3, 300);
    const auto x = after<made::TopKahanLi>(3, 30);
    CHECK(std::max(distance(x.R, reference.R), distance(x.L, reference.L)) < 1e-9);
    made::TopKahanLi stepper;
    auto y = made::TopKahanLi::initial();
    const double J_z = stepper.J_z(y);
    for (int k = 0; k < 5'000; ++k) { REQUIRE(stepper.step(y, 0.1).ok()); }
    CHECK(std::abs(stepper.J_z(y) - J_z) < 1e-13);
}

TEST_CASE("a form that couples degrees of freedom is a part beside turns of a body") {
    const auto reference = after<made::ChargedGauss>(3, 300);
    const auto x = after<made::ChargedKahanLi>(3, 150);
    CHECK(std::max(distance(x.q, reference.q), distance(x.p, reference.p)) < 1e-12);
    CHECK(std::max(distance(x.R, reference.R), distance(x.L, reference.L)) < 1e-12);
}

TEST_CASE("a step of flows with -h leads back") {
    made::TopKahanLi stepper;
    auto x = made::TopKahanLi::initial();
    const auto start = x;
    for (int k = 0; k < 50; ++k) { REQUIRE(stepper.step(x, 0.1).ok()); }
    for (int k = 0; k < 50; ++k) { REQUIRE(stepper.step(x, -0.1).ok()); }
    CHECK(distance(x.R, start.R) < 1e-13);
    CHECK(distance(x.L, start.L) < 1e-13);
}

// The time, curves, actions, free parameters and wide numbers of steppers whose sums stay loops,
// against the same written out.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/detail/numbers/math.hpp>
#include <large/driven.hpp>
#include <large/driven_128.hpp>
#include <large/driven_128_out.hpp>
#include <large/driven_fit.hpp>
#include <large/driven_fit_out.hpp>
#include <large/driven_fixed.hpp>
#include <large/driven_fixed_out.hpp>
#include <large/driven_newton.hpp>
#include <large/driven_newton_out.hpp>
#include <large/driven_out.hpp>
#include <large/driven_verlet.hpp>
#include <large/driven_verlet_out.hpp>
#include <large/in_functions.hpp>
#include <large/in_functions_out.hpp>
#include <large/in_time.hpp>
#include <large/in_time_out.hpp>
#include <large/mean_field.hpp>
#include <large/mean_field_gauss.hpp>
#include <large/mean_field_out.hpp>
#include <large/rails.hpp>
#include <large/rails_out.hpp>
#include <large/springs_128.hpp>

namespace {

using namespace hvi::generated;

/// The largest distance of numbers of two vectors.
template <class Loops, class WrittenOut>
auto apart(const Loops& a, const WrittenOut& b) {
    REQUIRE(a.size() == b.size());
    auto largest = hvi::detail::abs(a[0] - b[0]);
    for (std::size_t k = 0; k < b.size(); ++k) {
        largest = std::max(largest, hvi::detail::abs(a[k] - b[k]));
    }
    return largest;
}

/// Steps of both from where the scene begins: the largest distance on the way. `see` looks at both
/// steppers and states after each.
template <class Loops, class WrittenOut, class See>
double distance_on_the_way(double h, int steps, See see) {
    Loops loops(typename Loops::Parameters{});
    WrittenOut written_out(typename WrittenOut::Parameters{});
    auto x = Loops::initial();
    auto y = WrittenOut::initial();
    double largest = 0;
    for (int step = 0; step < steps; ++step) {
        REQUIRE(loops.step(x, h).ok());
        REQUIRE(written_out.step(y, h).ok());
        largest = std::max({largest, apart(x.q, y.q), apart(x.p, y.p)});
        see(loops, x, written_out, y);
    }
    return largest;
}

template <class Loops, class WrittenOut>
double distance_on_the_way(double h, int steps) {
    return distance_on_the_way<Loops, WrittenOut>(
        h, steps, [](const auto&, const auto&, const auto&, const auto&) {});
}

}  // namespace

TEST_CASE("the time in sums") {
    const auto same_energy = [](const auto& loops, const auto& x, const auto& out, const auto& y) {
        CHECK(x.t == y.t);
        CHECK(std::abs(loops.energy(x) - out.energy(y)) < 1e-13);
    };
    CHECK(distance_on_the_way<Driven, DrivenOut>(0.1, 50, same_energy) < 1e-14);
    CHECK(distance_on_the_way<DrivenVerlet, DrivenVerletOut>(0.1, 50) < 1e-14);
    CHECK(distance_on_the_way<InTime, InTimeOut>(0.1, 50, same_energy) < 1e-13);
    InTime loops;
    InTimeOut written_out;
    CHECK(std::abs(loops.norm(InTime::initial()) - written_out.norm(InTimeOut::initial())) < 1e-14);
}

TEST_CASE("Newton's method with the time, where second derivatives of the start do not do") {
    CHECK(distance_on_the_way<DrivenNewton, DrivenNewtonOut>(0.1, 20) < 1e-14);
    CHECK(distance_on_the_way<DrivenNewton, DrivenNewtonOut>(0.9, 20) < 1e-11);
}

TEST_CASE("curves of steps with loops") {
    const auto same_curve = [](const auto& loops, const auto&, const auto& out, const auto&) {
        for (const double tau : {0.0, 0.3, 0.5, 1.0}) {
            CHECK(apart(loops.position(tau), out.position(tau)) < 1e-13);
            CHECK(apart(loops.momentum(tau), out.momentum(tau)) < 1e-13);
        }
    };
    CHECK(distance_on_the_way<Driven, DrivenOut>(0.1, 10, same_curve) < 1e-14);
    CHECK(distance_on_the_way<InTime, InTimeOut>(0.1, 10, same_curve) < 1e-13);
}

TEST_CASE("before any step a curve of loops has no numbers, and as many places as the system") {
    const auto nowhere = Driven().position(0.5);
    REQUIRE(nowhere.size() == 7);
    for (const double each : nowhere) { CHECK(std::isnan(each)); }
}

TEST_CASE("actions of steps with loops") {
    const auto same_action = [](const auto& loops, const auto&, const auto& out, const auto&) {
        CHECK(std::abs(loops.generating_function() - out.generating_function()) < 1e-13);
        CHECK(std::abs(loops.action() - out.action()) < 1e-13);
    };
    CHECK(distance_on_the_way<DrivenVerlet, DrivenVerletOut>(0.1, 10, same_action) < 1e-14);
    CHECK(distance_on_the_way<InTime, InTimeOut>(0.1, 10, same_action) < 1e-13);
}

TEST_CASE("a parameter of a method with loops, free or shared with the scene") {
    CHECK(distance_on_the_way<DrivenFit, DrivenFitOut>(0.1, 50) < 1e-14);
    CHECK(distance_on_the_way<DrivenFixed, DrivenFixedOut>(0.1, 50) < 1e-14);
    // The parameter is 2 in the one, and 3/2 in the other.
    DrivenFit free(DrivenFit::Parameters{});
    DrivenFixed fixed(DrivenFixed::Parameters{});
    auto x = DrivenFit::initial();
    auto y = DrivenFixed::initial();
    REQUIRE(free.step(x, 0.1).ok());
    REQUIRE(fixed.step(y, 0.1).ok());
    CHECK(apart(x.p, y.p) > 0.01);
}

TEST_CASE("loops in __float128") {
    using Loops = BasicDriven128<hvi::math::Widest>;
    using WrittenOut = BasicDriven128Out<hvi::math::Widest>;
    Loops loops;
    WrittenOut written_out;
    auto x = Loops::initial();
    auto y = WrittenOut::initial();
    const hvi::math::Widest h = hvi::math::Widest(1) / 10;
    for (int step = 0; step < 10; ++step) {
        REQUIRE(loops.step(x, h).ok());
        REQUIRE(written_out.step(y, h).ok());
    }
    const hvi::math::Widest bound = 256 * hvi::detail::epsilon<hvi::math::Widest>;
    CHECK(bool(apart(x.q, y.q) < bound));
    CHECK(bool(apart(x.p, y.p) < bound));
}

TEST_CASE("factors of a band in __float128") {
    using Wide = BasicSprings128<hvi::math::Widest>;
    Wide wide;
    Springs128 narrow;
    auto x = Wide::initial();
    auto y = Springs128::initial();
    const hvi::math::Widest before = wide.energy(x);
    for (int step = 0; step < 20; ++step) {
        REQUIRE(wide.step(x, hvi::math::Widest(1) / 2).ok());
        REQUIRE(narrow.step(y, 0.5).ok());
    }
    for (std::size_t k = 0; k < y.q.size(); ++k) {
        CHECK(std::abs(static_cast<double>(x.q[k]) - y.q[k]) < 1e-12);
    }
    // NOTE: H is quadratic, and kept by midpoint and Gauss's methods.
    const hvi::math::Widest change = hvi::detail::abs(wide.energy(x) - before);
    CHECK(bool(change < 1000 * hvi::detail::epsilon<hvi::math::Widest> * before));
}

TEST_CASE("a Lagrangian whose sums stay loops is solved by its Hamiltonian") {
    const auto same_values = [](const auto& loops, const auto& x, const auto& out, const auto& y) {
        CHECK(apart(loops.velocity(x), out.velocity(y)) < 1e-13);
        CHECK(std::abs(loops.energy(x) - out.energy(y)) < 1e-12);
        CHECK(std::abs(loops.motion(x) - out.motion(y)) < 1e-12);
    };
    CHECK(distance_on_the_way<Rails, RailsOut>(0.02, 50, same_values) < 1e-13);
    const auto x = Rails::initial();
    REQUIRE(x.p.size() == 12);
    for (std::size_t i = 0; i < 6; ++i) {
        const double k = static_cast<double>(i + 1);
        CHECK(x.p[i] == (k + 0.5) * static_cast<double>(i % 3 + 1));
        CHECK(x.p[6 + i] == Approx(2 * (k + 1) * k / 5).epsilon(1e-15));
    }
    Rails::State other = x;
    other.p.pop_back();
    CHECK(Rails().velocity(other).empty());
}

TEST_CASE("forces of a mean field, and its energy, by hand") {
    for (const std::size_t n : {1U, 2U, 70U, 1001U}) {
        CAPTURE(n);
        MeanField::Parameters parameters;
        parameters.N = static_cast<std::ptrdiff_t>(n);
        const MeanField::System system(parameters);
        std::vector<double> q, p, slope(n);
        long double cosines = 0, sines = 0, energy = 0;
        for (std::size_t i = 0; i < n; ++i) {
            q.push_back(1.3 * std::sin(1.7 * static_cast<double>(i)));
            p.push_back(std::cos(0.3 * static_cast<double>(i)));
            cosines += std::cos(static_cast<long double>(q[i]));
            sines += std::sin(static_cast<long double>(q[i]));
            energy += static_cast<long double>(p[i]) * static_cast<long double>(p[i]) / 2;
        }
        system.dHdq(q, slope);
        const auto size = static_cast<long double>(n);
        for (std::size_t i = 0; i < n; ++i) {
            const auto at = static_cast<long double>(q[i]);
            const long double expected = (std::sin(at) * cosines - std::cos(at) * sines) / size;
            CHECK(std::abs(static_cast<long double>(slope[i]) - expected) < 1e-15L);
        }
        energy -= (cosines * cosines + sines * sines) / (2 * size);
        CHECK(std::abs(static_cast<long double>(system.energy(q, p)) - energy) < 1e-15L * size);
    }
}

TEST_CASE("sums in products and functions are added up before what is made of them") {
    CHECK(distance_on_the_way<MeanFieldGauss, MeanFieldOut>(0.05, 20) < 1e-13);
    const auto same_values = [](const auto& loops, const auto& x, const auto& out, const auto& y) {
        CHECK(std::abs(loops.energy(x) - out.energy(y)) < 1e-11);
        CHECK(std::abs(loops.both(x) - out.both(y)) < 1e-11);
    };
    CHECK(distance_on_the_way<InFunctions, InFunctionsOut>(0.02, 30, same_values) < 1e-11);
}

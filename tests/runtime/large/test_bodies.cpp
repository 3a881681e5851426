// Bodies that turn where sums stay loops, against the same scenes written out.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/detail/groups/body_space.hpp>
#include <large/bodies.hpp>
#include <large/bodies_out.hpp>
#include <large/bodies_yoshida.hpp>
#include <large/bodies_yoshida_out.hpp>
#include <large/rotors.hpp>
#include <large/water.hpp>

namespace {

using namespace hvi::generated;
using Failure = hvi::Status::Code;
using Vector = std::vector<double>;

constexpr std::size_t bodies = 4, flat = 3 * bodies;  // of bodies.toml

/// Positions of a state, or a place, that is written out, in a row as loops have them.
template <class Place>
Vector positions(const Place& x) {
    Vector q(x.q.begin(), x.q.end());
    for (const auto& R : x.R) { q.insert(q.end(), R.begin(), R.end()); }
    return q;
}

template <class State>
Vector momenta(const State& x) {
    Vector p(x.p.begin(), x.p.end());
    for (const auto& L : x.L) { p.insert(p.end(), L.begin(), L.end()); }
    return p;
}

double distance(const Vector& a, const Vector& b) {
    REQUIRE(a.size() == b.size());
    double most = 0;
    for (std::size_t k = 0; k < a.size(); ++k) { most = std::max(most, std::abs(a[k] - b[k])); }
    return most;
}

/// How far apart 100 steps by loops and written out are on the way.
template <class Loops, class WrittenOut>
double apart_in_steps() {
    Loops loops;
    WrittenOut written_out;
    auto x = Loops::initial();
    auto y = WrittenOut::initial();
    double most = std::max(distance(x.q, positions(y)), distance(x.p, momenta(y)));
    for (int step = 0; step < 100; ++step) {
        REQUIRE(loops.step(x, 0.05).ok());
        REQUIRE(written_out.step(y, 0.05).ok());
        most = std::max({most, distance(x.q, positions(y)), distance(x.p, momenta(y))});
    }
    CHECK(x.t == y.t);
    CHECK(loops.energy(x) == Approx(written_out.energy(y)).epsilon(1e-14));
    CHECK(loops.spin(x) == Approx(written_out.spin(y)).epsilon(1e-14));
    return most;
}

/// Returns the distance of the matrices of a state from rotations.
double distance_from_rotations(const Vector& q, std::size_t first) {
    double most = 0;
    for (std::size_t r = first; r < q.size(); r += 9) {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                double sum = i == j ? -1 : 0;
                for (std::size_t k = 0; k < 3; ++k) { sum += q[r + 3 * i + k] * q[r + 3 * j + k]; }
                most = std::max(most, std::abs(sum));
            }
        }
    }
    return most;
}

}  // namespace

TEST_CASE("bodies turn as they do where sums are written out") {
    CHECK(apart_in_steps<Bodies, BodiesOut>() < 1e-13);
    CHECK(apart_in_steps<BodiesYoshida, BodiesYoshidaOut>() < 1e-13);
}

TEST_CASE("the curve of a step is that of the scene written out") {
    Bodies loops;
    BodiesOut written_out;
    auto x = Bodies::initial();
    auto y = BodiesOut::initial();
    for (const double tau : {0.0, 0.3, 1.0}) { CHECK(std::isnan(loops.position(tau)[0])); }
    REQUIRE(loops.step(x, 0.05).ok());
    REQUIRE(written_out.step(y, 0.05).ok());
    for (const double tau : {0.0, 0.3, 1.0}) {
        CHECK(distance(loops.position(tau), positions(written_out.position(tau))) < 1e-14);
    }
    CHECK(distance(loops.position(1), x.q) < 1e-14);
}

TEST_CASE("a thousand bodies keep what the scene says") {
    Rotors::Parameters parameters;
    parameters.N = 1000;
    Rotors rotors(parameters);
    auto x = Rotors::initial(parameters);
    const double energy = rotors.energy(x), J_1 = rotors.J_1(x), J_3 = rotors.J_3(x);
    for (int step = 0; step < 20; ++step) { REQUIRE(rotors.step(x, 0.05).ok()); }
    CHECK(std::abs(rotors.energy(x) - energy) < 1e-9 * std::abs(energy));
    CHECK(std::abs(rotors.J_1(x) - J_1) < 1e-12);
    CHECK(std::abs(rotors.J_3(x) - J_3) < 1e-12);
    CHECK(distance_from_rotations(x.q, 0) < 1e-14);
}

TEST_CASE("molecules keep momentum and angular momentum") {
    Water::Parameters parameters;
    parameters.N = 8;
    Water water(parameters);
    auto x = Water::initial(parameters);
    const double energy = water.energy(x), J_2 = water.J_2(x);
    for (int step = 0; step < 50; ++step) { REQUIRE(water.step(x, 0.001).ok()); }
    CHECK(std::abs(water.energy(x) - energy) < 1e-5 * std::abs(energy));
    CHECK(std::abs(water.J_2(x) - J_2) < 1e-11);
    CHECK(std::abs(water.P_1(x)) < 1e-11);
    CHECK(distance_from_rotations(x.q, 3 * 8) < 1e-14);
}

TEST_CASE("a step that cannot be made leaves bodies where they are") {
    Bodies stepper;
    const auto check = [&](auto x, double h, Failure why) {
        const auto before = x;
        CHECK(stepper.step(x, h).code() == why);
        CHECK(std::equal(x.q.begin(), x.q.end(), before.q.begin(), before.q.end()));
        CHECK(std::equal(x.p.begin(), x.p.end(), before.p.begin(), before.p.end()));
        CHECK(x.t == before.t);
    };
    auto short_one = Bodies::initial();
    short_one.q.pop_back();
    check(short_one, 0.05, Failure::dimension_mismatch);
    auto sheared = Bodies::initial();
    sheared.q[flat + 1] += 0.01;
    check(sheared, 0.05, Failure::not_a_rotation);
    auto fast = Bodies::initial();
    fast.p[flat] = 1000;
    check(fast, 0.05, Failure::outside_chart);
    check(Bodies::initial(), std::numeric_limits<double>::infinity(), Failure::not_finite);
    auto x = Bodies::initial();
    CHECK(stepper.step(x, 0.05).ok());
}

TEST_CASE("derivatives by turns are those along R exp(hat eta)") {
    // f = sum_k c_k q_k of one coordinate and one rotation, so that G = c.
    const double angle = 0.7, c = std::cos(angle), s = std::sin(angle);
    const Vector q{5, c, -s, 0, s, c, 0, 0, 0, 1};  // about the third axis
    Vector slopes(10);
    for (std::size_t k = 0; k < slopes.size(); ++k) { slopes[k] = std::sin(3.0 * double(k) + 1); }
    Vector by(4);
    hvi::detail::by_turns(q, slopes, by);
    CHECK(by[0] == slopes[0]);
    for (std::size_t a = 0; a < 3; ++a) {
        // d/d eta of R exp(hat eta e_a) at 0 is R hat(e_a), whose columns are R (e_a x e_j).
        const std::size_t b = (a + 1) % 3, d = (a + 2) % 3;
        double expected = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            expected += slopes[1 + 3 * i + b] * q[1 + 3 * i + d];  // e_a x e_b = e_d
            expected -= slopes[1 + 3 * i + d] * q[1 + 3 * i + b];  // e_a x e_d = -e_b
        }
        CHECK(by[1 + a] == Approx(expected));
    }
}

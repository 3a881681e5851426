// Headers of scenes whose sums stay loops, against loops written by hand in long double.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <catch2/catch.hpp>
#include <large/chain.hpp>
#include <large/chain_gauss.hpp>
#include <large/listed.hpp>
#include <large/masses.hpp>
#include <large/masses_gauss.hpp>
#include <large/names.hpp>
#include <large/plane.hpp>
#include <large/toda.hpp>

namespace {

using Real = long double;
using Reals = std::vector<Real>;
using Vector = std::vector<double>;
using State = hvi::State<Vector>;
using Code = hvi::Status::Code;
namespace generated = hvi::generated;

/// Between -size and size.
Vector some_numbers(std::size_t n, double size) {
    Vector result;
    while (result.size() < n) {
        result.push_back(size * std::sin(1.3 * static_cast<double>(result.size()) + 0.4));
    }
    return result;
}

Real wide(double x) { return static_cast<Real>(x); }

Reals wide(const Vector& v) { return {v.begin(), v.end()}; }

/// `near`: of the largest of them.
void check_near(const Vector& found, const Reals& expected, Real near) {
    REQUIRE(found.size() == expected.size());
    Real largest = 1;
    for (const Real value : expected) { largest = std::max(largest, std::abs(value)); }
    for (std::size_t i = 0; i < found.size(); ++i) {
        CAPTURE(i);
        CHECK(std::abs(wide(found[i]) - expected[i]) <= near * largest);
    }
}

bool same(const State& a, const State& b) { return a.q == b.q && a.p == b.p; }

// ---- by hand: dU/dq, and 1/mass ----

/// Springs between q_{i-1} and q_i, from the wall q_0 = 0 to the wall q_{n+1} = 0.
struct HandChain {
    [[nodiscard]] Reals slope(const Reals& q) const {
        Reals result(q.size(), 0);
        for (std::size_t i = 0; i <= q.size(); ++i) {
            const Real right = i < q.size() ? q[i] : 0, left = i > 0 ? q[i - 1] : 0;
            const Real r = right - left, tension = r + r * r / 4;
            if (i < q.size()) { result[i] += tension; }
            if (i > 0) { result[i - 1] -= tension; }
        }
        return result;
    }
    [[nodiscard]] static Real mass(std::size_t) { return 1; }
};

/// All pairs, each seen from both.
struct HandMasses {
    Reals m;

    [[nodiscard]] Reals slope(const Reals& x) const {
        Reals result(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) {
            result[i] = 3 * x[i];
            for (std::size_t j = 0; j < x.size(); ++j) {
                const Real d = x[i] - x[j], r = std::sqrt(d * d + 0.0625L);
                result[i] += m[i] * m[j] * d / (r * r * r);
            }
        }
        return result;
    }
    [[nodiscard]] Real mass(std::size_t i) const { return m[i]; }
};

// ---- by hand: steps ----

struct HandState {
    Reals q, p;
};

template <class System>
void verlet(const System& system, HandState& x, Real h) {
    const auto kick = [&] {
        const Reals slope = system.slope(x.q);
        for (std::size_t i = 0; i < slope.size(); ++i) { x.p[i] -= h / 2 * slope[i]; }
    };
    kick();
    for (std::size_t i = 0; i < x.q.size(); ++i) { x.q[i] += h * x.p[i] / system.mass(i); }
    kick();
}

/// Hammer & Hollingsworth's method of order 4 (1955), its equations iterated 30 times.
template <class System>
void gauss_2(const System& system, HandState& x, Real h) {
    const Real r = std::sqrt(Real(3)) / 6;
    const Real a[2][2] = {{0.25L, 0.25L - r}, {0.25L + r, 0.25L}};
    const std::size_t n = x.q.size();
    std::vector<Reals> velocity(2, Reals(n, 0)), slope(2, Reals(n, 0));
    for (int sweep = 0; sweep < 30; ++sweep) {
        for (std::size_t s = 0; s < 2; ++s) {
            Reals Q = x.q, P = x.p;
            for (std::size_t i = 0; i < n; ++i) {
                Q[i] += h * (a[s][0] * velocity[0][i] + a[s][1] * velocity[1][i]);
                P[i] -= h * (a[s][0] * slope[0][i] + a[s][1] * slope[1][i]);
                velocity[s][i] = P[i] / system.mass(i);
            }
            slope[s] = system.slope(Q);
        }
    }
    for (std::size_t i = 0; i < n; ++i) {
        x.q[i] += h / 2 * (velocity[0][i] + velocity[1][i]);
        x.p[i] -= h / 2 * (slope[0][i] + slope[1][i]);
    }
}

template <class Stepper, class System, class Step>
void check_steps(Stepper stepper, const System& system, Step by_hand, const State& start) {
    State x = start;
    HandState y{wide(x.q), wide(x.p)};
    constexpr int steps = 20;
    for (int step = 0; step < steps; ++step) {
        REQUIRE(stepper.step(x, 0.01).ok());
        by_hand(system, y, wide(0.01));
    }
    check_near(x.q, y.q, 1e-13L);
    check_near(x.p, y.p, 1e-13L);
    CHECK(x.q != start.q);
}

template <class Stepper>
typename Stepper::Parameters of_size(std::ptrdiff_t n) {
    typename Stepper::Parameters parameters;
    parameters.N = n;
    return parameters;
}

State any_state(std::size_t n) { return {some_numbers(n, 1.3), some_numbers(n, -0.7)}; }

}  // namespace

TEST_CASE("forces and energies of chains of any size") {
    for (const std::size_t n : {1U, 2U, 5U, 64U, 1000U}) {
        CAPTURE(n);
        const generated::Chain::System system(
            of_size<generated::Chain>(static_cast<std::ptrdiff_t>(n)));
        const State x = any_state(n);
        Vector slope(n);
        system.dHdq(x.q, slope);
        check_near(slope, HandChain{}.slope(wide(x.q)), 1e-15L);
        Real energy = 0;
        for (std::size_t i = 0; i <= n; ++i) {
            const Real r = (i < n ? wide(x.q[i]) : 0) - (i > 0 ? wide(x.q[i - 1]) : 0);
            energy += r * r / 2 + r * r * r / 12;
            if (i < n) { energy += wide(x.p[i]) * wide(x.p[i]) / 2; }
        }
        const Real found = wide(system.energy(x.q, x.p));
        CHECK(std::abs(found - energy) <= 1e-14L * std::abs(energy) + 1e-15L);
    }
}

TEST_CASE("forces of all pairs, with a list of masses") {
    for (const std::size_t n : {1U, 2U, 5U, 70U}) {
        CAPTURE(n);
        const auto parameters = of_size<generated::Masses>(static_cast<std::ptrdiff_t>(n));
        const generated::Masses::System system(parameters);
        const State x = any_state(n);
        Vector slope(n), velocity(n);
        system.dHdq(x.q, slope);
        system.dHdp(x.p, velocity);
        check_near(slope, HandMasses{wide(parameters.m)}.slope(wide(x.q)), 1e-13L);
        for (std::size_t i = 0; i < n; ++i) {
            CHECK(std::abs(wide(velocity[i]) - wide(x.p[i]) / wide(parameters.m[i])) <= 1e-15L);
        }
    }
}

TEST_CASE("forces of a lattice in the plane, across its seams") {
    constexpr std::size_t n = 6;
    const auto parameters = of_size<generated::Plane>(n);
    const generated::Plane::System system(parameters);
    const State x = any_state(n * n);
    Vector slope(n * n);
    system.dHdq(x.q, slope);
    const Reals u = wide(x.q);
    Reals expected;
    const Real a = wide(parameters.a);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            const Real here = u[i * n + j];
            const Real around = u[(i + 1) % n * n + j] + u[(i + n - 1) % n * n + j] +
                                u[i * n + (j + 1) % n] + u[i * n + (j + n - 1) % n];
            expected.push_back(here * (here * here - 1) + (4 * here - around) / (a * a));
        }
    }
    check_near(slope, expected, 1e-15L);
}

TEST_CASE("steps are those of loops by hand") {
    for (const std::size_t n : {1U, 70U}) {
        const auto size = static_cast<std::ptrdiff_t>(n);
        const State x = any_state(n);
        const State small{some_numbers(n, 0.3), x.p};
        check_steps(generated::Chain(of_size<generated::Chain>(size)), HandChain{},
                    verlet<HandChain>, small);
        check_steps(generated::ChainGauss(of_size<generated::ChainGauss>(size)), HandChain{},
                    gauss_2<HandChain>, small);
        const auto masses = of_size<generated::Masses>(size);
        check_steps(generated::Masses(masses), HandMasses{wide(masses.m)}, verlet<HandMasses>, x);
        check_steps(generated::MassesGauss(of_size<generated::MassesGauss>(size)),
                    HandMasses{wide(masses.m)}, gauss_2<HandMasses>, x);
    }
}

TEST_CASE("a scene begins where it says") {
    const State x = generated::Masses::initial();
    const generated::Masses::Parameters parameters;
    REQUIRE(x.q.size() == 70);
    for (std::size_t i = 0; i < 70; ++i) {
        const Real k = static_cast<Real>(i + 1);
        CHECK(std::abs(wide(x.q[i]) - std::sin(k) * wide(parameters.m[i])) <= 4e-15L);
        CHECK(std::abs(wide(x.p[i]) - std::cos(2 * k)) <= 1e-15L);
    }
    const State ring = generated::Toda::initial();
    REQUIRE(ring.q.size() == 1000);
    CHECK(ring.p[249] == Approx(1).epsilon(1e-15));
}

TEST_CASE("a scene may begin with a list, which fits its size or is refused") {
    generated::Listed::Parameters parameters;
    parameters.a = 0.75;
    const State x = generated::Listed::initial(parameters);
    REQUIRE(x.q.size() == 70);
    for (std::size_t i = 0; i < 70; ++i) {
        const double k = static_cast<double>(i + 1);
        const double listed[] = {0.75 * k, std::sqrt(k), k + 0.25};
        CHECK(x.q[i] == listed[(i + 1) % 3]);
        CHECK(x.p[i] == Approx(k / 70).epsilon(1e-15));
    }
    parameters.c = {3.5, -1};
    const State other = generated::Listed::initial(parameters);
    REQUIRE(other.q.size() == 70);
    CHECK(other.q[0] == 7);
    CHECK(other.q[3] == -0.5);
    CHECK(other.q[1] == x.q[1]);
    parameters.c.resize(1);
    CHECK(generated::Listed::initial(parameters).q.empty());
    parameters.c.resize(2);
    for (const std::ptrdiff_t n : {0, 69, 71}) {
        parameters.N = n;
        CHECK(generated::Listed::initial(parameters).q.empty());
    }
}

TEST_CASE("names mean what they mean in the scene, whatever they mean around it") {
    constexpr std::size_t n = 70;
    const generated::Names::System system(generated::Names::Parameters{});
    const State x = any_state(n);
    Vector slope(n);
    system.dHdq(x.q, slope);
    Real sum = 0;
    for (const double value : x.q) { sum += wide(value); }
    Reals expected;
    for (std::size_t i = 0; i < n; ++i) {
        expected.push_back(6 * Real(i + 1) * wide(x.q[i]) + 0.03L * (sum - wide(x.q[i])));
    }
    check_near(slope, expected, 1e-15L);
    const State start = generated::Names::initial();
    for (std::size_t i = 0; i < n; ++i) {
        CHECK(start.q[i] == Approx(std::cos(double(i + 1))).epsilon(1e-15));
        CHECK(start.p[i] == Approx(double(i + 1) / 100).epsilon(1e-15));
    }
}

// ---- what does not fit ----

namespace {

/// Checks that neither a step nor the energy reads beyond the state.
template <class Stepper>
void check_mismatch(const typename Stepper::Parameters& parameters, const State& start) {
    Stepper stepper(parameters);
    State x = start;
    const hvi::Status status = stepper.step(x, 0.01);
    CHECK(status.code() == Code::dimension_mismatch);
    CHECK(same(x, start));
    CHECK(std::isnan(stepper.energy(x)));
}

template <class Stepper>
void check_sizes(std::ptrdiff_t n) {
    const auto parameters = of_size<Stepper>(n);
    const auto size = static_cast<std::size_t>(n);
    check_mismatch<Stepper>(parameters, any_state(size - 1));
    check_mismatch<Stepper>(parameters, any_state(size + 1));
    check_mismatch<Stepper>(parameters, {some_numbers(size, 0.3), some_numbers(size - 1, 0.3)});
    check_mismatch<Stepper>(parameters, {});
}

}  // namespace

TEST_CASE("a state of another size than the system is refused") {
    check_sizes<generated::Chain>(70);
    check_sizes<generated::ChainGauss>(70);
    check_sizes<generated::Masses>(70);
    check_sizes<generated::MassesGauss>(70);
    check_sizes<generated::Toda>(70);
}

TEST_CASE("a list that is too short is refused, where it begins too") {
    auto parameters = of_size<generated::Masses>(71);
    check_mismatch<generated::Masses>(parameters, any_state(71));
    CHECK(generated::Masses::initial(parameters).q.empty());
    auto of_gauss = of_size<generated::MassesGauss>(71);
    check_mismatch<generated::MassesGauss>(of_gauss, any_state(71));

    parameters.m.push_back(2);
    State x = generated::Masses::initial(parameters);
    CHECK(x.q.size() == 71);
    CHECK(generated::Masses(parameters).step(x, 0.01).ok());

    parameters.m.resize(3);
    parameters.N = 4;
    check_mismatch<generated::Masses>(parameters, any_state(4));
    parameters.N = 0;
    CHECK(generated::Masses::initial(parameters).q.empty());
}

TEST_CASE("one number of many that is none stops a step, and the state stays") {
    const auto check = [](auto stepper) {
        State x = any_state(70);
        x.q[41] = std::nan("");
        const State before = x;
        CHECK(stepper.step(x, 0.01).code() == Code::not_finite);
        CHECK(std::equal(x.p.begin(), x.p.end(), before.p.begin()));
        CHECK(std::isnan(x.q[41]));
        x.q[41] = before.q[40];
        const State once_more = x;
        CHECK(stepper.step(x, 0.01).ok());
        CHECK(!same(x, once_more));
    };
    check(generated::Chain(of_size<generated::Chain>(70)));
    check(generated::ChainGauss(of_size<generated::ChainGauss>(70)));
    check(generated::Masses(of_size<generated::Masses>(70)));
    check(generated::MassesGauss(of_size<generated::MassesGauss>(70)));
}

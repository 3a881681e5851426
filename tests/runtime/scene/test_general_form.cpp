// Steppers of the general Galerkin form, against (4.6) as it is printed.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>
#include <scene/driven_simpson.hpp>
#include <scene/over_gauss_kepler.hpp>
#include <scene/over_gauss_kepler_newton.hpp>
#include <scene/over_gauss_pendulum.hpp>
#include <scene/simpson_henon_heiles.hpp>
#include <scene/trapezoid_pendulum.hpp>
#include <scene/unused_node_mass_matrix.hpp>
#include <scene/verlet_pendulum.hpp>

#include "elimination.hpp"

using namespace hvi::generated;

namespace {

/// psi_j = tau^j, j < s, with a rule b_i, c_i.
struct Rule {
    std::size_t s;
    Vector c, b;

    [[nodiscard]] Real psi(std::size_t j, std::size_t i) const {
        return std::pow(c[i], static_cast<Real>(j));
    }
    [[nodiscard]] Real A(std::size_t i, std::size_t j) const {
        return std::pow(c[i], static_cast<Real>(j + 1)) / static_cast<Real>(j + 1);
    }
    [[nodiscard]] Real B(std::size_t j) const { return 1 / static_cast<Real>(j + 1); }
};

/// The roots of Legendre's polynomial on [0, 1], by Newton's method, and their weights.
Rule gauss(std::size_t s, std::size_t r) {
    Rule rule{s, {}, {}};
    for (std::size_t i = 0; i < r; ++i) {
        const Real n = static_cast<Real>(r);
        Real x = std::cos(3.14159265358979323846L * (static_cast<Real>(i) + 0.75L) / (n + 0.5L));
        Real slope = 0;
        for (int k = 0; k < 60; ++k) {
            Real now = x, before = 1;
            for (std::size_t d = 2; d <= r; ++d) {
                const Real m = static_cast<Real>(d);
                const Real next = ((2 * m - 1) * x * now - (m - 1) * before) / m;
                before = now;
                now = next;
            }
            slope = n * (x * now - before) / (x * x - 1);
            x -= now / slope;
        }
        rule.c.push_back((1 + x) / 2);
        rule.b.push_back(1 / ((1 - x * x) * slope * slope));
    }
    return rule;
}

/// H = p^T K p/2 + k.p + U(q), by its force dU/dq(q, t).
template <class Force>
struct Mechanics {
    Matrix K;
    Vector k;
    Force force;
};

/// One step of (4.6a) to (4.6e): forces by fixed points, V and P by elimination.
template <class Force>
void step_of_paper(const Rule& rule, const Mechanics<Force>& H, Vector& q, Vector& p, Real t,
                   Real h) {
    const std::size_t n = q.size(), s = rule.s, r = rule.c.size();
    const auto V_at = [&](std::size_t j, std::size_t k) { return j * n + k; };
    const auto P_at = [&](std::size_t i, std::size_t k) { return (s + i) * n + k; };
    Vector x((s + r) * n);
    Matrix forces(r, Vector(n));
    for (int iteration = 0; iteration < 200; ++iteration) {
        for (std::size_t i = 0; i < r; ++i) {  // (4.6c)
            Vector Q = q;
            for (std::size_t k = 0; k < n; ++k) {
                for (std::size_t j = 0; j < s; ++j) Q[k] += h * rule.A(i, j) * x[V_at(j, k)];
            }
            forces[i] = H.force(Q, t + rule.c[i] * h);
        }
        Matrix equations(x.size(), Vector(x.size()));
        Vector right(x.size());
        for (std::size_t k = 0; k < n; ++k) {
            for (std::size_t j = 0; j < s; ++j) {  // (4.6d)
                right[V_at(j, k)] = p[k] * rule.B(j);
                for (std::size_t i = 0; i < r; ++i) {
                    equations[V_at(j, k)][P_at(i, k)] = rule.b[i] * rule.psi(j, i);
                    right[V_at(j, k)] -= h * rule.b[i] * (rule.B(j) - rule.A(i, j)) * forces[i][k];
                }
            }
            for (std::size_t i = 0; i < r; ++i) {  // (4.6e)
                for (std::size_t j = 0; j < s; ++j) {
                    equations[P_at(i, k)][V_at(j, k)] = rule.psi(j, i);
                }
                for (std::size_t l = 0; l < n; ++l) equations[P_at(i, k)][P_at(i, l)] = -H.K[k][l];
                right[P_at(i, k)] = H.k[k];
            }
        }
        x = solved(equations, right);
    }
    for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t j = 0; j < s; ++j) q[k] += h * rule.B(j) * x[V_at(j, k)];  // (4.6a)
        for (std::size_t i = 0; i < r; ++i) p[k] -= h * rule.b[i] * forces[i][k];   // (4.6b)
    }
}

/// The largest distance from the steps of the paper.
template <class Stepper, class Force>
Real distance(const Rule& rule, const Mechanics<Force>& H, Vector q, Vector p, Real h, int steps) {
    Stepper stepper;
    typename Stepper::State x{};
    std::copy(q.begin(), q.end(), x.q.begin());
    std::copy(p.begin(), p.end(), x.p.begin());
    Real largest = 0, t = 0;
    for (int i = 0; i < steps; ++i, t += h) {
        REQUIRE(stepper.step(x, static_cast<double>(h)).ok());
        step_of_paper(rule, H, q, p, t, h);
        for (std::size_t k = 0; k < q.size(); ++k) {
            largest = std::max({largest, std::abs(q[k] - static_cast<Real>(x.q[k])),
                                std::abs(p[k] - static_cast<Real>(x.p[k]))});
        }
    }
    return largest;
}

template <class Force>
Mechanics<Force> unit_masses(std::size_t n, Force force) {
    Mechanics<Force> H{Matrix(n, Vector(n)), Vector(n), force};
    for (std::size_t k = 0; k < n; ++k) H.K[k][k] = 1;
    return H;
}

const auto pendulum = unit_masses(1, [](const Vector& q, Real) { return Vector{std::sin(q[0])}; });

const Rule trapezoid{1, {0, 1}, {0.5L, 0.5L}};
const Rule simpson{2, {0, 0.5L, 1}, {1 / 6.0L, 2 / 3.0L, 1 / 6.0L}};

}  // namespace

TEST_CASE("steps of the general form are those of (4.6)") {
    CHECK(distance<TrapezoidPendulum>(trapezoid, pendulum, {1.5L}, {0.25L}, 0.125L, 50) < 1e-13L);
    CHECK(distance<OverGaussPendulum>(gauss(2, 4), pendulum, {1.5L}, {0.25L}, 0.25L, 50) < 1e-13L);
    const auto henon_heiles = unit_masses(2, [](const Vector& q, Real) {
        return Vector{q[0] + 2 * q[0] * q[1], q[1] + q[0] * q[0] - q[1] * q[1]};
    });
    CHECK(distance<SimpsonHenonHeiles>(simpson, henon_heiles, {0, 0.25L}, {0.375L, 0.125L}, 0.25L,
                                       50) < 1e-13L);
    const auto kepler = unit_masses(2, [](const Vector& q, Real) {
        const Real r = std::hypot(q[0], q[1]);
        return Vector{q[0] / (r * r * r), q[1] / (r * r * r)};
    });
    for (const Real h : {0.0625L, 0.25L}) {
        CHECK(distance<OverGaussKepler>(gauss(3, 6), kepler, {0.5L, 0}, {0, 1.5L}, h, 40) < 1e-11L);
        CHECK(distance<OverGaussKeplerNewton>(gauss(3, 6), kepler, {0.5L, 0}, {0, 1.5L}, h, 40) <
              1e-11L);
    }
}

TEST_CASE("a node without a weight changes nothing, whatever the mass matrix") {
    // H = pa^2/3 + pa pb + pb^2 + pb/2 + cos(a - b) + a^2/2 + b^4/4
    const auto force = [](const Vector& q, Real) {
        const Real s = std::sin(q[0] - q[1]);
        return Vector{q[0] - s, s + q[1] * q[1] * q[1]};
    };
    const Mechanics<decltype(force)> H{{{2 / 3.0L, 1}, {1, 2}}, {0, 0.5L}, force};
    CHECK(distance<UnusedNodeMassMatrix>(simpson, H, {0.5L, -0.25L}, {0.125L, 0.375L}, 0.125L, 50) <
          1e-13L);
}

TEST_CASE("forces that depend on the time are taken at the nodes") {
    const auto driven = unit_masses(1, [](const Vector& q, Real t) {
        return Vector{std::sin(q[0]) - 0.5L * std::cos(2 * t / 3)};
    });
    CHECK(distance<DrivenSimpson>(simpson, driven, {0.5L}, {0.25L}, 0.25L, 40) < 1e-13L);
}

TEST_CASE("constant velocities and the trapezoidal rule are Stormer-Verlet, to the last bit") {
    TrapezoidPendulum general;
    VerletPendulum verlet;
    auto x = TrapezoidPendulum::initial();
    auto y = VerletPendulum::initial();
    for (int i = 0; i < 1000; ++i) {
        REQUIRE(general.step(x, 0.1).ok());
        REQUIRE(verlet.step(y, 0.1).ok());
        REQUIRE(x.q == y.q);
        REQUIRE(x.p == y.p);
    }
}

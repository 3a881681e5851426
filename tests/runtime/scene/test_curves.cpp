// Steppers of the general Galerkin form for any H, against (4.6) as it is printed.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>
#include <scene/curve_12_nonseparable.hpp>
#include <scene/curve_23_double_pendulum.hpp>
#include <scene/curve_23_nonseparable.hpp>
#include <scene/curve_24_functions.hpp>
#include <scene/curve_24_relativistic.hpp>
#include <scene/curve_34_nonseparable.hpp>
#include <scene/curve_35_bead.hpp>
#include <scene/curve_composed.hpp>
#include <scene/curve_composed_bead.hpp>
#include <scene/curve_composed_pendulum.hpp>
#include <scene/curve_eliminated.hpp>
#include <scene/curve_negative_weight.hpp>
#include <scene/curve_newton_bead.hpp>
#include <scene/curve_newton_double_pendulum.hpp>
#include <scene/curve_newton_relativistic.hpp>
#include <scene/curve_of_pendulum.hpp>
#include <scene/curve_quartic.hpp>

#include "elimination.hpp"

using namespace hvi::generated;

namespace {

// ---- derivatives ----

/// A value and its derivative along one direction.
struct Jet {
    Real value = 0, slope = 0;
};
Jet operator+(Jet x, Jet y) { return {x.value + y.value, x.slope + y.slope}; }
Jet operator-(Jet x, Jet y) { return {x.value - y.value, x.slope - y.slope}; }
Jet operator*(Jet x, Jet y) { return {x.value * y.value, x.slope * y.value + x.value * y.slope}; }
Jet operator/(Jet x, Jet y) {
    const Real ratio = x.value / y.value;
    return {ratio, (x.slope - ratio * y.slope) / y.value};
}
Jet operator*(Real a, Jet x) { return Jet{a} * x; }
Jet operator+(Real a, Jet x) { return Jet{a} + x; }
Jet operator-(Jet x, Real a) { return x - Jet{a}; }
Jet sin(Jet x) { return {std::sin(x.value), x.slope * std::cos(x.value)}; }
Jet cos(Jet x) { return {std::cos(x.value), -x.slope * std::sin(x.value)}; }
Jet sqrt(Jet x) {
    const Real root = std::sqrt(x.value);
    return {root, x.slope / (2 * root)};
}

using Jets = std::vector<Jet>;

/// dH/dq, then dH/dp.
template <class H>
Vector gradient(const H& hamiltonian, const Vector& q, const Vector& p, Real t) {
    const std::size_t n = q.size();
    Vector result;
    for (std::size_t k = 0; k < 2 * n; ++k) {
        Jets Q(n), P(n);
        for (std::size_t l = 0; l < n; ++l) {
            Q[l] = {q[l], l == k ? 1.0L : 0.0L};
            P[l] = {p[l], n + l == k ? 1.0L : 0.0L};
        }
        result.push_back(hamiltonian(Q, P, t).slope);
    }
    return result;
}

// ---- (4.6) ----

/// psi_j = tau^j, j < s, with the interpolatory rule at the nodes c.
struct Rule {
    std::size_t s;
    Vector c, b;

    Rule(std::size_t functions, const Vector& nodes) : s(functions), c(nodes) {
        const std::size_t r = c.size();
        Matrix moments(r, Vector(r));
        Vector right(r);
        for (std::size_t k = 0; k < r; ++k) {
            right[k] = 1 / static_cast<Real>(k + 1);
            for (std::size_t i = 0; i < r; ++i) {
                moments[k][i] = std::pow(c[i], static_cast<Real>(k));
            }
        }
        b = solved(moments, right);
    }

    [[nodiscard]] Real psi(std::size_t j, std::size_t i) const {
        return std::pow(c[i], static_cast<Real>(j));
    }
    [[nodiscard]] Real A(std::size_t i, std::size_t j) const {
        return std::pow(c[i], static_cast<Real>(j + 1)) / static_cast<Real>(j + 1);
    }
    [[nodiscard]] Real B(std::size_t j) const { return 1 / static_cast<Real>(j + 1); }
};

/// The roots of Legendre's polynomial on [0, 1], by Newton's method.
Vector gauss_nodes(std::size_t r) {
    Vector nodes;
    for (std::size_t i = 0; i < r; ++i) {
        const Real n = static_cast<Real>(r);
        Real x = std::cos(3.14159265358979323846L * (static_cast<Real>(i) + 0.75L) / (n + 0.5L));
        for (int k = 0; k < 60; ++k) {
            Real now = x, before = 1;
            for (std::size_t d = 2; d <= r; ++d) {
                const Real m = static_cast<Real>(d);
                const Real next = ((2 * m - 1) * x * now - (m - 1) * before) / m;
                before = now;
                now = next;
            }
            x -= now * (x * x - 1) / (n * (x * now - before));
        }
        nodes.push_back((1 + x) / 2);
    }
    return nodes;
}

/// (4.6c) to (4.6e), the unknowns V_1, ..., V_s, P_1, ..., P_r in one vector.
template <class H>
class Equations {
public:
    Equations(const Rule& rule, const H& hamiltonian, const Vector& q, const Vector& p, Real t,
              Real h)
        : rule_(rule), hamiltonian_(hamiltonian), q_(q), p_(p), t_(t), h_(h), n_(q.size()) {}

    [[nodiscard]] Vector start() const {
        Vector x((rule_.s + rule_.c.size()) * n_);
        for (std::size_t i = 0; i < rule_.c.size(); ++i) {
            for (std::size_t k = 0; k < n_; ++k) x[(rule_.s + i) * n_ + k] = p_[k];
        }
        return x;
    }

    [[nodiscard]] Vector residuals(const Vector& x) const {
        const std::size_t s = rule_.s, r = rule_.c.size();
        Vector F(x.size());
        for (std::size_t i = 0; i < r; ++i) {
            const Vector P(x.begin() + static_cast<std::ptrdiff_t>((s + i) * n_),
                           x.begin() + static_cast<std::ptrdiff_t>((s + i + 1) * n_));
            const Vector slopes = slopes_at(x, i);
            for (std::size_t k = 0; k < n_; ++k) {
                F[(s + i) * n_ + k] = -slopes[n_ + k];
                for (std::size_t j = 0; j < s; ++j) {
                    F[(s + i) * n_ + k] += rule_.psi(j, i) * x[j * n_ + k];  // (4.6e)
                    F[j * n_ + k] += rule_.b[i] * rule_.psi(j, i) * P[k] +   // (4.6d)
                                     h_ * rule_.b[i] * (rule_.B(j) - rule_.A(i, j)) * slopes[k];
                }
            }
        }
        for (std::size_t j = 0; j < s; ++j) {
            for (std::size_t k = 0; k < n_; ++k) F[j * n_ + k] -= p_[k] * rule_.B(j);
        }
        return F;
    }

    /// (4.6a) and (4.6b).
    void move(const Vector& x, Vector& q, Vector& p) const {
        for (std::size_t k = 0; k < n_; ++k) {
            for (std::size_t j = 0; j < rule_.s; ++j) q[k] += h_ * rule_.B(j) * x[j * n_ + k];
        }
        for (std::size_t i = 0; i < rule_.c.size(); ++i) {
            const Vector slopes = slopes_at(x, i);
            for (std::size_t k = 0; k < n_; ++k) p[k] -= h_ * rule_.b[i] * slopes[k];
        }
    }

private:
    [[nodiscard]] Vector slopes_at(const Vector& x, std::size_t i) const {
        Vector Q = q_, P(n_);
        for (std::size_t k = 0; k < n_; ++k) {
            for (std::size_t j = 0; j < rule_.s; ++j) Q[k] += h_ * rule_.A(i, j) * x[j * n_ + k];
            P[k] = x[(rule_.s + i) * n_ + k];
        }
        return gradient(hamiltonian_, Q, P, t_ + rule_.c[i] * h_);
    }

    const Rule& rule_;
    const H& hamiltonian_;
    Vector q_, p_;
    Real t_, h_;
    std::size_t n_;
};

/// One step, by Newton's method with differences for derivatives.
template <class H>
void step_of_paper(const Rule& rule, const H& hamiltonian, Vector& q, Vector& p, Real t, Real h) {
    const Equations<H> equations(rule, hamiltonian, q, p, t, h);
    Vector x = equations.start();
    for (int iteration = 0; iteration < 12; ++iteration) {
        const Vector F = equations.residuals(x);
        Matrix J(x.size(), Vector(x.size()));
        constexpr Real difference = 1e-9L;
        for (std::size_t l = 0; l < x.size(); ++l) {
            Vector near = x;
            near[l] += difference;
            const Vector there = equations.residuals(near);
            for (std::size_t k = 0; k < x.size(); ++k) J[k][l] = (there[k] - F[k]) / difference;
        }
        const Vector correction = solved(J, F);
        for (std::size_t l = 0; l < x.size(); ++l) x[l] -= correction[l];
    }
    equations.move(x, q, p);
}

/// The largest distance from the steps of the paper.
template <class Stepper, class H>
Real distance(const Rule& rule, const H& hamiltonian, Vector q, Vector p, Real h, int steps) {
    Stepper stepper;
    typename Stepper::State x{};
    std::copy(q.begin(), q.end(), x.q.begin());
    std::copy(p.begin(), p.end(), x.p.begin());
    Real largest = 0, t = 0;
    for (int i = 0; i < steps; ++i, t += h) {
        REQUIRE(stepper.step(x, static_cast<double>(h)).ok());
        step_of_paper(rule, hamiltonian, q, p, t, h);
        for (std::size_t k = 0; k < q.size(); ++k) {
            largest = std::max({largest, std::abs(q[k] - static_cast<Real>(x.q[k])),
                                std::abs(p[k] - static_cast<Real>(x.p[k]))});
        }
    }
    return largest;
}

// ---- systems ----

const auto nonseparable = [](const Jets& q, const Jets& p, Real) {
    return 0.5L * ((1 + q[0] * q[0]) * (1 + p[0] * p[0]));
};
const auto relativistic = [](const Jets& q, const Jets& p, Real) {
    return sqrt(1 + p[0] * p[0]) - cos(q[0]);
};
/// Lengths and masses 1, g = 9.81.
const auto double_pendulum = [](const Jets& q, const Jets& p, Real) {
    const Jet difference = q[0] - q[1], sine = sin(difference);
    return (p[0] * p[0] + 2 * p[1] * p[1] - 2 * p[0] * p[1] * cos(difference)) /
               (2 * (1 + sine * sine)) -
           19.62L * cos(q[0]) - 9.81L * cos(q[1]);
};
/// The H in tests/runtime/scene/steppers.txt, with k = 1.
const auto bead = [](const Jets& q, const Jets& p, Real t) {
    const Jet w = p[0] - std::sin(t) / 2, stretch = q[1] - 0.25L * q[0];
    return ((2 + std::cos(t)) / 6) * (w * w * (1 + 0.25L * q[0] * q[0])) + 0.5L * p[1] * p[1] +
           0.5L * stretch * stretch - cos(q[0]);
};

template <class Stepper>
double energy_error(double h, int steps) {
    Stepper stepper;
    auto x = Stepper::initial();
    const double begin = stepper.energy(x);
    double largest = 0;
    for (int i = 0; i < steps; ++i) {
        REQUIRE(stepper.step(x, h).ok());
        largest = std::max(largest, std::abs(stepper.energy(x) - begin));
    }
    return largest;
}

/// Returns the power of h with which the error falls at t = 1, from a step of 1/steps to half of
/// it.
template <class Stepper>
double order(int steps) {
    const auto end = [](auto stepper, int count) {
        auto x = Stepper::initial();
        for (int i = 0; i < count; ++i) REQUIRE(stepper.step(x, 1.0 / count).ok());
        return x;
    };
    const auto exact = end(Curve24Functions(), 16);
    const auto error = [&](int count) {
        const auto x = end(Stepper(), count);
        return std::hypot(x.q[0] - exact.q[0], x.p[0] - exact.p[0]);
    };
    return std::log2(error(steps) / error(2 * steps));
}

}  // namespace

TEST_CASE("steps for any H are those of (4.6)") {
    const auto gauss = [](std::size_t s, std::size_t r) { return Rule(s, gauss_nodes(r)); };
    CHECK(distance<Curve12Nonseparable>(gauss(1, 2), nonseparable, {0.5L}, {0.25L}, 0.125L, 30) <
          1e-13L);
    CHECK(distance<Curve23Nonseparable>(gauss(2, 3), nonseparable, {0.5L}, {0.25L}, 0.125L, 30) <
          1e-13L);
    CHECK(distance<Curve34Nonseparable>(gauss(3, 4), nonseparable, {0.5L}, {0.25L}, 0.125L, 30) <
          1e-13L);
    const Rule negative(2, {0.25L, 0.5L, 0.75L});
    CHECK(negative.b[1] < 0);
    CHECK(distance<CurveNegativeWeight>(negative, nonseparable, {0.5L}, {0.25L}, 0.125L, 30) <
          1e-13L);
    CHECK(distance<Curve24Relativistic>(gauss(2, 4), relativistic, {1.5L}, {0.75L}, 0.25L, 30) <
          1e-13L);
    const Rule lobatto(2, {0, (1 - std::sqrt(0.2L)) / 2, (1 + std::sqrt(0.2L)) / 2, 1});
    CHECK(distance<CurveNewtonRelativistic>(lobatto, relativistic, {1.5L}, {0.75L}, 0.25L, 30) <
          1e-13L);
    CHECK(distance<Curve23DoublePendulum>(gauss(2, 3), double_pendulum, {1, 0.75L}, {0.25L, 0},
                                          0.015625L, 30) < 1e-12L);
    CHECK(distance<CurveNewtonDoublePendulum>(gauss(3, 5), double_pendulum, {1, 0.75L}, {0.25L, 0},
                                              0.0625L, 30) < 1e-12L);
    for (const Real h : {0.0625L, 0.25L}) {
        CHECK(distance<Curve35Bead>(gauss(3, 5), bead, {0.5L, 0.25L}, {0.125L, 0.5L}, h, 20) <
              1e-13L);
        CHECK(distance<CurveNewtonBead>(gauss(3, 5), bead, {0.5L, 0.25L}, {0.125L, 0.5L}, h, 20) <
              1e-13L);
    }
}

TEST_CASE("with a quadratic kinetic energy the steps are those of the Nystrom method") {
    CurveOfPendulum curve;
    CurveEliminated positions;
    CurveOfPendulum::State x{{1.5}, {0.25}};
    CurveEliminated::State y{{1.5}, {0.25}};
    for (int i = 0; i < 100; ++i) {
        REQUIRE(curve.step(x, 0.125).ok());
        REQUIRE(positions.step(y, 0.125).ok());
        CHECK(std::abs(x.q[0] - y.q[0]) < 1e-14);
        CHECK(std::abs(x.p[0] - y.p[0]) < 1e-14);
    }
}

TEST_CASE("the order is twice the number of functions") {
    CHECK(order<Curve12Nonseparable>(64) == Approx(2).margin(0.1));
    CHECK(order<Curve23Nonseparable>(32) == Approx(4).margin(0.1));
    CHECK(order<Curve34Nonseparable>(16) == Approx(6).margin(0.2));
}

TEST_CASE("24 functions are well conditioned, and their energy does not drift") {
    CHECK(energy_error<Curve24Functions>(0.25, 1000) < 1e-13);
    CHECK(energy_error<Curve34Nonseparable>(0.0078125, 100'000) < 2e-12);
}

TEST_CASE("steps of a composition are steps of the rule in a row") {
    const double outer = 1 / (2 - std::cbrt(2.0));
    Curve23Nonseparable plain;
    // yoshida:6, solution A
    const std::array<double, 4> half{
        0.7845136104775573, 0.2355732133593581, -1.1776799841788710,
        1 - 2 * (0.7845136104775573 + 0.2355732133593581 - 1.1776799841788710)};
    CurveComposed composed;
    auto x = CurveComposed::initial();
    auto y = Curve23Nonseparable::initial();
    for (int i = 0; i < 10; ++i) {
        REQUIRE(composed.step(x, 0.125).ok());
        for (const std::size_t k : {0u, 1u, 2u, 3u, 2u, 1u, 0u}) {
            REQUIRE(plain.step(y, 0.125 * half[k]).ok());
        }
    }
    CHECK(std::abs(x.q[0] - y.q[0]) < 1e-13);
    CHECK(std::abs(x.p[0] - y.p[0]) < 1e-13);
    CHECK(order<CurveComposed>(8) == Approx(6).margin(0.3));
    // A quadratic kinetic energy: yoshida:4.
    CurveComposedPendulum quadratic;
    const Rule rule(2, gauss_nodes(3));
    const auto pendulum = [](const Jets& q, const Jets& p, Real) {
        return 0.5L * p[0] * p[0] - cos(q[0]);
    };
    CurveComposedPendulum::State z{{1.5}, {0.25}};
    Vector q{1.5L}, p{0.25L};
    REQUIRE(quadratic.step(z, 0.25).ok());
    for (const double part : {outer, 1 - 2 * outer, outer}) {
        step_of_paper(rule, pendulum, q, p, 0, 0.25L * static_cast<Real>(part));
    }
    CHECK(std::abs(static_cast<Real>(z.q[0]) - q[0]) < 1e-14L);
    CHECK(std::abs(static_cast<Real>(z.p[0]) - p[0]) < 1e-14L);
}

TEST_CASE("the time of a composition is that of its parts") {
    const Real gamma = 1 / (4 - std::cbrt(4.0L));  // suzuki:4
    CurveComposedBead stepper;
    CurveComposedBead::State x{};
    x.q = {0.5, 0.25};
    x.p = {0.125, 0.5};
    Vector q{0.5L, 0.25L}, p{0.125L, 0.5L};
    const Rule rule(1, gauss_nodes(2));
    Real t = 0;
    REQUIRE(stepper.step(x, 0.25).ok());
    CHECK(x.t == 0.25);
    for (const Real part : {gamma, gamma, 1 - 4 * gamma, gamma, gamma}) {
        step_of_paper(rule, bead, q, p, t, 0.25L * part);
        t += 0.25L * part;
    }
    for (std::size_t k = 0; k < 2; ++k) {
        CHECK(std::abs(static_cast<Real>(x.q[k]) - q[k]) < 1e-14L);
        CHECK(std::abs(static_cast<Real>(x.p[k]) - p[k]) < 1e-14L);
    }
}

TEST_CASE("symmetric rules undo their steps") {
    Curve34Nonseparable stepper;
    CurveNewtonBead timed;
    Curve34Nonseparable::State x{{0.5}, {0.25}};
    CurveNewtonBead::State y{};
    y.q = {0.5, 0.25};
    y.p = {0.125, 0.5};
    for (const double h : {0.25, -0.25}) {
        for (int i = 0; i < 20; ++i) {
            REQUIRE(stepper.step(x, h).ok());
            REQUIRE(timed.step(y, h).ok());
        }
    }
    CHECK(std::abs(x.q[0] - 0.5) < 1e-14);
    CHECK(std::abs(x.p[0] - 0.25) < 1e-14);
    CHECK(std::abs(y.q[0] - 0.5) < 1e-14);
    CHECK(std::abs(y.q[1] - 0.25) < 1e-14);
}

TEST_CASE("steps that fail leave the state as it was") {
    CurveQuartic quartic;
    CurveQuartic::State x{{0.5}, {0.0}};  // d2H/dp2 = 3 p^2
    CHECK(quartic.step(x, 0.125).code() == hvi::Status::Code::singular);
    CHECK((x.q[0] == 0.5 && x.p[0] == 0.0));
    x.p[0] = std::numeric_limits<double>::infinity();
    CHECK(quartic.step(x, 0.125).code() == hvi::Status::Code::not_finite);
    CHECK(x.q[0] == 0.5);
    Curve23DoublePendulum stepper;
    auto y = Curve23DoublePendulum::initial();
    const auto begin = y;
    CHECK(stepper.step(y, 20.0).code() == hvi::Status::Code::not_converged);
    CHECK((y.q == begin.q && y.p == begin.p));
    CHECK(stepper.step(y, 0.0078125).ok());
    CurveComposed composed;
    auto z = CurveComposed::initial();
    CHECK_FALSE(composed.step(z, 1e4).ok());
    CHECK_FALSE(composed.step(z, std::numeric_limits<double>::quiet_NaN()).ok());
    CHECK((z.q[0] == -3.0 && z.p[0] == 0.0));
    CHECK(composed.step(z, 0.125).ok());
}

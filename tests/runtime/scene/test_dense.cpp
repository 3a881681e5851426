// Positions and momenta within a step: the curve of the paper, computed again from the tableau, and
// its order.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/generic_stepper.hpp>
#include <scene/dense_boole_pendulum.hpp>
#include <scene/dense_chebyshev_3_nonseparable.hpp>
#include <scene/dense_chebyshev_3_pendulum.hpp>
#include <scene/dense_gauss_2_nonseparable.hpp>
#include <scene/dense_gauss_2_pendulum.hpp>
#include <scene/dense_gauss_3_nonseparable.hpp>
#include <scene/dense_gauss_3_pendulum.hpp>
#include <scene/dense_gauss_8_nonseparable.hpp>
#include <scene/dense_gauss_8_pendulum.hpp>
#include <scene/dense_lobatto_3_nonseparable.hpp>
#include <scene/dense_lobatto_3_pendulum.hpp>
#include <scene/dense_lobatto_4_kepler.hpp>
#include <scene/dense_mass_matrix.hpp>
#include <scene/dense_midpoint_nonseparable.hpp>
#include <scene/dense_midpoint_pendulum.hpp>
#include <scene/dense_mixed.hpp>
#include <scene/dense_pairs_of_mass_matrix.hpp>
#include <scene/dense_simpson_pendulum.hpp>
#include <scene/dense_stormer-verlet_pendulum.hpp>
#include <scene/dense_symplectic-euler_pendulum.hpp>
#include <scene/dense_trig3_nonseparable.hpp>
#include <scene/dense_trig3_pendulum.hpp>
#include <scene/dense_unseen_pendulum.hpp>
#include <scene/dense_wave_pendulum.hpp>
#include <scene/verlet_pendulum.hpp>

#include "elimination.hpp"
#include "scenes.hpp"

using namespace hvi::generated;

namespace {

// ---- the paper's formulas ----

/// A tableau, and the integrals over [0, tau] of its functions phi_j.
struct Table {
    std::vector<double> c;
    hvi::Coefficients<double> of;
    std::function<double(std::size_t j, double tau)> integral;
};

/// Returns the integrals of the polynomials that are 1 at c_j and 0 at the other nodes, by
/// Simpson's rule, which is exact for up to four nodes.
auto of_polynomials(const std::vector<double>& c) {
    return [c](std::size_t j, double tau) {
        const auto phi = [&](double x) {
            double product = 1.0;
            for (std::size_t i = 0; i < c.size(); ++i) {
                if (i != j) { product *= (x - c[i]) / (c[j] - c[i]); }
            }
            return product;
        };
        return tau / 6 * (phi(0.0) + 4 * phi(tau / 2) + phi(tau));
    };
}

const double r3 = std::sqrt(3.0);
const double pi = std::acos(-1.0);
const double outer = (pi - 2) / (2 * pi);
const Table gauss_2{{0.5 - r3 / 6, 0.5 + r3 / 6},
                    {{0.5, 0.5},
                     {{0.25, 0.25 - r3 / 6}, {0.25 + r3 / 6, 0.25}},
                     {{0.25, 0.25 - r3 / 6}, {0.25 + r3 / 6, 0.25}}},
                    of_polynomials({0.5 - r3 / 6, 0.5 + r3 / 6})};
const Table lobatto_3{{0, 0.5, 1},
                      {{1.0 / 6, 2.0 / 3, 1.0 / 6},
                       {{0, 0, 0}, {5.0 / 24, 1.0 / 3, -1.0 / 24}, {1.0 / 6, 2.0 / 3, 1.0 / 6}},
                       {{1.0 / 6, -1.0 / 6, 0}, {1.0 / 6, 1.0 / 3, 0}, {1.0 / 6, 5.0 / 6, 0}}},
                      of_polynomials({0, 0.5, 1})};
/// Example 4.6: phi is (1 + cos - sin)/2, sin, (1 - cos - sin)/2 of pi tau.
const Table trig3{
    {0, 0.5, 1},
    {{outer, 2 / pi, outer},
     {{0, 0, 0}, {0.25, 1 / pi, (pi - 4) / (4 * pi)}, {outer, 2 / pi, outer}},
     {{outer, (pi - 4) / (pi * pi - 2 * pi), 0}, {outer, 1 / pi, 0}, {outer, 1 / (pi - 2), 0}}},
    [](std::size_t j, double tau) {
        const double of_sin = (1 - std::cos(pi * tau)) / pi;
        const double of_cos = std::sin(pi * tau) / pi;
        return j == 1 ? of_sin : (tau + (j == 0 ? of_cos : -of_cos) - of_sin) / 2;
    }};

/// The equations of (4.18) for one degree of freedom, iterated until they stand still.
template <class Stepper>
struct Stages {
    Stages(const Table& table, const typename Stepper::State& x, double h) {
        const std::size_t s = table.c.size();
        const typename Stepper::System system{typename Stepper::Parameters{}};
        Q.assign(s, x.q);
        velocity.assign(s, {});
        force.assign(s, {});
        std::vector<typename Stepper::Vector> P(s, x.p);
        for (int sweep = 0; sweep < 200; ++sweep) {
            for (std::size_t i = 0; i < s; ++i) {
                scenes::gradient(system, Q[i], P[i], force[i], velocity[i]);
            }
            for (std::size_t i = 0; i < s; ++i) {
                Q[i] = x.q;
                P[i] = x.p;
                for (std::size_t j = 0; j < s; ++j) {
                    Q[i][0] += h * table.of.A[i][j] * velocity[j][0];
                    P[i][0] -= h * table.of.A_tilde[i][j] * force[j][0];
                }
            }
        }
    }

    std::vector<typename Stepper::Vector> Q, velocity, force;
};

/// q_d(tau h) = q_0 + h sum_j integral_0^tau phi_j * dH/dp(Q_j, P_j), and Q_i at c_i; momenta as
/// much by -dH/dq.
template <class Stepper>
void compare_with_the_paper(const Table& table, typename Stepper::State x, double h) {
    Stepper stepper;
    const typename Stepper::State start = x;
    const Stages<Stepper> stages(table, x, h);
    REQUIRE(stepper.step(x, h).ok());
    for (std::size_t i = 0; i < table.c.size(); ++i) {
        CHECK(std::abs(stepper.position(table.c[i])[0] - stages.Q[i][0]) < 3e-15);
    }
    for (const double tau : {0.03, 0.25, 0.4, 0.77, 0.99}) {
        double q = start.q[0], p = start.p[0];
        for (std::size_t j = 0; j < table.c.size(); ++j) {
            q += h * table.integral(j, tau) * stages.velocity[j][0];
            p -= h * table.integral(j, tau) * stages.force[j][0];
        }
        CHECK(std::abs(stepper.momentum(tau)[0] - p) < 3e-15);
        CHECK(std::abs(stepper.position(tau)[0] - q) < 3e-15);
    }
}

// ---- more nodes than functions ----

/// Two functions at least, with their integrals from 0 to tau, and a rule.
struct Rule {
    using Function = std::function<long double(long double)>;
    std::vector<Function> psi, integral;
    std::vector<long double> c, b;
};

Rule::Function power(int k) {
    return [k](long double tau) { return std::pow(tau, static_cast<long double>(k)); };
}

Rule::Function integral_of_power(int k) {
    return [k](long double tau) { return std::pow(tau, k + 1.0L) / (k + 1); };
}

const Rule simpson{{power(0), power(1)},
                   {integral_of_power(0), integral_of_power(1)},
                   {0, 0.5L, 1},
                   {1 / 6.0L, 2 / 3.0L, 1 / 6.0L}};
const Rule boole{{power(0), power(1), power(2)},
                 {integral_of_power(0), integral_of_power(1), integral_of_power(2)},
                 {0, 0.25L, 0.5L, 0.75L, 1},
                 {7 / 90.0L, 32 / 90.0L, 12 / 90.0L, 32 / 90.0L, 7 / 90.0L}};
const long double long_pi = std::acos(-1.0L);
const Rule wave{
    {power(0), [](long double tau) { return std::cos(long_pi * tau); }},
    {integral_of_power(0), [](long double tau) { return std::sin(long_pi * tau) / long_pi; }},
    {0.5L - std::sqrt(0.15L), 0.5L, 0.5L + std::sqrt(0.15L)},
    {5 / 18.0L, 4 / 9.0L, 5 / 18.0L}};

/// The curve (4.2) of a step of the pendulum: V by (4.6d), into which (4.6e), P_i = sum_j
/// psi_j(c_i) V_j, is put, iterated until it stands still.
std::function<long double(long double)> curve_of_pendulum(const Rule& rule, long double q,
                                                          long double p, long double h) {
    const std::size_t s = rule.psi.size(), r = rule.c.size();
    std::vector<long double> V(s, 0);
    const auto position = [&rule, q, h](const std::vector<long double>& V_now, long double tau) {
        long double sum = q;
        for (std::size_t j = 0; j < V_now.size(); ++j) {
            sum += h * V_now[j] * rule.integral[j](tau);
        }
        return sum;
    };
    for (int sweep = 0; sweep < 100; ++sweep) {
        std::vector<std::vector<long double>> G(s, std::vector<long double>(s, 0));
        std::vector<long double> moments(s, 0);
        for (std::size_t j = 0; j < s; ++j) {
            const long double B = rule.integral[j](1);
            moments[j] = B * p;
            for (std::size_t i = 0; i < r; ++i) {
                const long double c = rule.c[i], b = rule.b[i];
                moments[j] -= h * b * (B - rule.integral[j](c)) * std::sin(position(V, c));
                for (std::size_t k = 0; k < s; ++k) {
                    G[j][k] += b * rule.psi[j](c) * rule.psi[k](c);
                }
            }
        }
        V = solved(G, moments);
    }
    return [=](long double tau) { return position(V, tau); };
}

template <class Stepper>
void compare_with_the_general_form(const Rule& rule, double h) {
    Stepper stepper;
    typename Stepper::State x{{0.7}, {0.4}};
    const auto curve =
        curve_of_pendulum(rule, static_cast<long double>(x.q[0]), static_cast<long double>(x.p[0]),
                          static_cast<long double>(h));
    REQUIRE(stepper.step(x, h).ok());
    const auto compare = [&](double tau) {
        CHECK(std::abs(stepper.position(tau)[0] -
                       static_cast<double>(curve(static_cast<long double>(tau)))) < 1e-15);
    };
    for (const double tau : {0.0, 0.03, 0.25, 0.4, 0.77, 0.99, 1.0}) { compare(tau); }
    for (const long double c : rule.c) { compare(static_cast<double>(c)); }
}

// ---- the exact solution ----

/// Solves by the classical Runge-Kutta method in many small steps, independently of our steppers.
template <class Stepper>
typename Stepper::State flow(typename Stepper::State x, double time) {
    const typename Stepper::System system{typename Stepper::Parameters{}};
    constexpr int steps = 400;
    const double h = time / steps;
    using State = typename Stepper::State;
    const auto slope = [&](const State& at) {
        State result;
        scenes::gradient(system, at.q, at.p, result.p, result.q);
        for (double& p : result.p) { p = -p; }
        return result;
    };
    const auto moved = [](State at, double factor, const State& by) {
        for (std::size_t k = 0; k < at.q.size(); ++k) {
            at.q[k] += factor * by.q[k];
            at.p[k] += factor * by.p[k];
        }
        return at;
    };
    for (int i = 0; i < steps; ++i) {
        const State k1 = slope(x);
        const State k2 = slope(moved(x, h / 2, k1));
        const State k3 = slope(moved(x, h / 2, k2));
        const State k4 = slope(moved(x, h, k3));
        x = moved(moved(x, h / 6, k1), h / 3, k2);
        x = moved(moved(x, h / 3, k3), h / 6, k4);
    }
    return x;
}

struct Errors {
    double q = 0, p = 0;
};

/// The largest errors within one step.
template <class Stepper>
Errors errors(const typename Stepper::State& start, double h) {
    Stepper stepper;
    typename Stepper::State x = start;
    REQUIRE(stepper.step(x, h).ok());
    Errors largest;
    for (int i = 1; i < 16; ++i) {
        const double tau = i / 16.0;
        const typename Stepper::State exact = flow<Stepper>(start, tau * h);
        largest.q = std::max(largest.q, scenes::distance(stepper.position(tau), exact.q));
        largest.p = std::max(largest.p, scenes::distance(stepper.momentum(tau), exact.p));
    }
    return largest;
}

/// The exponents of h in the errors of one step.
template <class Stepper>
Errors exponents(double h) {
    const typename Stepper::State start{{-0.3}, {-0.5}};
    const Errors of_h = errors<Stepper>(start, h), of_half = errors<Stepper>(start, h / 2);
    return {std::log2(of_h.q / of_half.q), std::log2(of_h.p / of_half.p)};
}

template <class Stepper>
double exponent(double h) {
    return exponents<Stepper>(h).q;
}

// ---- promises ----

template <class Stepper>
constexpr bool has_position = requires(const Stepper& stepper) {
    stepper.position(0.5);
};

template <class Stepper>
void check_ends(typename Stepper::State x, double h, double bound) {
    Stepper stepper;
    CHECK(std::isnan(stepper.position(0.5)[0]));
    for (int i = 0; i < 50; ++i) {
        const typename Stepper::State start = x;
        REQUIRE(stepper.step(x, i % 7 == 6 ? -h : h).ok());
        CHECK(scenes::distance(stepper.position(0.0), start.q) <= bound);
        CHECK(stepper.position(1.0) == x.q);
        CHECK(scenes::distance(stepper.momentum(0.0), start.p) <= bound);
        CHECK(stepper.momentum(1.0) == x.p);
        CHECK(stepper.position(0.3) == stepper.position(0.3));
    }
    const typename Stepper::Vector middle = stepper.position(0.5);
    REQUIRE(stepper.step(x, 0.0).ok());
    REQUIRE_FALSE(stepper.step(x, std::numeric_limits<double>::infinity()).ok());
    CHECK(stepper.position(0.5) == middle);

    typename Stepper::State lost = x;
    lost.p[0] = std::numeric_limits<double>::quiet_NaN();
    REQUIRE_FALSE(stepper.step(lost, h).ok());
    for (const double q : stepper.position(0.5)) { CHECK(std::isnan(q)); }
    for (const double p : stepper.momentum(0.5)) { CHECK(std::isnan(p)); }
    REQUIRE(stepper.step(x, h).ok());
    CHECK_FALSE(std::isnan(stepper.position(0.5)[0]));
    stepper.reset();
    CHECK(std::isnan(stepper.position(0.5)[0]));
}

}  // namespace

TEST_CASE("positions within a step are on the curve of the paper") {
    compare_with_the_paper<DensePendulumGauss2>(gauss_2, {{0.7}, {0.4}}, 0.3);
    compare_with_the_paper<DenseNonseparableGauss2>(gauss_2, {{0.7}, {0.4}}, 0.2);
    compare_with_the_paper<DensePendulumLobatto3>(lobatto_3, {{0.7}, {0.4}}, -0.3);
    compare_with_the_paper<DenseNonseparableLobatto3>(lobatto_3, {{0.7}, {0.4}}, 0.2);
    compare_with_the_paper<DensePendulumTrig3>(trig3, {{0.7}, {0.4}}, 0.3);
    compare_with_the_paper<DenseNonseparableTrig3>(trig3, {{0.7}, {0.4}}, 0.2);
}

TEST_CASE("with more nodes than functions they are on the curve with the V of (4.6)") {
    compare_with_the_general_form<DensePendulumSimpson>(simpson, 0.3);
    compare_with_the_general_form<DensePendulumSimpson>(simpson, -0.3);
    compare_with_the_general_form<DensePendulumBoole>(boole, 0.3);
    compare_with_the_general_form<DensePendulumWave>(wave, 0.3);
    compare_with_the_general_form<DensePendulumUnseen>(simpson, 0.3);
}

TEST_CASE("the curve ends where the step does, and there is none without a step") {
    check_ends<DensePendulumMidpoint>({{1.5}, {0.0}}, 0.1, 1e-15);
    check_ends<DensePendulumVerlet>({{1.5}, {0.0}}, 0.1, 1e-15);
    check_ends<DensePendulumEuler>({{1.5}, {0.0}}, 0.1, 1e-15);
    check_ends<DensePendulumGauss3>({{1.5}, {0.0}}, 0.1, 1e-15);
    check_ends<DensePendulumGauss8>({{1.5}, {0.0}}, 0.1, 1e-15);
    check_ends<DenseNonseparableLobatto3>({{-3.0}, {0.0}}, 0.02, 2e-15);
    check_ends<DenseNonseparableGauss8>({{-3.0}, {0.0}}, 0.02, 2e-15);
    check_ends<DenseKeplerLobatto4>(DenseKeplerLobatto4::initial(), 0.01, 2e-15);
    check_ends<DensePendulumTrig3>({{1.5}, {0.0}}, 0.1, 1e-15);
    check_ends<DensePendulumSimpson>({{1.5}, {0.0}}, 0.1, 1e-15);
    check_ends<DensePendulumBoole>({{1.5}, {0.0}}, 0.1, 1e-15);
    check_ends<DensePendulumWave>({{1.5}, {0.0}}, 0.1, 1e-15);
    check_ends<DenseMixed>({{-3.0}, {0.0}}, 0.02, 2e-15);
    check_ends<DensePairsOfMassMatrix>({{0.5, -0.25}, {0.125, 1.0}}, 0.1, 2e-15);
}

TEST_CASE("the error within a step is O(h^(order+1)), and of no higher power") {
    const auto is_near = [](int expected) { return Approx(expected).margin(0.2); };
    CHECK(exponent<DensePendulumMidpoint>(0.05) == is_near(2));
    CHECK(exponent<DenseNonseparableMidpoint>(0.05) == is_near(2));
    CHECK(exponent<DensePendulumVerlet>(0.05) == is_near(2));
    CHECK(exponent<DensePendulumEuler>(0.05) == is_near(2));
    CHECK(exponent<DensePendulumGauss2>(0.05) == is_near(3));
    CHECK(exponent<DenseNonseparableGauss2>(0.05) == is_near(3));
    CHECK(exponent<DensePendulumGauss3>(0.05) == is_near(4));
    CHECK(exponent<DenseNonseparableGauss3>(0.05) == is_near(4));
    CHECK(exponent<DensePendulumLobatto3>(0.05) == is_near(3));
    CHECK(exponent<DenseNonseparableLobatto3>(0.05) == is_near(3));
    CHECK(exponent<DensePendulumChebyshev3>(0.05) == is_near(3));
    CHECK(exponent<DenseNonseparableChebyshev3>(0.05) == is_near(3));
    CHECK(exponent<DensePendulumSimpson>(0.05) == is_near(3));
    CHECK(exponent<DensePendulumBoole>(0.05) == is_near(4));
    CHECK(exponent<DensePendulumTrig3>(0.05) == is_near(2));
    CHECK(exponent<DenseNonseparableTrig3>(0.05) == is_near(2));
}

TEST_CASE("momenta within a step err by the power of h that positions do, or by a higher one") {
    const auto is_near = [](int expected) { return Approx(expected).margin(0.2); };
    CHECK(exponents<DenseNonseparableMidpoint>(0.05).p == is_near(2));
    CHECK(exponents<DenseNonseparableGauss2>(0.05).p == is_near(3));
    CHECK(exponents<DenseNonseparableGauss3>(0.02).p == is_near(4));
    CHECK(exponents<DenseNonseparableLobatto3>(0.05).p == is_near(3));
    CHECK(exponents<DenseNonseparableChebyshev3>(0.05).p == is_near(3));
    CHECK(exponents<DenseNonseparableTrig3>(0.05).p == is_near(2));
    CHECK(exponents<DensePendulumMidpoint>(0.05).p == is_near(2));
    CHECK(exponents<DensePendulumVerlet>(0.05).p == is_near(2));
    CHECK(exponents<DensePendulumEuler>(0.05).p == is_near(2));
    CHECK(exponents<DensePendulumGauss2>(0.05).p == is_near(3));
    CHECK(exponents<DensePendulumGauss3>(0.05).p == is_near(4));
    CHECK(exponents<DensePendulumSimpson>(0.05).p == is_near(3));
    CHECK(exponents<DensePendulumBoole>(0.05).p == is_near(4));
    CHECK(exponents<DensePendulumTrig3>(0.05).p == is_near(2));
    // Three nodes integrate the force along positions that err by h^3: the error is of one more.
    CHECK(exponents<DensePendulumLobatto3>(0.05).p > 2.8);
    CHECK(exponents<DensePendulumChebyshev3>(0.05).p > 2.8);
}

TEST_CASE("an explicit step with a curve is the explicit step") {
    DensePendulumVerlet dense;
    VerletPendulum plain;
    auto x = DensePendulumVerlet::initial();
    auto y = VerletPendulum::initial();
    for (int i = 0; i < 200; ++i) {
        REQUIRE(dense.step(x, 0.1).ok());
        REQUIRE(plain.step(y, 0.1).ok());
        REQUIRE(scenes::distance(x.q, y.q) + scenes::distance(x.p, y.p) < 1e-13);
    }
}

TEST_CASE("eight stages give the solution within a long step to round-off") {
    for (const Errors& of : {errors<DensePendulumGauss8>({{0.7}, {0.4}}, 0.2),
                             errors<DenseNonseparableGauss8>({{0.7}, {0.4}}, 0.1)}) {
        CHECK(of.q < 1e-14);
        CHECK(of.p < 1e-14);
    }
}

TEST_CASE("the curve is the same with and without momenta in the stages") {
    DenseMassMatrix eliminated;
    DensePairsOfMassMatrix pairs;
    DenseMassMatrix::State x{{0.5, -0.25}, {0.125, 1.0}};
    DensePairsOfMassMatrix::State y{{0.5, -0.25}, {0.125, 1.0}};
    REQUIRE(eliminated.step(x, 0.2).ok());
    REQUIRE(pairs.step(y, 0.2).ok());
    for (const double tau : {0.1, 0.5, 0.8}) {
        CHECK(scenes::distance(eliminated.position(tau), pairs.position(tau)) < 1e-13);
        CHECK(scenes::distance(eliminated.momentum(tau), pairs.momentum(tau)) < 1e-13);
    }
}

TEST_CASE("float and long double have the curve too") {
    BasicDensePendulumGauss8<float> single;
    BasicDensePendulumGauss8<long double> extended;
    DensePendulumGauss8 stepper;
    BasicDensePendulumGauss8<float>::State x{{0.75F}, {0.5F}};
    BasicDensePendulumGauss8<long double>::State y{{0.75L}, {0.5L}};
    DensePendulumGauss8::State z{{0.75}, {0.5}};
    REQUIRE(single.step(x, 0.125F).ok());
    REQUIRE(extended.step(y, 0.125L).ok());
    REQUIRE(stepper.step(z, 0.125).ok());
    CHECK(single.position(1.0F) == x.q);
    CHECK(extended.position(1.0L) == y.q);
    CHECK(single.momentum(1.0F) == x.p);
    CHECK(extended.momentum(1.0L) == y.p);
    CHECK(std::abs(single.position(0.25F)[0] - static_cast<float>(stepper.position(0.25)[0])) <
          2e-7F);
    CHECK(std::abs(static_cast<double>(extended.position(0.25L)[0]) - stepper.position(0.25)[0]) <
          1e-15);
}

TEST_CASE("without --dense there is no position") {
    CHECK(has_position<DensePendulumGauss3>);
    CHECK_FALSE(has_position<Pendulum>);
    CHECK_FALSE(has_position<Nonseparable>);
}

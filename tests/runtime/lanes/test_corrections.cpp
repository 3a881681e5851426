// Corrections with one Hessian for all stages in lanes.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include <catch2/catch.hpp>
#include <hvi/detail/lanes/mode_lanes.hpp>
#include <hvi/detail/lanes/stage_lanes.hpp>
#include <hvi/detail/lanes/velocity_lanes.hpp>
#include <hvi/detail/solvers/lane_corrections.hpp>

namespace {

/// C = from D to of three stages, one real eigenvalue 1/4 and the pair 1/8 +- i/2; from is unit
/// upper triangular.
struct Three {
    static constexpr std::size_t real_ones = 1, pairs = 1;
    static constexpr double real_parts[2] = {0.25, 0.125};
    static constexpr double imaginary_parts[1] = {0.5};
    static constexpr double from[3][3] = {{1, 2, 0}, {0, 1, 1}, {0, 0, 1}};
    static constexpr double to[3][3] = {{1, -2, 2}, {0, 1, -1}, {0, 0, 1}};
};

std::array<std::array<double, 3>, 3> matrix_of_three() {
    const double D[3][3] = {{0.25, 0, 0}, {0, 0.125, 0.5}, {0, -0.5, 0.125}};
    std::array<std::array<double, 3>, 3> C{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            for (std::size_t k = 0; k < 3; ++k) {
                for (std::size_t l = 0; l < 3; ++l) {
                    C[i][j] += Three::from[i][k] * D[k][l] * Three::to[l][j];
                }
            }
        }
    }
    return C;
}

constexpr std::size_t n = 4;
using ThreeOfFour = hvi::detail::ModeLanes<double, 3, n, Three>;

}  // namespace

TEST_CASE("the inverse of 1 + C x S, against the product") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto C = matrix_of_three();
    int taken = 0;
    for (int round = 0; round < 50; ++round) {
        double S[n][n];
        for (auto& row : S) {
            for (double& entry : row) { entry = number(random); }
        }
        ThreeOfFour modes;
        if (!modes.compute([&](std::size_t k, std::size_t l) { return S[k][l]; })) { continue; }
        ++taken;
        ThreeOfFour::Slopes x{};
        double right[n][3];
        for (std::size_t k = 0; k < n; ++k) {
            for (std::size_t i = 0; i < 3; ++i) {
                right[k][i] = number(random);
                x[k].set(i, right[k][i]);
            }
        }
        modes.solve(x);
        for (std::size_t k = 0; k < n; ++k) {
            for (std::size_t i = 0; i < 3; ++i) {
                double sum = x[k][i];
                for (std::size_t l = 0; l < n; ++l) {
                    for (std::size_t j = 0; j < 3; ++j) { sum += S[k][l] * C[i][j] * x[l][j]; }
                }
                CHECK(sum == Approx(right[k][i]).margin(1e-9));
            }
        }
    }
    CHECK(taken > 40);
}

TEST_CASE("a matrix that is singular, nearly so, or no matrix is refused") {
    const auto is_taken = [](double entry) {
        hvi::detail::ModeLanes<double, 3, 1, Three> modes;
        return modes.compute([&](std::size_t, std::size_t) { return entry; });
    };
    CHECK(is_taken(1));
    CHECK_FALSE(is_taken(-4));  // 1 + 1/4 S = 0
    CHECK_FALSE(is_taken(std::numeric_limits<double>::quiet_NaN()));
    CHECK_FALSE(is_taken(std::numeric_limits<double>::infinity()));
    // (1 -1; -1 1) for the real eigenvalue: its first pivot is none to complain of.
    ThreeOfFour modes;
    const auto later = [](std::size_t k, std::size_t l) {
        return k == l && k > 1 ? 0.0 : k < 2 && l < 2 && k != l ? -4.0 : 0.0;
    };
    CHECK_FALSE(modes.compute(later));
}

// ---- one correction solves what is linear ----

namespace {

/// The tableau of gauss:2. A has the eigenvalues 1/4 +- i/sqrt(48), and A^2 1/24 +- i/sqrt(192)
/// (Hairer & Wanner, Solving Ordinary Differential Equations II, IV.5); both have the eigenvectors
/// (1, -+i (2 + sqrt 3)).
constexpr double root = 1.7320508075688772;
constexpr double half[2] = {0.5, 0.5};
constexpr double times[2] = {0.5 - root / 6, 0.5 + root / 6};
constexpr double A[2][2] = {{0.25, 0.25 - root / 6}, {0.25 + root / 6, 0.25}};

struct ModesOfA {
    static constexpr std::size_t real_ones = 0, pairs = 1;
    static constexpr double real_parts[1] = {0.25};
    static constexpr double imaginary_parts[1] = {root / 12};
    static constexpr double from[2][2] = {{1, 0}, {0, -(2 + root)}};
    static constexpr double to[2][2] = {{1, 0}, {0, -1 / (2 + root)}};
};

struct ModesOfSquare : ModesOfA {
    static constexpr double real_parts[1] = {1.0 / 24};
    static constexpr double imaginary_parts[1] = {root / 24};
};

using Two = std::array<double, 2>;

/// H = p^T K p/2 + q^T G q/2, with K diagonal.
struct Springs {
    double G[2][2], K[2];

    template <class Values>
    void dHdq(const Values& q, Values& out) const {
        out[0] = G[0][0] * q[0] + G[0][1] * q[1];
        out[1] = G[1][0] * q[0] + G[1][1] * q[1];
    }
    static constexpr bool has_diagonal_mass = true;
    template <class Values>
    void inverse_mass(const Values& p, Values& out) const {
        out[0] = K[0] * p[0];
        out[1] = K[1] * p[1];
    }
    void dHdp(const Two& p, Two& out) const { inverse_mass(p, out); }
    void stiffness(std::array<double, 1>& out) const { out[0] = K[1] * G[1][1]; }
};

/// n_ij = sum_k a_ik a_kj/b_j.
struct Nystrom {
    double n[2][2] = {};
    constexpr Nystrom() {
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t j = 0; j < 2; ++j) {
                for (std::size_t k = 0; k < 2; ++k) { n[i][j] += A[i][k] * A[k][j] / half[j]; }
            }
        }
    }
};
constexpr Nystrom nystrom;

struct Positions {
    const Springs& system;
    hvi::detail::VelocityLanes<Two, 2>& s;

    static constexpr std::array<std::size_t, 1> stiff{1};

    void positions() { s.positions(hvi::detail::VelocityTable<double, 2>(times, nystrom.n)); }
    void slopes_of_momenta() { s.forces(system); }
    template <class Matrix>
    void hessian_in_the_middle(Matrix& out) const {
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t j = 0; j < 2; ++j) { out(i, j) = system.G[i][j]; }
        }
    }
};

/// How far the slopes are from those at their own stages after one correction, from zeros.
template <class Corrections>
double residual_of_positions(const Springs& system, double h) {
    hvi::detail::VelocityLanes<Two, 2> s;
    REQUIRE(s.begin({{0.3, -0.2}, {0.1, 0.4}}, h).ok());
    s.weigh(system, half);
    s.drift_freely(system, hvi::detail::VelocityTable<double, 2>(times, nystrom.n));
    Positions coupled{system, s};
    s.drifts(system);
    coupled.positions();
    Corrections corrections;
    REQUIRE(corrections.factorise(coupled));
    corrections.correct(coupled);
    const auto corrected = s.Lp;
    coupled.positions();
    coupled.slopes_of_momenta();
    double residual = 0;
    for (std::size_t k = 0; k < 2; ++k) {
        for (std::size_t i = 0; i < 2; ++i) {
            residual = std::max(residual, std::abs(corrected[k][i] - s.Lp[k][i]));
        }
    }
    return residual;
}

/// H = q^T Hqq q/2 + q^T Hqp p + p^T Hpp p/2.
struct Mixed {
    double qq[2][2], qp[2][2], pp[2][2];

    template <class Values>
    void dHdq(const Values& q, const Values& p, Values& out) const {
        for (std::size_t k = 0; k < 2; ++k) {
            out[k] = qq[k][0] * q[0] + qq[k][1] * q[1] + qp[k][0] * p[0] + qp[k][1] * p[1];
        }
    }
    template <class Values>
    void dHdp(const Values& q, const Values& p, Values& out) const {
        for (std::size_t k = 0; k < 2; ++k) {
            out[k] = qp[0][k] * q[0] + qp[1][k] * q[1] + pp[k][0] * p[0] + pp[k][1] * p[1];
        }
    }
};

struct Pairs {
    const Mixed& system;
    hvi::detail::StageLanes<Two, 2>& s;

    void stages() {
        double m[2][2];
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t j = 0; j < 2; ++j) { m[i][j] = A[i][j] / half[j]; }
        }
        s.momenta(hvi::detail::lane_columns(m));
        s.positions(hvi::detail::lane_columns(m));
    }
    void all_slopes() {
        auto Lp = s.forces(), Lq = s.velocities();
        system.dHdq(s.all_positions(), s.all_momenta(), Lp);
        system.dHdp(s.all_positions(), s.all_momenta(), Lq);
    }
    template <class Matrix>
    void hessian_in_the_middle(Matrix& qq, Matrix& qp, Matrix& pp) const {
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t j = 0; j < 2; ++j) {
                qq(i, j) = system.qq[i][j];
                qp(i, j) = system.qp[i][j];
                pp(i, j) = system.pp[i][j];
            }
        }
    }
};

}  // namespace

TEST_CASE("one correction of positions solves what is linear") {
    using Corrections =
        hvi::detail::PositionCorrections<Two, hvi::detail::HessianInTheMiddle, 2, ModesOfSquare>;
    const Springs coupled{{{4, 1.5}, {1.5, 9}}, {2, 0.5}};
    CHECK(residual_of_positions<Corrections>(coupled, 0.5) < 1e-14);
    CHECK(residual_of_positions<Corrections>(coupled, 20) < 5e-13);
}

TEST_CASE("one correction of what is stiff solves that, and leaves the rest to the sweep") {
    using Corrections = hvi::detail::ComponentCorrections<Two, 2, 1, ModesOfSquare>;
    // The first component has no force, the second is stiff.
    const Springs stiff{{{0, 0}, {0, 900}}, {2, 0.5}};
    CHECK(residual_of_positions<Corrections>(stiff, 0.5) < 1e-12);
    const Springs both{{{4, 0}, {0, 900}}, {2, 0.5}};
    CHECK(residual_of_positions<Corrections>(both, 0.5) > 1e-2);
}

namespace {

/// Positions whose matrix is constant; counts how often it is asked for.
struct ConstantPositions : Positions {
    int& asked;

    template <class Matrix>
    void constant_hessian(Matrix& out) const {
        ++asked;
        this->hessian_in_the_middle(out);
    }
};

}  // namespace

TEST_CASE("factors of a constant Hessian are computed when h changes") {
    using One =
        hvi::detail::PositionCorrections<Two, hvi::detail::ConstantHessian, 2, ModesOfSquare>;
    hvi::detail::OfStepSize<One> corrections;
    Springs system{{{4, 1.5}, {1.5, 9}}, {2, 0.5}};
    hvi::detail::VelocityLanes<Two, 2> s;
    int asked = 0;
    const ConstantPositions coupled{{system, s}, asked};
    const auto factorise = [&](double h) {
        s.h = h;
        return corrections.factorise(coupled);
    };
    CHECK(factorise(0.5));
    CHECK(factorise(0.5));
    CHECK(asked == 1);
    CHECK(factorise(0.25));
    CHECK(asked == 2);
    // Nothing is kept of a matrix that is none.
    system.G[0][0] = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(factorise(0.5));
    system.G[0][0] = 4;
    CHECK(factorise(0.25));
    CHECK(asked == 4);
    // A step of no length has factors, too.
    CHECK(factorise(0));
    CHECK(asked == 5);
}

TEST_CASE("one correction of pairs solves what is linear") {
    const Mixed system{{{4, 1.5}, {1.5, 9}}, {{0.3, -0.7}, {0.2, 0.5}}, {{2, 0.1}, {0.1, 0.5}}};
    hvi::detail::StageLanes<Two, 2> s;
    REQUIRE(s.begin({{0.3, -0.2}, {0.1, 0.4}}, 0.7).ok());
    s.weigh(half);
    Pairs coupled{system, s};
    coupled.stages();
    hvi::detail::PairCorrections<Two, hvi::detail::HessianInTheMiddle, 2, ModesOfA> corrections;
    REQUIRE(corrections.factorise(coupled));
    corrections.correct(coupled);
    const auto Lq = s.Lq, Lp = s.Lp;
    coupled.stages();
    coupled.all_slopes();
    for (std::size_t k = 0; k < 2; ++k) {
        for (std::size_t i = 0; i < 2; ++i) {
            CHECK(Lq[k][i] == Approx(s.Lq[k][i]).margin(1e-14));
            CHECK(Lp[k][i] == Approx(s.Lp[k][i]).margin(1e-14));
        }
    }
}

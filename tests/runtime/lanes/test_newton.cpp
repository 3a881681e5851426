// Newton's method for stages in lanes: that it solves the equations, how fast, and what it says
// where there is nothing to solve.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <catch2/catch.hpp>
#include <hvi/detail/lanes/stage_lanes.hpp>
#include <hvi/detail/lanes/velocity_lanes.hpp>
#include <hvi/detail/solvers/newton_of_lanes.hpp>

namespace {

using Two = std::array<double, 2>;
using Code = hvi::Status::Code;

// The tableau of gauss:2, and n = A A/b of it.
constexpr double root = 1.7320508075688772;
constexpr double b[2] = {0.5, 0.5};
constexpr double c[2] = {0.5 - root / 6, 0.5 + root / 6};
constexpr double m[2][2] = {{0.5, 0.5 - root / 3}, {0.5 + root / 3, 0.5}};
constexpr double n[2][2] = {{1.0 / 12, 1.0 / 12 - root / 12}, {1.0 / 12 + root / 12, 1.0 / 12}};

/// H = p^T K p/2 + q^T G q/2 + a sum_k q_k^4/4.
struct Springs {
    double G[2][2], K[2], a = 0;

    template <class Values>
    void dHdq(const Values& q, Values& out) const {
        out[0] = G[0][0] * q[0] + G[0][1] * q[1] + a * q[0] * q[0] * q[0];
        out[1] = G[1][0] * q[0] + G[1][1] * q[1] + a * q[1] * q[1] * q[1];
    }
    static constexpr bool has_diagonal_mass = true;
    template <class Values>
    void inverse_mass(const Values& p, Values& out) const {
        out[0] = K[0] * p[0];
        out[1] = K[1] * p[1];
    }
    void dHdp(const Two& p, Two& out) const { inverse_mass(p, out); }
    template <class Matrix>
    void d2Hdq2(const Two& q, Matrix& out) const {
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t j = 0; j < 2; ++j) { out(i, j) = G[i][j]; }
            out(i, i) += 3 * a * q[i] * q[i];
        }
    }
};

using PositionStages = hvi::detail::VelocityLanes<Two, 2>;

struct Positions {
    const Springs& system;
    PositionStages& s;
    mutable int hessians = 0;  ///< evaluated Hessians

    static constexpr bool has_q = true, has_p = false;
    static constexpr std::size_t stages = 2;
    static constexpr double coefficient(std::size_t j, std::size_t i) { return n[j][i]; }

    void begin_corrections() { positions(); }
    void momenta() {}
    void positions() { s.positions(hvi::detail::VelocityTable<double, 2>(c, n)); }
    void slopes_of_momenta() { s.forces(system); }
    void force_at_start(Two& out) const { system.dHdq(s.at.q, out); }
    template <class Matrix>
    void hessian_at_start(Matrix& out) const {
        ++hessians;
        system.d2Hdq2(s.at.q, out);
    }
    template <class Matrix>
    void hessian(std::size_t i, Matrix& out) const {
        ++hessians;
        system.d2Hdq2(s.position(i), out);
    }
    [[nodiscard]] double size_q(std::size_t k) const { return s.size_q(k); }
};

/// A step of size h that is begun, from a state with Q of the order 1.
PositionStages begun(const Springs& system, double h) {
    PositionStages s;
    REQUIRE(s.begin({{0.3, -0.2}, {0.1, 0.4}}, h).ok());
    s.weigh(system, b);
    s.drift_freely(system, hvi::detail::VelocityTable<double, 2>(c, n));
    return s;
}

/// How far the slopes are from those at their own stages, beside the largest.
double residual(Positions coupled) {
    const auto Lp = coupled.s.Lp;
    coupled.positions();
    coupled.slopes_of_momenta();
    double largest = 0, left = 0;
    for (std::size_t k = 0; k < 2; ++k) {
        for (std::size_t i = 0; i < 2; ++i) {
            largest = std::max(largest, std::abs(Lp[k][i]));
            left = std::max(left, std::abs(Lp[k][i] - coupled.s.Lp[k][i]));
        }
    }
    return left / largest;
}

using PositionNewton = hvi::NewtonOfPositionLanes::Iteration<Two>;

}  // namespace

TEST_CASE("Newton's method for positions in lanes solves stiff equations that are not linear") {
    for (const double h : {0.1, 1.0, 5.0}) {
        const Springs system{{{40, 1.5}, {1.5, 90}}, {2, 0.5}, 30};
        PositionStages s = begun(system, h);
        Positions coupled{system, s};
        PositionNewton newton;
        const hvi::Status status = newton.solve(coupled);
        REQUIRE(status.ok());
        CHECK(status.iterations < 30);
        CHECK(residual(coupled) < 1e-13);
    }
}

TEST_CASE("what is linear is solved by where Newton's method begins") {
    const Springs system{{{4, 1.5}, {1.5, 9}}, {2, 0.5}};
    PositionStages s = begun(system, 3);
    Positions coupled{system, s};
    hvi::detail::PositionsOfLanes<Two> unknowns;
    unknowns.rest(coupled);
    REQUIRE(unknowns.factorise_start(coupled));
    unknowns.begin(coupled);
    CHECK(residual(coupled) < 1e-14);
}

TEST_CASE("each stage has the second derivatives of its own place") {
    // One correction from stages near the solution leaves the square of what was left.
    const Springs system{{{4, 1.5}, {1.5, 9}}, {2, 0.5}, 30};
    PositionStages s = begun(system, 1);
    Positions coupled{system, s};
    PositionNewton newton;
    REQUIRE(newton.solve(coupled).ok());
    for (std::size_t k = 0; k < 2; ++k) {
        for (std::size_t i = 0; i < 2; ++i) { s.Lp[k].set(i, s.Lp[k][i] * (1 + 1e-5)); }
    }
    s.drifts(system);
    hvi::detail::PositionsOfLanes<Two> unknowns;
    const auto near = s.Lp;
    unknowns.rest(coupled);
    s.Lp = near;
    s.drifts(system);
    coupled.positions();
    REQUIRE(unknowns.factorise(coupled));
    unknowns.correct(coupled);
    CHECK(residual(coupled) < 1e-8);
}

TEST_CASE("factors are kept while the trajectory and h go on") {
    const Springs system{{{40, 1.5}, {1.5, 90}}, {2, 0.5}, 1};
    PositionStages s = begun(system, 0.1);
    Positions coupled{system, s};
    PositionNewton newton;
    const auto evaluated = [&](double h_before) {
        s.h_before = h_before;
        coupled.hessians = 0;
        REQUIRE(newton.solve(coupled).ok());
        return coupled.hessians;
    };
    const int first = evaluated(0);
    CHECK(first > 1);
    CHECK(evaluated(s.h) == 1);  // that of where it begins
    CHECK(evaluated(0.2) == first);
    CHECK(evaluated(0) == first);
}

namespace {

using One = std::array<double, 1>;

/// The implicit midpoint rule with h = 1, whose J is 1 + h^2 G K/4.
struct Midpoint {
    double G;
    hvi::detail::VelocityLanes<One, 1>& s;
    struct System {
        static constexpr bool has_diagonal_mass = true;
        void inverse_mass(const One& p, One& out) const { out = p; }
        void dHdp(const One& p, One& out) const { out = p; }
    } system;

    static constexpr bool has_q = true, has_p = false;
    static constexpr std::size_t stages = 1;
    static constexpr double coefficient(std::size_t, std::size_t) { return 0.25; }
    void begin_corrections() {}
    void momenta() {}
    void positions() {}
    void slopes_of_momenta() {}
    void force_at_start(One& out) const { out[0] = G; }
    void hessian_at_start(hvi::detail::SquareMatrix<double>& out) const { out(0, 0) = G; }
    void hessian(std::size_t, hvi::detail::SquareMatrix<double>& out) const { out(0, 0) = G; }
    [[nodiscard]] double size_q(std::size_t) const { return 1; }
};

}  // namespace

TEST_CASE("no factors: singular, or not finite") {
    constexpr double weight[1] = {1};
    const auto code = [&](double G) {
        hvi::detail::VelocityLanes<One, 1> s;
        REQUIRE(s.begin({{0.3}, {0.1}}, 1).ok());
        s.weigh(Midpoint::System{}, weight);
        Midpoint coupled{G, s, {}};
        hvi::NewtonOfPositionLanes::Iteration<One> newton;
        return newton.solve(coupled).code();
    };
    CHECK(code(1) == Code::ok);
    CHECK(code(-4) == Code::singular);
    CHECK(code(std::numeric_limits<double>::quiet_NaN()) == Code::not_finite);
    CHECK(code(std::numeric_limits<double>::infinity()) == Code::not_finite);
}

// ---- pairs ----

namespace {

/// H = q^T Hqq q/2 + q^T Hqp p + p^T Hpp p/2 + a (q_0^2 + 1) (p_1^2 + 1).
struct Mixed {
    double qq[2][2], qp[2][2], pp[2][2], a = 0;

    template <class Values>
    void dHdq(const Values& q, const Values& p, Values& out) const {
        out[0] = qq[0][0] * q[0] + qq[0][1] * q[1] + qp[0][0] * p[0] + qp[0][1] * p[1] +
                 2 * a * q[0] * (p[1] * p[1] + 1);
        out[1] = qq[1][0] * q[0] + qq[1][1] * q[1] + qp[1][0] * p[0] + qp[1][1] * p[1];
    }
    template <class Values>
    void dHdp(const Values& q, const Values& p, Values& out) const {
        out[0] = qp[0][0] * q[0] + qp[1][0] * q[1] + pp[0][0] * p[0] + pp[0][1] * p[1];
        out[1] = qp[0][1] * q[0] + qp[1][1] * q[1] + pp[1][0] * p[0] + pp[1][1] * p[1] +
                 2 * a * p[1] * (q[0] * q[0] + 1);
    }
};

using PairStages = hvi::detail::StageLanes<Two, 2>;

struct Pairs {
    const Mixed& system;
    PairStages& s;

    static constexpr bool has_q = true, has_p = true;
    static constexpr std::size_t stages = 2;
    static constexpr double coefficient(std::size_t j, std::size_t i) { return m[j][i]; }

    void begin_corrections() {
        momenta();
        positions();
    }
    void momenta() { s.momenta(hvi::detail::lane_columns(m)); }
    void positions() { s.positions(hvi::detail::lane_columns(m)); }
    void all_slopes() {
        auto Lp = s.forces(), Lq = s.velocities();
        system.dHdq(s.all_positions(), s.all_momenta(), Lp);
        system.dHdp(s.all_positions(), s.all_momenta(), Lq);
    }
    template <class Matrix>
    void hessian(std::size_t stage, Matrix& qq, Matrix& qp, Matrix& pp) const {
        const Two q = s.position(stage), p = s.momentum(stage);
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t j = 0; j < 2; ++j) {
                qq(i, j) = system.qq[i][j];
                qp(i, j) = system.qp[i][j];
                pp(i, j) = system.pp[i][j];
            }
        }
        qq(0, 0) += 2 * system.a * (p[1] * p[1] + 1);
        qp(0, 1) += 4 * system.a * q[0] * p[1];
        pp(1, 1) += 2 * system.a * (q[0] * q[0] + 1);
    }
    [[nodiscard]] double size_q(std::size_t k) const { return s.size_q(k); }
    [[nodiscard]] double size_p(std::size_t k) const { return s.size_p(k); }
};

double residual(Pairs coupled) {
    const auto Lq = coupled.s.Lq, Lp = coupled.s.Lp;
    coupled.begin_corrections();
    coupled.all_slopes();
    double left = 0;
    for (std::size_t k = 0; k < 2; ++k) {
        for (std::size_t i = 0; i < 2; ++i) {
            left = std::max({left, std::abs(Lq[k][i] - coupled.s.Lq[k][i]),
                             std::abs(Lp[k][i] - coupled.s.Lp[k][i])});
        }
    }
    return left;
}

}  // namespace

TEST_CASE("Newton's method for pairs in lanes") {
    Mixed system{{{4, 1.5}, {1.5, 9}}, {{0.3, -0.7}, {0.2, 0.5}}, {{2, 0.1}, {0.1, 0.5}}};
    PairStages s;
    REQUIRE(s.begin({{0.3, -0.2}, {0.1, 0.4}}, 0.7).ok());
    s.weigh(b);
    Pairs coupled{system, s};
    hvi::detail::PairsOfLanes<Two> unknowns;
    unknowns.rest(coupled);
    REQUIRE(unknowns.factorise_start(coupled));
    unknowns.correct(coupled);
    CHECK(residual(coupled) < 1e-14);  // as it is linear
    // And what is not; one correction more leaves the square of what was left.
    system.a = 3;
    hvi::NewtonOfPairLanes::Iteration<Two> newton;
    REQUIRE(newton.solve(coupled).ok());
    CHECK(residual(coupled) < 1e-14);
    for (std::size_t k = 0; k < 2; ++k) {
        for (std::size_t i = 0; i < 2; ++i) { s.Lq[k].set(i, s.Lq[k][i] + 1e-5); }
    }
    coupled.begin_corrections();
    REQUIRE(unknowns.factorise(coupled));
    unknowns.correct(coupled);
    CHECK(residual(coupled) < 1e-8);
}

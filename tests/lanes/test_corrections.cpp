// Corrections with one Hessian for all stages in lanes: the linear algebra, and who is chosen.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/detail/lanes/mode_lanes.hpp>
#include <hvi/detail/lanes/stage_lanes.hpp>
#include <hvi/detail/lanes/velocity_lanes.hpp>
#include <hvi/detail/solvers/automatic_of_lanes.hpp>
#include <hvi/detail/solvers/lane_corrections.hpp>

#include "tests/run/contracting_stages.hpp"

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

/// The tableau of gauss:2, whose A has the eigenvalues 1/4 +- i/sqrt(48), and A^2 1/24 +-
/// i/sqrt(192) (Hairer & Wanner, Solving Ordinary Differential Equations II, IV.5), with the same
/// eigenvectors (1, -+i (2 + sqrt 3)).
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
    template <class Values>
    void inverse_mass(const Values& p, Values& out) const {
        out[0] = K[0] * p[0];
        out[1] = K[1] * p[1];
    }
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
    s.weigh(half);
    system.inverse_mass(s.at.p, s.free_path);
    s.drift_freely(hvi::detail::VelocityTable<double, 2>(times, nystrom.n));
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
    CHECK(residual_of_positions<Corrections>(coupled, 20) < 1e-13);
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

/// The same matrix, constant; how often it is asked for.
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

// ---- who is chosen ----

namespace {

using contracting::CountedNewton;
using contracting::Vector;

/// Corrections change W by `corrected_rate` times what is left.
struct Stages : contracting::Stages {
    double corrected_rate = 0.1, start = 0;
    int corrections = 0, factors = 0;
    bool is_regular = true;

    void rest() { W = start = 0; }
};

struct Coupled : contracting::Coupled<Stages> {
    struct Corrections {
        bool factorise(Coupled& coupled) const {
            ++coupled.s.factors;
            return coupled.s.is_regular;
        }
        void correct(Coupled& coupled) const {
            ++coupled.s.corrections;
            const double solution = coupled.s.rate / (1 - coupled.s.rate);
            coupled.s.W = solution + coupled.s.corrected_rate * (coupled.s.W - solution);
        }
    } corrections;

    static constexpr hvi::detail::SolverCosts costs{1, 0, 3, 10};

    explicit Coupled(Stages& stages) : contracting::Coupled<Stages>{stages} {}
    void predict() { s.W = s.start = 0; }
    void begin_corrections() { positions(); }
};

struct Run {
    Stages stages;
    hvi::AutomaticOfLanes<CountedNewton>::Iteration<Vector> solver;

    hvi::Status step(double start = 0) {
        stages.W = stages.start = start;
        stages.sweeps = stages.corrections = stages.newtons = 0;
        return solver.solve(Coupled(stages));
    }
};

}  // namespace

TEST_CASE("sweeps that cost less are kept to, and corrections are tried in vain now and then") {
    Run run;
    run.stages.rate = 0.3;  // 30 sweeps; 8 corrections would cost 34
    run.stages.corrected_rate = 0.02;
    int tried = 0;
    for (int step = 0; step < 200; ++step) {
        REQUIRE(run.step().ok());
        CHECK(run.stages.sweeps > 20);
        tried += run.stages.corrections > 0;
    }
    // After 8, 16, 32, 64 and 64 steps.
    CHECK(tried >= 2);
    CHECK(tried <= 6);
}

TEST_CASE("corrections take over where they cost less, and sweeps come back") {
    Run run;
    run.stages.rate = 0.6;
    int sweeps = 0, corrections = 0;
    for (int step = 0; step < 100; ++step) {
        REQUIRE(run.step().ok());
        sweeps += run.stages.sweeps > 0;
        corrections += run.stages.corrections > 0;
    }
    CHECK(corrections > 80);
    CHECK(sweeps < 20);
    // The factors are kept while they serve.
    CHECK(run.stages.factors < 5);
    run.stages.rate = 0.01;
    run.stages.corrected_rate = 0.5;
    corrections = 0;
    for (int step = 0; step < 200; ++step) {
        REQUIRE(run.step().ok());
        corrections += run.stages.corrections > 0;
    }
    CHECK(corrections < 20);
}

TEST_CASE("where sweeps diverge, the step is corrected from the start on") {
    Run run;
    run.stages.rate = 3;
    REQUIRE(run.step(1e3).ok());
    CHECK(run.stages.corrections > 0);
    CHECK(run.stages.newtons == 0);
    CHECK(run.stages.start == 0);
    CHECK(run.stages.sweeps < 30);  // they are not gone on with
}

TEST_CASE("corrected slopes come nearer than their stages show") {
    // W is about 1e-3 beside Q = 1 + W, which does not show what is left of it below 1e-16.
    for (const double start : {1.0, 0.3, 0.1, 0.03, -0.7}) {
        Stages stages;
        stages.rate = 1.0 / 1001;
        stages.W = start;
        hvi::detail::CorrectedSweeps<Vector> sweeps;
        Coupled coupled(stages);
        REQUIRE(sweeps.solve<true>(coupled, coupled.corrections, {1, 0, 40}).ok());
        CHECK(std::abs(stages.W - stages.rate / (1 - stages.rate)) < 1.2e-17);
    }
}

TEST_CASE("where corrections fail too, Newton's method has the last word") {
    Run run;
    run.stages.rate = 3;
    run.stages.is_regular = false;
    REQUIRE(run.step().ok());
    CHECK(run.stages.newtons == 1);
    // For 1, 2, 4, ... steps more nothing else is tried.
    std::vector<int> pauses;
    int pause = 0;
    for (int step = 0; step < 200; ++step) {
        const int before = run.stages.factors;
        REQUIRE(run.step().ok());
        CHECK(run.stages.newtons == 1);
        if (run.stages.factors == before) {
            ++pause;
            continue;
        }
        pauses.push_back(pause);
        pause = 0;
    }
    CHECK(pauses == std::vector<int>{1, 2, 4, 8, 16, 32, 64, 64});
    run.stages.is_regular = true;
    for (int step = 0; step < 100; ++step) { REQUIRE(run.step().ok()); }
    CHECK(run.stages.corrections > 0);
}

TEST_CASE("what is spent counts the factors, and stops what is not worth it") {
    Stages stages;
    stages.rate = 0.5;
    stages.corrected_rate = 0.5;  // of which factors are computed anew in each iteration
    hvi::detail::CorrectedSweeps<Vector> sweeps;
    Coupled coupled(stages);
    const hvi::Status stopped = sweeps.solve<true>(coupled, coupled.corrections, {3, 10, 50});
    CHECK(stopped.code() == hvi::Status::Code::not_converged);
    CHECK(stopped.iterations == stages.corrections);
    CHECK(sweeps.spent() == 3 * stages.corrections + 10 * stages.factors);
    CHECK(sweeps.spent() >= 50);
    CHECK(sweeps.spent() < 50 + 13);
    // Those of the step size alone are not.
    stages.factors = 0;
    stages.W = 0;
    REQUIRE(sweeps.solve<false>(coupled, coupled.corrections, {3, 0, 400}).ok());
    CHECK(stages.factors == 1);
}

TEST_CASE("when factors are computed anew") {
    using Sweeps = hvi::detail::CorrectedSweeps<Vector>;
    using Renewal = Sweeps::Renewal;
    const auto factors = [](double corrected_rate, Renewal renewal) {
        Stages stages;
        stages.rate = 0.5;
        stages.corrected_rate = corrected_rate;
        stages.W = 0;
        Sweeps sweeps;
        sweeps.assume_factors();
        Coupled coupled(stages);
        const hvi::Status status =
            sweeps.solve<true>(coupled, coupled.corrections, {1, 0, 200, renewal});
        CHECK(status.ok() == (renewal != Renewal::never || corrected_rate < 0.25));
        return stages.factors;
    };
    CHECK(factors(0.1, Renewal::where_slow) == 0);
    CHECK(factors(0.1, Renewal::eager) == 1);
    CHECK(factors(0.1, Renewal::never) == 0);
    CHECK(factors(0.5, Renewal::where_slow) > 10);
    CHECK(factors(0.5, Renewal::eager) == factors(0.5, Renewal::where_slow) + 1);
    CHECK(factors(0.5, Renewal::never) == 0);
}

TEST_CASE("corrections that are fast end with the one that is below rounding") {
    Stages stages;
    stages.rate = 0.5;
    stages.corrected_rate = 1e-3;  // of 1: 1e-3, ..., 1e-15, and one more
    stages.W = 0;
    hvi::detail::CorrectedSweeps<Vector> sweeps;
    Coupled coupled(stages);
    const hvi::Status status = sweeps.solve<true>(coupled, coupled.corrections, {1, 0, 40});
    REQUIRE(status.ok());
    CHECK(status.iterations == 7);
    CHECK(stages.W == 1);
}

TEST_CASE("starting values that lead on a way round are not taken for a while") {
    Run run;
    run.stages.rate = 0.6;
    for (int step = 0; step < 50; ++step) { REQUIRE(run.step(1).ok()); }
    int far = 0;
    for (int step = 0; step < 100; ++step) {
        REQUIRE(run.step(1e4).ok());  // four corrections more than from rest
        far += run.stages.start != 0;
    }
    CHECK(far < 10);
    // And are tried again.
    int near = 0;
    for (int step = 0; step < 200; ++step) {
        REQUIRE(run.step(1.5).ok());  // the solution is 1.5
        near += run.stages.start != 0;
    }
    CHECK(near > 100);
}

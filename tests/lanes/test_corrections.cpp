// Corrections with one Hessian for all stages in lanes: the linear algebra, and who is chosen.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/detail/lanes/mode_lanes.hpp>
#include <hvi/detail/solvers/automatic_of_lanes.hpp>

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
    for (int round = 0; round < 50; ++round) {
        double S[n][n];
        for (auto& row : S) {
            for (double& entry : row) { entry = number(random); }
        }
        ThreeOfFour modes;
        if (!modes.compute([&](std::size_t k, std::size_t l) { return S[k][l]; })) { continue; }
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

namespace {

using Vector = std::array<double, 1>;

/// As in tests/run/test_automatic.cpp: sweeps change Q by `rate` times what the one before did,
/// corrections by `corrected_rate`.
struct Stages {
    double rate = 0.5, corrected_rate = 0.1;
    bool continues = true;
    double h = 1, h_before = 1;
    std::size_t n = 1;
    hvi::State<Vector> change;
    double Q = 0, W = 0, start = 0;
    int sweeps = 0, corrections = 0, factors = 0, newtons = 0;
    bool is_regular = true;
};

struct Coupled {
    Stages& s;

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
    static constexpr bool separable = true, has_q = true, has_p = false;

    void predict() { s.W = s.start = 0; }
    void begin_corrections() { positions(); }
    void momenta() {}
    void velocities() {}
    void positions() {
        const double before = s.Q;
        s.Q = 1 + s.W;
        s.change.q[0] = std::abs(s.Q - before);
    }
    void forces() {
        ++s.sweeps;
        s.W = s.rate * s.Q;
    }
    [[nodiscard]] double size_q(std::size_t) const { return std::abs(s.Q) + std::abs(s.W); }
};

struct CountedNewton {
    template <class>
    struct Iteration {
        [[nodiscard]] hvi::Status solve(Coupled coupled) const {
            ++coupled.s.newtons;
            return hvi::Status(hvi::Status::Code::ok, 1);
        }
    };
};

struct Run {
    Stages stages;
    hvi::AutomaticOfLanes<CountedNewton>::Iteration<Vector> solver;

    hvi::Status step(double start = 0) {
        stages.W = stages.start = start;
        stages.sweeps = stages.corrections = stages.newtons = 0;
        return solver.solve(Coupled{stages, {}});
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

TEST_CASE("where sweeps diverge, the step is corrected from slopes at its start") {
    Run run;
    run.stages.rate = 3;
    REQUIRE(run.step(1e3).ok());
    CHECK(run.stages.corrections > 0);
    CHECK(run.stages.newtons == 0);
    CHECK(run.stages.start == 0);
    CHECK(run.stages.sweeps < 30);  // they are not gone on with
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

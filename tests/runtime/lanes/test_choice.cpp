// The choice of a solver for stages in lanes, and the end of corrections.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include <catch2/catch.hpp>
#include <hvi/detail/solvers/automatic_of_lanes.hpp>
#include <hvi/detail/solvers/corrected_sweeps.hpp>

#include "tests/runtime/run/contracting_stages.hpp"

namespace {

using contracting::CountedNewton;
using contracting::Vector;

/// Stages in which corrections multiply errors of W by `corrected_rate`.
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

TEST_CASE("factors are those of one step size, also where steps of several sizes go on") {
    Run run;
    run.stages.rate = 3;
    REQUIRE(run.step().ok());
    const auto factors_of_step = [&](double h) {
        run.stages.h = h;
        run.stages.factors = 0;
        REQUIRE(run.step().ok());
        CHECK(run.stages.sweeps == 0);
        return run.stages.factors;
    };
    CHECK(factors_of_step(1) == 0);
    CHECK(factors_of_step(-1.5) == 1);
    CHECK(factors_of_step(-1.5) == 0);
    CHECK(factors_of_step(1) == 1);
}

namespace {

/// Equations with a linear part, whose factors cost too much for a trial.
struct CoupledWithLinear : Coupled {
    struct Linear {
        bool factorise(CoupledWithLinear&) const { return true; }
        void correct(CoupledWithLinear& coupled) const { coupled.corrections.correct(coupled); }
    } linear;

    static constexpr hvi::detail::SolverCosts costs{1, 2, 3, 1000};

    using Coupled::Coupled;
};

}  // namespace

TEST_CASE("a way that is not worth a trial does not keep the next one from it") {
    Stages stages;
    stages.rate = 0.3;
    stages.corrected_rate = 0.9;
    hvi::AutomaticOfLanes<CountedNewton>::Iteration<Vector> solver;
    const auto corrections_in_steps = [&](int steps) {
        stages.corrections = 0;
        for (int i = 0; i < steps; ++i) {
            stages.W = 0;
            REQUIRE(solver.solve(CoupledWithLinear(stages)).ok());
        }
        return stages.corrections;
    };
    CHECK(corrections_in_steps(12) > 0);  // in vain
    stages.corrected_rate = 0.01;
    CHECK(corrections_in_steps(200) > 100);
    CHECK(stages.factors == 0);
}

TEST_CASE("of steps of several sizes in a row the largest decide how they are solved") {
    Run run;
    int large = 0, small = 0;
    for (int step = 0; step < 400; ++step) {
        const bool is_large = step % 2 == 0;
        run.stages.h = is_large ? 2 : -0.5;
        run.stages.rate = is_large ? 0.7 : 0.05;  // 100 sweeps, or 13
        run.stages.corrected_rate = 0.05;
        REQUIRE(run.step().ok());
        (is_large ? large : small) += run.stages.corrections > 0;
    }
    CHECK(large > 180);
    CHECK(small > 180);
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
    // NOTE: factors that depend on the step size alone are not computed anew.
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
        sweeps.assume_factors(1);
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

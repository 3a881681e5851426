// When hvi::Automatic leaves fixed points for Newton's method, and when it comes back.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/detail/solvers/automatic.hpp>

#include "contracting_stages.hpp"

namespace {

using contracting::CountedNewton;
using contracting::Coupled;
using contracting::Stages;
using contracting::Vector;

/// Steps that all contract by some rate, or do not.
class Run {
public:
    /// Whether the step came to its end by Newton's method alone or after fixed points.
    bool takes_newton(double rate, bool goes_on = true) {
        stages_.rate = rate;
        stages_.goes_on = goes_on;
        stages_.W = 0;
        const int before = stages_.newtons;
        last_ = solver_.solve(Coupled<Stages>{stages_});
        REQUIRE(last_.ok());
        return stages_.newtons > before;
    }

    [[nodiscard]] int iterations() const { return last_.iterations; }

private:
    Stages stages_;
    hvi::Automatic<CountedNewton>::Iteration<Vector> solver_;
    hvi::Status last_;
};

constexpr double in_50_sweeps = 0.5, in_120_sweeps = 0.75, never = 2;

}  // namespace

TEST_CASE("fixed points that take fewer sweeps than Newton's method is worth are kept to") {
    Run run;
    for (int step = 0; step < 10; ++step) {
        CHECK_FALSE(run.takes_newton(in_50_sweeps));
        CHECK(run.iterations() > 40);
        CHECK(run.iterations() < 60);
    }
}

TEST_CASE("after a step that fails once, fixed points are soon tried again") {
    Run run;
    CHECK_FALSE(run.takes_newton(in_50_sweeps));
    CHECK(run.takes_newton(never));
    CHECK(run.takes_newton(in_50_sweeps));
    for (int step = 0; step < 10; ++step) { CHECK_FALSE(run.takes_newton(in_50_sweeps)); }
    // The past is forgotten: the next pause is as short as the first.
    CHECK(run.takes_newton(never));
    CHECK(run.takes_newton(in_50_sweeps));
    CHECK_FALSE(run.takes_newton(in_50_sweeps));
}

TEST_CASE("where steps go on to be slow, the pauses grow to 64 steps") {
    Run run;
    std::vector<int> pauses;
    int pause = 0;
    for (int step = 0; step < 400; ++step) {
        if (run.takes_newton(in_120_sweeps)) {
            ++pause;
            continue;
        }
        CHECK(run.iterations() > 100);
        if (step > 0) { pauses.push_back(pause); }
        pause = 0;
    }
    CHECK(pauses == std::vector<int>{1, 2, 4, 8, 16, 32, 64, 64, 64, 64, 64});
}

TEST_CASE("a step from elsewhere knows nothing of pauses") {
    Run run;
    for (int step = 0; step < 20; ++step) { static_cast<void>(run.takes_newton(never)); }
    CHECK(run.takes_newton(never, false));
    CHECK(run.takes_newton(in_50_sweeps));
    CHECK_FALSE(run.takes_newton(in_50_sweeps));
}

namespace {

/// Stages as in Picard's iteration of a long step: changes grow tenfold in three sweeps, and then
/// fall.
struct Growing : Stages {
    double W_of_sweep() {
        rate = sweeps <= 3 ? 10 : 0.1;
        return rate * Q;
    }
};

struct CoupledGrowing : Coupled<Growing> {
    explicit CoupledGrowing(Growing& stages) : Coupled<Growing>{stages} {}
    void forces() {
        ++s.sweeps;
        s.W = s.W_of_sweep();
    }
};

}  // namespace

TEST_CASE("changes that grow end fixed points only where there is another way") {
    Growing stages;
    hvi::detail::Sweeps<Vector, false> sweeps;
    CHECK(sweeps.solve(CoupledGrowing(stages)).ok());
    CHECK(stages.sweeps > 10);
    stages = Growing();
    const hvi::Status ended = sweeps.solve<true>(CoupledGrowing(stages));
    CHECK(ended.code() == hvi::Status::Code::not_converged);
    CHECK(stages.sweeps < 5);
}

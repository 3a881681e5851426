// When hvi::Automatic leaves fixed points for Newton's method, and when it comes back.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/detail/solvers/automatic.hpp>

namespace {

using Vector = std::array<double, 1>;

/// Q = 1 + W, W = rate Q: sweeps change Q by `rate` times what the one before did.
struct Stages {
    double rate = 0.5;
    bool continues = true;
    double h = 1, h_before = 1;
    std::size_t n = 1;
    hvi::State<Vector> change;
    double Q = 0, W = 0;
    int newtons = 0;
};

struct Coupled {
    Stages& s;

    static constexpr bool separable = true;
    static constexpr bool has_q = true;
    static constexpr bool has_p = false;

    void momenta() {}
    void velocities() {}
    void positions() {
        const double before = s.Q;
        s.Q = 1 + s.W;
        s.change.q[0] = std::abs(s.Q - before);
    }
    void forces() { s.W = s.rate * s.Q; }
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

/// Steps that all contract by some rate, or do not.
class Run {
public:
    /// Whether the step came to its end by Newton's method alone or after fixed points.
    bool takes_newton(double rate, bool continues = true) {
        stages_.rate = rate;
        stages_.continues = continues;
        stages_.W = 0;
        const int before = stages_.newtons;
        last_ = solver_.solve(Coupled{stages_});
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
    // What has been is forgotten: the next pause is as short.
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

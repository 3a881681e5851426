// A solution that others are measured against.
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include <driver/answer.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/state.hpp>

namespace hvi::driver {

/// Halves steps until the end no longer moves. `Stepper` computes in numbers with more digits than
/// double.
template <class Stepper>
class ReferenceRun {
public:
    using Scalar = typename Stepper::Scalar;
    using State = typename Stepper::State;

    ReferenceRun(double until, std::int64_t steps, double wanted, double seconds)
        : until_(until), steps_(steps), wanted_(wanted), seconds_(seconds) {}

    /// Says where it ends, and how far that is from the end with steps of twice the size.
    void run() {
        const auto start = std::chrono::steady_clock::now();
        std::optional<State> coarse = end();
        for (int failures = coarse ? 0 : 1;;) {
            const auto before = std::chrono::steady_clock::now();
            steps_ *= 2;
            const std::optional<State> fine = end();
            const auto now = std::chrono::steady_clock::now();
            const double error = coarse && fine ? distance(*coarse, *fine) : infinite;
            const std::chrono::duration<double> taken = now - start, last = now - before;
            failures += fine ? 0 : 1;
            if (error <= wanted_ || failures > most_failures ||
                taken.count() + 2 * last.count() > seconds_) {
                return tell(fine, error);
            }
            coarse = fine;
        }
    }

private:
    static constexpr int most_failures = 8;  // that smaller steps may mend
    static constexpr double infinite = std::numeric_limits<double>::infinity();

    /// Empty where a step fails.
    [[nodiscard]] std::optional<State> end() const {
        Stepper stepper{typename Stepper::Parameters{}};
        State x = Stepper::initial();
        const Scalar h = Scalar(until_) / static_cast<Scalar>(steps_);
        for (std::int64_t i = 0; i < steps_; ++i) {
            if (!stepper.step(x, h).ok()) { return {}; }
        }
        return x;
    }

    /// Relative where b is not 0.
    [[nodiscard]] static double distance(const State& a, const State& b) {
        Scalar sum = 0, size = 0;
        const auto look = [&](const auto& u, const auto& v) {
            for (std::size_t k = 0; k < u.size(); ++k) {
                sum += (u[k] - v[k]) * (u[k] - v[k]);
                size += v[k] * v[k];
            }
        };
        look(a.q, b.q);
        look(a.p, b.p);
        return std::sqrt(static_cast<double>(size > 0 ? sum / size : sum));
    }

    void tell(const std::optional<State>& x, double error) const {
        say("bits", static_cast<std::int64_t>(detail::bits<Scalar>));
        say("steps", steps_);
        say("error", error);
        if (!x) { return; }
        for (const auto& q : x->q) { say("end", static_cast<double>(q)); }
        for (const auto& p : x->p) { say("end", static_cast<double>(p)); }
    }

    double until_;
    std::int64_t steps_;
    double wanted_, seconds_;
};

/// The main() of a program that is called as `program UNTIL STEPS WANTED SECONDS`: it begins with
/// so many steps, and ends when halving them moves the end by no more than WANTED, or time is up.
template <class Stepper>
int reference(int argc, char** argv) {
    double until = 0, wanted = 0, seconds = 0;
    std::int64_t steps = 0;
    if (argc != 5 || !read(argv[1], until) || !read(argv[2], steps) || !read(argv[3], wanted) ||
        !read(argv[4], seconds) || steps < 1) {
        std::fprintf(stderr, "usage: %s UNTIL STEPS WANTED SECONDS\n", argv[0]);
        return 2;
    }
    ReferenceRun<Stepper>(until, steps, wanted, seconds).run();
    return 0;
}

}  // namespace hvi::driver

// A reference solution that others are compared with.
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <utility>

#include <driver/answer.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/trajectories/flat.hpp>
#include <hvi/detail/trajectories/take.hpp>
#include <hvi/state.hpp>

namespace hvi::driver {

/// Settings of the search for a reference: it begins with `steps` steps, and ends when halving them
/// moves the end by no more than `wanted`, or time is up.
struct ReferenceWishes {
    double until = 0;
    std::int64_t steps = 0;
    double wanted = 0, seconds = 0;

    /// Reads the words UNTIL STEPS WANTED SECONDS. Returns false where they have another form.
    [[nodiscard]] bool read_words(char** words) {
        return read(words[0], until) && read(words[1], steps) && read(words[2], wanted) &&
               read(words[3], seconds) && steps >= 1;
    }
};

/// Halves steps until the end no longer moves. The Stepper of `Problem` computes in numbers with
/// more digits than double.
template <class Problem>
class ReferenceRun {
public:
    using Stepper = typename Problem::Stepper;
    using Scalar = typename Stepper::Scalar;
    using State = typename Stepper::State;

    /// End of the last run that came to it, and its distance from the end with steps of twice the
    /// size.
    struct Found {
        std::optional<State> end;
        double error;
    };

    explicit ReferenceRun(const ReferenceWishes& wishes) : wishes_(wishes) {}

    [[nodiscard]] Found run() {
        const auto start = std::chrono::steady_clock::now();
        std::optional<State> coarse = end();
        for (int failures = coarse ? 0 : 1;;) {
            const auto before = std::chrono::steady_clock::now();
            wishes_.steps *= 2;
            std::optional<State> fine = end();
            const auto now = std::chrono::steady_clock::now();
            const double error = coarse && fine ? distance(*coarse, *fine) : infinite;
            const std::chrono::duration<double> taken = now - start, last = now - before;
            failures += fine ? 0 : 1;
            if (error <= wishes_.wanted || failures > most_failures ||
                taken.count() + 2 * last.count() > wishes_.seconds) {
                return {std::move(fine), error};
            }
            coarse = std::move(fine);
        }
    }

private:
    static constexpr int most_failures = 8;  // failures that smaller steps may mend
    static constexpr double infinite = std::numeric_limits<double>::infinity();

    /// Returns the end of a run; empty where a step fails.
    [[nodiscard]] std::optional<State> end() const {
        Stepper stepper = Problem::stepper();
        State x = Problem::initial();
        const Scalar h = Scalar(wishes_.until) / static_cast<Scalar>(wishes_.steps);
        if (!detail::take(stepper, x, h, wishes_.steps).ok()) { return {}; }
        return x;
    }

    /// Returns the distance of a and b, relative where b is not 0.
    [[nodiscard]] static double distance(const State& a, const State& b) {
        Scalar sum = 0, size = 0;
        const auto look = [&](const auto& u, const auto& v) {
            for (std::size_t k = 0; k < u.size(); ++k) {
                sum += (u[k] - v[k]) * (u[k] - v[k]);
                size += v[k] * v[k];
            }
        };
        const auto& first = detail::flat<Stepper>(a);
        const auto& second = detail::flat<Stepper>(b);
        look(first.q, second.q);
        look(first.p, second.p);
        return std::sqrt(static_cast<double>(size > 0 ? sum / size : sum));
    }

    ReferenceWishes wishes_;
};

/// Problem made of a Stepper and its scene.
template <class S>
struct SceneOf {
    using Stepper = S;
    static Stepper stepper() { return Stepper{typename Stepper::Parameters{}}; }
    static typename Stepper::State initial() { return Stepper::initial(); }
};

/// The main() of a program that is called as `program UNTIL STEPS WANTED SECONDS`, and writes the
/// end of the run.
template <class Stepper>
int reference(int argc, char** argv) {
    ReferenceWishes wishes;
    if (argc != 5 || !wishes.read_words(argv + 1)) {
        std::fprintf(stderr, "usage: %s UNTIL STEPS WANTED SECONDS\n", argv[0]);
        return 2;
    }
    const auto found = ReferenceRun<SceneOf<Stepper>>(wishes).run();
    say("bits", static_cast<std::int64_t>(detail::bits<typename Stepper::Scalar>));
    say("error", found.error);
    if (!found.end) { return 0; }
    const auto& end = detail::flat<Stepper>(*found.end);
    for (const auto& q : end.q) { say("end", static_cast<double>(q)); }
    for (const auto& p : end.p) { say("end", static_cast<double>(p)); }
    return 0;
}

}  // namespace hvi::driver

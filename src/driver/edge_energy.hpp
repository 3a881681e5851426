// Motion of the energy over a long run.
// SPDX-License-Identifier: MIT
//
// For `Problem` see edge_steps.hpp.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <driver/answer.hpp>
#include <driver/edge_steps.hpp>
#include <hvi/state.hpp>

namespace hvi::driver {

/// Means of values in the two halves of a window, weighted by (u (1 - u))^4, where u goes from 0 to
/// 1 in each half: oscillations leave next to nothing in the means.
class HalfMeans {
public:
    /// Adds a value; `part` goes from 0 to 1 over the window.
    void see(double value, double part) {
        Mean& half = part > 0.5 ? second_ : first_;
        const double u = part > 0.5 ? 2 * part - 1 : 2 * part;
        const double square = u * (1 - u) * u * (1 - u);
        half.weighted += square * square * value;
        half.weights += square * square;
    }
    [[nodiscard]] double difference() const {
        return second_.weighted / second_.weights - first_.weighted / first_.weights;
    }

private:
    struct Mean {
        double weighted = 0, weights = 0;
    };
    Mean first_, second_;
};

/// A problem whose steppers forget the memory of the step before, above all the remainders of sums.
template <class Problem>
struct Forgetful {
    struct Stepper : Problem::Stepper {
        using Base = typename Problem::Stepper;

        explicit Stepper(const Base& base) : Base(base) {}

        [[nodiscard]] Status step(typename Base::State& x, double h) {
            Base::reset();
            return Base::step(x, h);
        }
    };

    static Stepper stepper(const std::vector<double>& values) {
        return Stepper(Problem::stepper(values));
    }
    static typename Stepper::Base::State initial() { return Problem::initial(); }
};

/// The command `energy H STEPS STATE... VALUES...`: for windows of n to 2n steps, n = 256, 512, ...
/// up to STEPS, writes 2n and the difference of the mean energies of the second and the first half
/// of the window: see HalfMeans.
template <class Problem>
int energy(const std::vector<std::string_view>& words) {
    EdgeWords<Problem> edge;
    if (!edge.read(words)) { return 2; }
    auto stepper = Problem::stepper(edge.values);
    auto x = edge.x;
    const double start = stepper.energy(x);
    std::int64_t begin = 256;
    HalfMeans means;
    for (std::int64_t taken = 1; taken <= edge.steps; ++taken) {
        const Status status = stepper.step(x, edge.h);
        if (!status.ok()) {
            say("status", status.message());
            return 0;
        }
        if (taken <= begin) { continue; }
        means.see(stepper.energy(x) - start,
                  static_cast<double>(taken - begin) / static_cast<double>(begin));
        if (taken < 2 * begin) { continue; }
        say("window", taken);
        say("shift", means.difference());
        begin = taken;
        means = {};
    }
    say("status", "ok");
    return 0;
}

}  // namespace hvi::driver

// End, cost and time of a run of a scene of any size.
// SPDX-License-Identifier: MIT
//
// For `Problem` see departure.hpp.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <driver/answer.hpp>
#include <driver/cost.hpp>
#include <driver/departures.hpp>
#include <driver/large_run.hpp>
#include <driver/state_file.hpp>
#include <driver/pace.hpp>

namespace hvi::driver {

/// Returns the distance of a state from a reference, relative where the reference is not 0. `late`
/// is how far the time of the state is beyond that of the reference, by the rounding of the step
/// size. The motion in that time is subtracted, at a velocity that a short step tells.
/// Precondition: the sizes fit.
template <class Problem, class State>
[[nodiscard]] double distance(const State& x, const std::vector<double>& reference, double h,
                              double late) {
    auto stepper = Problem::stepper();
    const double shorter = h / (1 << 20);
    State y = x;
    static_cast<void>(stepper.step(y, shorter));
    double sum = 0, size = 0;
    std::size_t at = 0;
    const auto look = [&](const auto& here, const auto& moved) {
        for (std::size_t k = 0; k < here.size(); ++k, ++at) {
            const double since = late * ((moved[k] - here[k]) / shorter);
            const double difference = here[k] - reference[at] - since;
            sum += difference * difference;
            size += reference[at] * reference[at];
        }
    };
    look(x.q, y.q);
    look(x.p, y.p);
    return std::sqrt(size > 0 ? sum / size : sum);
}

/// Writes how long runs take, and returns the number of evaluations of a run without looks at the
/// invariants. NOTE: a run that takes seconds is not repeated. Its time is that of the run with
/// looks, less the time of the looks.
template <class Problem>
std::int64_t tell_time_of_run(const LargeRun<Problem>& looked_at, double h, std::int64_t steps,
                              double seconds) {
    constexpr double longest_repeated = 2;
    if (looked_at.seconds() > longest_repeated) {
        say("seconds", looked_at.seconds());
        say("spread", std::numeric_limits<double>::quiet_NaN());
        return looked_at.outcome().evaluations;
    }
    std::int64_t evaluations = 0;
    tell_time(seconds, [&] {
        return [&evaluations, stepper = Problem::stepper(), x = Problem::initial(), h,
                steps]() mutable {
            const bool is_ok = detail::take(stepper, x, h, steps).ok();
            evaluations = static_cast<std::int64_t>(stepper.evaluations());
            return is_ok;
        };
    });
    return evaluations;
}

/// The command `measure H STEPS SECONDS UNTIL FILE`: as measure(), but it compares the end with
/// that in the file, at the time UNTIL.
template <class Problem>
int large_measure(const std::vector<std::string_view>& words) {
    constexpr std::int64_t most_looks = 100;
    double h = 0, seconds = 0, until = 0;
    std::int64_t steps = 0;
    const bool is_right = words.size() == 5 && read(words[0], h) && read(words[1], steps) &&
                          read(words[2], seconds) && read(words[3], until) && steps >= 0;
    if (!is_right) { return 2; }
    LargeRun<Problem> run(h, steps);
    run.run(most_looks, [](double) {});
    const auto& x = run.state();
    Outcome outcome = run.outcome();
    if (!outcome.ok()) {
        tell(outcome, run.invariants());
        return 0;
    }
    const std::size_t count = x.q.size() + x.p.size();
    const std::vector<double> reference = numbers_in(std::string(words[4]).c_str(), count);
    if (reference.size() != count) { return 2; }
    say("error",
        distance<Problem>(x, reference, h, std::fma(static_cast<double>(steps), h, -until)));
    if (seconds > 0) { outcome.evaluations = tell_time_of_run(run, h, steps, seconds); }
    tell(outcome, run.invariants());
    return 0;
}

/// The command `departures H STEPS SAMPLES`, as departures() has it.
template <class Problem>
int large_departures(const std::vector<std::string_view>& words) {
    double h = 0;
    std::int64_t steps = 0, samples = 0;
    const bool is_right = words.size() == 3 && read(words[0], h) && read(words[1], steps) &&
                          read(words[2], samples) && steps >= 0 && samples >= 1;
    if (!is_right) { return 2; }
    LargeRun<Problem> run(h, steps);
    DepartureSamples<Problem> all(h * static_cast<double>(steps), samples);
    run.run(samples, [&](double t) { all.see(t, run.invariants()); });
    return 0;
}

/// The command `pace H STEPS`: writes how long a step takes, over at most half a second.
template <class Problem>
int large_pace(const std::vector<std::string_view>& words) {
    double h = 0;
    std::int64_t steps = 0;
    if (words.size() != 2 || !read(words[0], h) || !read(words[1], steps)) { return 2; }
    say("seconds_of_step", seconds_of_step<Problem>(Watch::rows, h, steps));
    return 0;
}

}  // namespace hvi::driver

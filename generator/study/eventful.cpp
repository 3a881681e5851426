// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/study/eventful.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "generator/interpret/event_program.hpp"
#include "generator/scene/start.hpp"
#include "generator/simulate/eventful_run.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

/// The events that change where a run goes.
std::vector<DrivenEvent> jumps_of(const LoweredScene& scene) {
    HVI_CHECK(scene.written.has_value());
    std::vector<DrivenEvent> events = driven_events(scene.system, *scene.written);
    std::erase_if(events, [](const DrivenEvent& each) { return !each.set && !each.event.is_kink; });
    for (DrivenEvent& event : events) event.stop = 0;
    return events;
}

double relative_distance(const std::vector<double>& x, const std::vector<double>& y) {
    double sum = 0, size = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        sum += (x[k] - y[k]) * (x[k] - y[k]);
        size += y[k] * y[k];
    }
    return std::sqrt(size > 0 ? sum / size : sum);
}

/// Ends of runs with more and more steps, of which the one that moved least is kept.
class Refined {
public:
    /// Whether more steps may still help.
    [[nodiscard]] bool add(const std::vector<double>& state) {
        constexpr double round_off = 1e-9;  // below it a larger error is one of rounding
        const double error = before_.empty() ? infinite : relative_distance(before_, state);
        const bool is_better = best_.empty() || error < error_;
        const bool helps =
            is_better ? error > std::numeric_limits<double>::epsilon() : error_ > round_off;
        if (is_better) {
            best_ = state;
            error_ = error;
        }
        before_ = state;
        return helps;
    }

    [[nodiscard]] double error() const { return error_; }
    [[nodiscard]] const std::vector<double>& state() const { return best_; }

private:
    static constexpr double infinite = std::numeric_limits<double>::infinity();
    std::vector<double> before_, best_;
    double error_ = infinite;
};

/// Seconds since it was made.
class Stopwatch {
public:
    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

[[noreturn]] void refuse_solution(const Contender& contender) {
    throw MathError("there is no reference solution: " + contender.title +
                        " does not come to the end",
                    {}, "give the scene an [exact] solution, or another end by `until`");
}

}  // namespace

bool is_eventful(const Scene& scene) {
    return scene.scale || scene.kinks ||
           std::any_of(scene.events.begin(), scene.events.end(),
                       [](const IndexedEvent& event) { return event.set.has_value(); });
}

EventfulRuns::EventfulRuns(const LoweredScene& scene, double until)
    : scene_(scene.scene), until_(until), events_(jumps_of(scene)) {
    if (scene_.scale) clock_ = ScaledClock{until};
}

// NOTE: in scaled time nobody knows how many steps it takes.
EventfulRunWishes EventfulRuns::wishes(double h, std::int64_t most) const {
    const std::int64_t steps = clock_ ? most : std::llround(until_ / h);
    return {.h = h, .steps = steps, .events = events_, .clock = clock_};
}

// NOTE: of scaled time the last step is a shorter one, which counts.
Measurement EventfulRuns::measured(const Contender& contender, double h, double seconds,
                                   std::int64_t most) const {
    EventfulRunWishes all = wishes(h, most);
    all.seconds = seconds;
    Measurement run = measure(contender.module.target(), all).run;
    if (clock_ && run.ok()) ++run.steps;
    return run;
}

DepartureSamples EventfulRuns::departures(const Contender& contender, double h,
                                          std::int64_t parts) const {
    EventfulRunWishes all = wishes(h, most_steps);
    all.samples = parts;
    return sample_departures(contender.module.target(), all);
}

// NOTE: a run may stop where dt/ds becomes 0, and never come to its end, so that it gets more steps
// only where there is time for them.
double EventfulRuns::length(const Contender& gauss_10, double h, double seconds) const {
    if (!clock_) return until_;
    constexpr std::int64_t fewest = 50, first_most = 4096, more = 8;
    constexpr int most_tries = 40;
    const Stopwatch clock;
    std::int64_t most = first_most;
    for (int tries = 0; tries < most_tries && most < most_steps; ++tries) {
        const double before = clock.seconds();
        const Measurement run = measured(gauss_10, h, 0, most);
        if (run.ok() && run.steps >= fewest) return h * static_cast<double>(run.steps);
        if (run.ok() || run.steps < most) {
            h /= 2;
            continue;
        }
        const double now = clock.seconds();
        if (now + more * (now - before) > seconds) break;
        most *= more;
    }
    refuse_solution(gauss_10);
}

Reference EventfulRuns::reference(const Contender& gauss_10, double length,
                                  std::int64_t first_count, double wanted, double seconds) const {
    if (const WrittenOutScene in_time = unrolled(scene_); has_exact_states(in_time))
        return {"exact", 0, exact_state(in_time, until_)};
    constexpr std::int64_t most_counted = 100'000'000;
    const Stopwatch clock;
    Refined ends;
    for (std::int64_t count = std::max<std::int64_t>(1, first_count / 16); count < most_counted;
         count *= 2) {
        const double before = clock.seconds();
        const Measurement run = measured(gauss_10, length / static_cast<double>(count), 0);
        if (run.ok() && !ends.add(std::get<EndOfRun>(run.end).state)) break;
        if (ends.error() <= wanted) break;
        const double now = clock.seconds();
        if (now + 2 * (now - before) > seconds) break;
    }
    if (ends.state().empty()) refuse_solution(gauss_10);
    return {gauss_10.title + " in 53 bits", ends.error(), ends.state()};
}

Contender eventful_reference_contender(Builds& builds, const LoweredScene& scene) {
    constexpr int order = 20;
    const auto name = std::make_shared<const Source>(Source{"--method", "gauss:10"});
    return contender(builds, {exact_method({named_method(name)}), order}, scene, Solver::automatic);
}

}  // namespace hvi::gen

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

constexpr double seconds_of_reference = 20;

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
EventfulRunWishes EventfulRuns::wishes(double h) const {
    constexpr std::int64_t most = 1'000'000'000;
    const std::int64_t steps = clock_ ? most : std::llround(until_ / h);
    return {.h = h, .steps = steps, .events = events_, .clock = clock_};
}

// NOTE: of scaled time the last step is a shorter one, which counts.
Measurement EventfulRuns::measured(const Contender& contender, double h, double seconds) const {
    EventfulRunWishes all = wishes(h);
    all.seconds = seconds;
    Measurement run = measure(contender.module.target(), all).run;
    if (clock_ && run.ok()) ++run.steps;
    return run;
}

DepartureSamples EventfulRuns::departures(const Contender& contender, double h,
                                          std::int64_t parts) const {
    EventfulRunWishes all = wishes(h);
    all.samples = parts;
    return sample_departures(contender.module.target(), all);
}

Reference EventfulRuns::reference(const Contender& gauss_10, double length,
                                  std::int64_t first_count) const {
    if (const WrittenOutScene in_time = unrolled(scene_); has_exact_states(in_time))
        return {"exact", 0, exact_state(in_time, until_)};
    using Clock = std::chrono::steady_clock;
    constexpr std::int64_t most_steps = 100'000'000;
    const Clock::time_point start = Clock::now();
    Refined ends;
    for (std::int64_t count = std::max<std::int64_t>(1, first_count / 16); count < most_steps;
         count *= 2) {
        const Clock::time_point before = Clock::now();
        const Measurement run = measured(gauss_10, length / static_cast<double>(count), 0);
        if (run.ok() && !ends.add(std::get<EndOfRun>(run.end).state)) break;
        const Clock::time_point now = Clock::now();
        const std::chrono::duration<double> taken = now - start, last = now - before;
        if (taken.count() + 2 * last.count() > seconds_of_reference) break;
    }
    if (ends.state().empty())
        throw MathError("there is no reference solution: " + gauss_10.title +
                            " does not come to the end",
                        {}, "give the scene an [exact] solution, or another end by `until`");
    return {gauss_10.title + " in 53 bits", ends.error(), ends.state()};
}

Contender eventful_reference_contender(Builds& builds, const LoweredScene& scene) {
    constexpr int order = 20;
    const auto name = std::make_shared<const Source>(Source{"--method", "gauss:10"});
    return contender(builds, {exact_method({named_method(name)}), order}, scene, Solver::automatic);
}

}  // namespace hvi::gen

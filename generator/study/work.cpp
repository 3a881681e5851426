// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/study/work.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>

#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t points_of_curve = 8;

/// NOTE: so many steps of the double h end a little beside the time that the reference is of,
/// which would show where the rest is small.
double error_of(const Course& course, const EndOfRun& run, std::int64_t steps) {
    const auto count = static_cast<double>(steps);
    const double late = std::fma(count, course.until / count, -course.until);
    double sum = 0, size = 0;
    for (std::size_t k = 0; k < run.state.size(); ++k) {
        const double there = course.reference.state[k];
        const double moved = run.velocity.empty() ? 0 : late * run.velocity[k];
        const double difference = run.state[k] - there - moved;
        sum += difference * difference;
        size += there * there;
    }
    return std::sqrt(size > 0 ? sum / size : sum);
}

/// Runs of one method, each looked at once.
class Runs {
public:
    Runs(const Course& course, const MeasureSteps& measure) : course_(course), measure_(measure) {}

    /// Without timing.
    const WorkPoint& with(std::int64_t count) {
        const auto known = points_.find(count);
        if (known != points_.end()) return known->second;
        const auto start = std::chrono::steady_clock::now();
        const WorkPoint& point =
            points_.emplace(count, work_point(course_, measure_, count, 0)).first->second;
        last_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return point;
    }

    [[nodiscard]] WorkPoint timed(std::int64_t count) const {
        return work_point(course_, measure_, count, seconds_of_timing);
    }

    /// How long the last run took that had to be made.
    [[nodiscard]] double seconds_of_last() const { return last_; }

private:
    const Course& course_;
    const MeasureSteps& measure_;
    std::map<std::int64_t, WorkPoint> points_;
    double last_ = 0;
};

/// From how many steps to how many the error goes from 1e-2 to where more of them do not help.
struct Range {
    std::int64_t least, most;
};

constexpr double coarse = 1e-2, fine = 1e-8;

/// The fewest steps that end about as near as `most` of them do, where that is at round-off.
///
/// NOTE: of gauss:12 twice as many steps go from 1e-4 to round-off: of the points of a curve over a
/// range that was doubled more than half measured rounding.
std::int64_t fewest_to_round_off(Runs& runs, std::int64_t most) {
    constexpr double about = 8;
    constexpr int halvings = 3;
    const double least_error = runs.with(most).error;
    if (!(least_error < fine)) return most;
    const auto is_enough = [&](std::int64_t count) {
        const WorkPoint& point = runs.with(count);
        return point.ok() && point.error <= about * least_error;
    };
    std::int64_t good = most;
    while (good > 1 && is_enough(good / 2)) good /= 2;
    std::int64_t too_few = good / 2;
    for (int i = 0; i < halvings && good - too_few > 1; ++i) {
        const std::int64_t between =
            std::llround(std::sqrt(static_cast<double>(too_few) * static_cast<double>(good)));
        (is_enough(between) ? good : too_few) = between;
    }
    return good;
}

Range useful_range(Runs& runs, std::int64_t first, double longest) {
    constexpr std::int64_t most_steps = 100'000'000;
    const auto is_good = [&](std::int64_t count) {
        const WorkPoint& point = runs.with(count);
        return point.ok() && point.error < coarse;
    };
    Range range{first, first};
    while (!is_good(range.most) && range.most < most_steps && runs.seconds_of_last() < longest)
        range.most *= 2;
    range.least = range.most;
    while (range.least > 1 && is_good(range.least)) range.least /= 2;
    while (2 * range.most < most_steps && runs.seconds_of_last() < longest) {
        const double before = runs.with(range.most).error;
        const double after = runs.with(2 * range.most).error;
        range.most *= 2;
        if (before < fine && !(after < before / 2)) break;
    }
    range.most = std::max(range.least, fewest_to_round_off(runs, range.most));
    return range;
}

std::vector<std::int64_t> spread_out(const Range& range) {
    std::vector<std::int64_t> counts;
    const double ratio = static_cast<double>(range.most) / static_cast<double>(range.least);
    for (std::size_t i = 0; i < points_of_curve; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(points_of_curve - 1);
        counts.push_back(std::llround(static_cast<double>(range.least) * std::pow(ratio, part)));
    }
    counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
    return counts;
}

std::int64_t count_of(double h, double until) {
    return std::max<std::int64_t>(1, std::llround(std::abs(until / h)));
}

std::vector<std::int64_t> counts_of(const std::vector<double>& steps, double until) {
    std::vector<std::int64_t> counts;
    for (const double h : steps) counts.push_back(count_of(h, until));
    std::sort(counts.begin(), counts.end());
    counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
    return counts;
}

}  // namespace

double Course::size_of(std::int64_t count) const {
    if (variable == StepVariable::scaled_time)
        for (const double h : steps)
            if (count_of(h, until) == count) return h;
    return until / static_cast<double>(count);
}

WorkPoint work_point(const Course& course, const Measurement& run) {
    const auto* end = std::get_if<EndOfRun>(&run.end);
    if ((run.ok() && end != nullptr && end->state.size() != course.reference.state.size()) ||
        (course.keeps_energy && run.departures.empty()))
        throw EnvironmentError("a compiled program does not answer as it should: it says too few "
                               "numbers, or too many");
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    const auto steps = static_cast<double>(run.steps);
    WorkPoint point;
    point.h = run.steps > 0 ? course.until / steps : 0;
    point.steps = run.steps;
    point.status = run.status;
    point.error = !run.ok()        ? nothing
                  : end != nullptr ? error_of(course, *end, run.steps)
                                   : std::get<DistanceOfEnd>(run.end).relative;
    point.energy_error = course.keeps_energy ? run.departures.at(0) : nothing;
    point.drift = course.keeps_energy && !run.drifts.empty() ? run.drifts.front() : nothing;
    point.seconds = run.seconds;
    point.spread = run.spread;
    point.evaluations = run.evaluations;
    if (run.steps > 0) point.iterations = static_cast<double>(run.iterations) / steps;
    return point;
}

// NOTE: also where it stopped early, h is the one that was wished for.
WorkPoint work_point(const Course& course, const MeasureSteps& measure, std::int64_t count,
                     double seconds) {
    WorkPoint point = work_point(course, measure(count, seconds));
    point.h = course.size_of(count);
    if (course.variable == StepVariable::time) point.steps = count;
    return point;
}

std::vector<WorkPoint> work_points(const Course& course, const MeasureSteps& measure) {
    Runs runs(course, measure);
    std::vector<WorkPoint> points;
    for (const std::int64_t count :
         course.steps.empty()
             ? spread_out(useful_range(runs, course.first_count, course.longest_run))
             : counts_of(course.steps, course.until))
        points.push_back(runs.timed(count));
    return points;
}

void time_again(std::vector<WorkPoint>& points, const MeasureAgain& measure) {
    for (WorkPoint& point : points) {
        if (!point.ok() || point.seconds == 0 || point.seconds > seconds_of_timing) continue;
        const Measurement run = measure(point, seconds_of_timing);
        if (run.seconds == 0 || run.seconds >= point.seconds) continue;
        point.seconds = run.seconds;
        point.spread = run.spread;
    }
}

}  // namespace hvi::gen

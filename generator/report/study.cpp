// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/report/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include "generator/exact/functions/start.hpp"
#include "generator/exact/methods/order.hpp"
#include "generator/simulate/simulation.hpp"
#include "generator/support/bar.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

namespace fs = std::filesystem;

constexpr int highest_order = 16;          // that is looked for
constexpr double seconds_of_timing = 0.1;  // of each point
constexpr std::size_t points_of_curve = 8;
constexpr const char* reference_method = "gauss:10";

/// A method on the scene, ready to run.
struct Contender {
    SceneStepper stepper;
    int order;
    fs::path program;
};

/// Runs of one method, each looked at once.
class Runs {
public:
    Runs(const Contender& contender, const Reference& reference, double until)
        : contender_(contender), reference_(reference), until_(until) {}

    /// Without timing.
    const WorkPoint& with(std::int64_t count) {
        const auto known = points_.find(count);
        if (known != points_.end()) return known->second;
        const auto start = std::chrono::steady_clock::now();
        const WorkPoint& point = points_.emplace(count, point_of(count, 0)).first->second;
        last_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return point;
    }

    [[nodiscard]] WorkPoint timed(std::int64_t count) const {
        return point_of(count, seconds_of_timing);
    }

    /// How long the last run took that had to be made.
    [[nodiscard]] double seconds_of_last() const { return last_; }

private:
    [[nodiscard]] WorkPoint point_of(std::int64_t count, double seconds) const {
        const Steps steps{until_ / static_cast<double>(count), count};
        const Measurement run = measure(contender_.program, steps, seconds);
        WorkPoint point;
        point.h = steps.size;
        point.steps = count;
        point.status = run.status;
        point.error = run.ok() ? error_of(run, steps) : std::numeric_limits<double>::quiet_NaN();
        const bool has_energy = !contender_.stepper.lowered.system.time.has_value();
        point.energy_error =
            has_energy ? run.departures.at(0) : std::numeric_limits<double>::quiet_NaN();
        point.seconds = run.seconds;
        point.spread = run.spread;
        point.evaluations = run.evaluations;
        if (run.steps > 0)
            point.iterations = static_cast<double>(run.iterations) / static_cast<double>(run.steps);
        return point;
    }

    /// NOTE: so many steps of the double h end a little beside the time that the reference is of,
    /// which would show where the rest is small.
    [[nodiscard]] double error_of(const Measurement& run, const Steps& steps) const {
        const double late = std::fma(static_cast<double>(steps.count), steps.size, -until_);
        double sum = 0, size = 0;
        for (std::size_t k = 0; k < run.end.size(); ++k) {
            const double there = reference_.state[k];
            const double difference = run.end[k] - there - late * run.velocity[k];
            sum += difference * difference;
            size += there * there;
        }
        return std::sqrt(size > 0 ? sum / size : sum);
    }

    const Contender& contender_;
    const Reference& reference_;
    double until_;
    std::map<std::int64_t, WorkPoint> points_;
    double last_ = 0;
};

/// From how many steps to how many the error goes from 1e-2 to where more of them do not help.
struct Range {
    std::int64_t least, most;
};

Range useful_range(Runs& runs, std::int64_t first) {
    constexpr double coarse = 1e-2, fine = 1e-8, longest = 0.5;
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

std::vector<std::int64_t> counts_of(const std::vector<double>& steps, double until) {
    std::vector<std::int64_t> counts;
    for (const double h : steps)
        counts.push_back(std::max<std::int64_t>(1, std::llround(std::abs(until / h))));
    std::sort(counts.begin(), counts.end());
    counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
    return counts;
}

/// Over a run whose error is about that of many applications.
Departures departures(const Contender& contender, const std::vector<WorkPoint>& points,
                      double until) {
    constexpr double typical = 1e-6;
    constexpr std::int64_t samples = 500;
    const auto distance = [&](const WorkPoint& point) {
        return point.ok() ? std::abs(std::log(point.error / typical))
                          : std::numeric_limits<double>::infinity();
    };
    const auto nearest =
        std::min_element(points.begin(), points.end(), [&](const auto& left, const auto& right) {
            return distance(left) < distance(right);
        });
    if (nearest == points.end() || !nearest->ok()) return {};
    const Steps steps{until / static_cast<double>(nearest->steps), nearest->steps};
    const DepartureSamples found = sample_departures(contender.program, steps, samples);
    Departures result{steps.size, found.times, {}, {}};
    const std::size_t first = contender.stepper.lowered.system.time ? 0 : 1;
    for (const std::vector<double>& each : found.departures) {
        if (first == 1) result.energy.push_back(each.front());
        if (each.size() == first) continue;
        double sum = 0;
        for (std::size_t i = first; i < each.size(); ++i) sum += each[i] * each[i];
        result.invariants.push_back(std::sqrt(sum));
    }
    return result;
}

Contender contender(const Compiler& compiler, const Method& method, const Scene& scene) {
    SceneStepper stepper = scene_stepper(method, scene, simulation_wishes(Solver::automatic));
    check_simulation(stepper);
    const int order = orders(stepper.tableau, highest_order).general.order;
    fs::path program = built_program(compiler, simulation_program(stepper));
    return {std::move(stepper), order, std::move(program)};
}

Reference reference(const Compiler& compiler, const Scene& scene, double until,
                    std::int64_t count) {
    constexpr double wanted = 1e-18, seconds = 20;
    // Of so high an order, larger steps than the scene's may do.
    const std::int64_t begin = std::max<std::int64_t>(1, count / 16);
    if (!scene.exact.empty()) return {"exact", 0, exact_state(scene, until)};
    const auto name = std::make_shared<const Source>(Source{"--method", reference_method});
    const SceneStepper stepper =
        scene_stepper(named_method(name), scene, {.solver = Solver::fixed_point, .float128 = true});
    const fs::path program = built_program(compiler, reference_program(stepper));
    const ReferenceSolution found = find_reference(program, until, begin, wanted, seconds);
    if (found.state.empty())
        throw MathError(
            fmt::format("there is no reference solution: {} in {} bits does not come to "
                        "the end",
                        reference_method, found.bits),
            {}, "give the scene an [exact] solution, or another end by `until`");
    return {fmt::format("{} in {} bits", reference_method, found.bits), found.error, found.state};
}

}  // namespace

SceneReport study(const Compiler& compiler, const Scene& scene, double until,
                  std::int64_t first_count, const StudyWishes& wishes) {
    SceneReport report{scene.name, scene.description, until, {}, {}};
    Bar bar;
    const double parts = 2 * static_cast<double>(wishes.methods.size()) + 1;
    double done = 0;
    bar.show(0, scene.name + ": reference");
    report.reference = reference(compiler, scene, until, first_count);
    for (const Method& method : wishes.methods) {
        bar.show(++done / parts, fmt::format("{}: compiling {}", scene.name, method.name));
        const Contender fighter = contender(compiler, method, scene);
        bar.show(++done / parts, fmt::format("{}: running {}", scene.name, method.name));
        Runs runs(fighter, report.reference, until);
        WorkCurve curve{fighter.stepper.tableau.name, fighter.order, false, {}, {}};
        for (const std::int64_t count : wishes.steps.empty()
                                            ? spread_out(useful_range(runs, first_count))
                                            : counts_of(wishes.steps, until))
            curve.points.push_back(runs.timed(count));
        curve.departures = departures(fighter, curve.points, until);
        report.curves.push_back(std::move(curve));
    }
    return report;
}

}  // namespace hvi::gen

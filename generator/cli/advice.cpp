// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "generator/cli/method.hpp"
#include "generator/cli/run_wishes.hpp"
#include "generator/study/advice.hpp"
#include "generator/study/path_to_accuracy.hpp"

namespace hvi::gen {

namespace {

/// NOTE: a scene is read together with a method, whose symbols its own must not be; gauss:2 has no
/// symbols.
Scene scene_of(const AccuracyQuestion& question) {
    MethodOptions any;
    any.name = given("--method", "gauss:2");
    any.parameters = question.parameters;
    return read_scene(any, question.system).scene;
}

/// NOTE: counted sweeps are marked, as their steps are symplectic up to the last change alone.
std::string solver_of(const Candidate& candidate) {
    if (candidate.sweeps > 0) return "explicit";
    return candidate.solver == Solver::fixed_point ? "fixed-point" : "auto";
}

/// Returns why there is no run at the accuracy: either no step count would reach it, or smaller
/// steps would not be faster.
std::string why_not(const WorkCurve& curve, double accuracy, double seconds) {
    if (!next_count(curve, accuracy)) return "does not get there";
    const double predicted = predicted_seconds(curve, accuracy);
    if (!(seconds > 0) || !std::isfinite(predicted)) return "not followed for longer";
    return fmt::format("dropped: {:.0f} times or so", predicted / seconds);
}

std::string row(const WorkCurve& curve, const Candidate& candidate, double accuracy,
                double seconds) {
    const auto there = cheapest(curve, accuracy);
    WorkPoint point = there.value_or(curve.points.back());
    const std::string remark = there ? fmt::format("{:.2f} times", point.seconds / seconds)
                                     : why_not(curve, accuracy, seconds);
    return fmt::format("  {:<29} {:<12} {:<10.4g} {:>9} {:>8.1e} {:>9}  {}\n", curve.name,
                       solver_of(candidate), point.h, point.steps, point.error,
                       point.seconds > 0 ? duration(point.seconds) : "", remark);
}

/// Lists the methods by rising time.
std::string table(const Advice& advice, double accuracy) {
    std::string rows = fmt::format("  {:<29} {:<12} {:<10} {:>9} {:>8} {:>9}\n", "method", "solver",
                                   "h", "steps", "error", "time");
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < advice.curves.size(); ++i)
        if (!advice.curves[i].points.empty()) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        const auto a = cheapest(advice.curves[i], accuracy),
                   b = cheapest(advice.curves[j], accuracy);
        return a && (!b || a->seconds < b->seconds);
    });
    for (const std::size_t i : order)
        rows += row(advice.curves[i], advice.candidates[i], accuracy, advice.point.seconds);
    return rows;
}

/// Lists the costs of sweeps by the model beside the measured times of steps. If the model is
/// right, their quotient is constant.
std::string model_table(const Advice& advice, double accuracy) {
    std::string rows =
        fmt::format("  {:<29} {:>16} {:>14} {:>10} {:>17}\n", "method", "iterations/step",
                    "operations/it.", "time/step", "time/operation");
    for (std::size_t i = 0; i < advice.curves.size(); ++i) {
        const auto there = cheapest(advice.curves[i], accuracy);
        if (!there || !advice.costs[i]) continue;
        const double step = there->seconds / static_cast<double>(there->steps);
        const int sweep = advice.costs[i]->sweep;
        rows += fmt::format("  {:<29} {:>16.1f} {:>14} {:>10} {:>17}\n", advice.curves[i].name,
                            there->iterations, sweep, duration(step),
                            duration(step / (there->iterations * sweep)));
    }
    return "costs by the model, of sweeps, and as measured:\n" + rows;
}

/// Writes a factor of a quotient: `200`, or `(2*pi)`.
std::string factor(const Expression& expression) {
    const std::string text = to_text(expression);
    return text.find_first_of("+-*/") == std::string::npos ? text : "(" + text + ")";
}

}  // namespace

AdvisedOptions advised(const AccuracyQuestion& question) {
    constexpr std::int64_t steps_of_unsaid_size = 100;
    const Scene scene = scene_of(question);
    const SceneTimes times = times_of(scene);
    const NamedExpression until = wish(times, question.until, times.until, "until");
    const std::int64_t count =
        times.step ? steps_until(times, *times.step, until).count : steps_of_unsaid_size;
    const double end = nearest_value(times, until), accuracy = question.accuracy;

    Builds builds(find_compiler());
    const AdviceWishes wishes{accuracy,
                              end,
                              std::max<std::int64_t>(1, count),
                              question.has_curve,
                              question.has_action,
                              question.seconds,
                              question.system.sums};
    const Advice found = advice(builds, scene, wishes);
    const Candidate& chosen = found.candidates[found.chosen];
    const std::string step =
        scene.scale ? fmt::format("{}", found.point.h)
                    : fmt::format("{}/{}", factor(until.expression), found.point.steps);
    const std::string size =
        scene.scale ? step + " in scaled time" : fmt::format("{} = {:.6g}", step, found.point.h);
    const std::string note =
        fmt::format("advised for an error of {} at t = {}: steps of {}, with an error of {:.2e}{}",
                    accuracy, end, size, found.point.error,
                    chosen.sweeps > 0 ? "; symplectic up to the last change of a step alone" : "");
    std::fputs(fmt::format("errors of at most {} on {} at t = {}, beside {}{}\n{}", accuracy,
                           scene.name, end, found.reference.kind,
                           found.reference.kind == "exact" ? " values" : "", table(found, accuracy))
                   .c_str(),
               stderr);
    if (question.explain) std::fputs(model_table(found, accuracy).c_str(), stderr);
    const std::string shortfall =
        found.is_reached
            ? ""
            : fmt::format(
                  "an error of {} at t = {} is not reached in {:.3g} s: the best so far is {} "
                  "in steps of {}, with an error of about {:.1e}",
                  accuracy, end, question.seconds, found.curves[found.chosen].name, step,
                  found.point.error);
    return {chosen.method.method.name,
            chosen.solver,
            chosen.sweeps,
            chosen.method.composition,
            {found.point.h, found.point.steps},
            end,
            step,
            note,
            shortfall};
}

}  // namespace hvi::gen

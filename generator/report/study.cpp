// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/report/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <utility>

#include "generator/exact/functions/start.hpp"
#include "generator/exact/methods/order.hpp"
#include "generator/report/peers.hpp"
#include "generator/report/work.hpp"
#include "generator/simulate/simulation.hpp"
#include "generator/support/bar.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

namespace fs = std::filesystem;

constexpr int highest_order = 16;  // that is looked for
constexpr const char* reference_method = "gauss:10";

/// A method on the scene, ready to run.
struct Contender {
    SceneStepper stepper;
    int order;
    fs::path program;
};

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
    const double parts = 2 * static_cast<double>(wishes.methods.size()) + 1 +
                         static_cast<double>(wishes.libraries.size());
    double done = 0;
    bar.show(0, scene.name + ": reference");
    report.reference = reference(compiler, scene, until, first_count);
    const Course course{report.reference, until, first_count, wishes.steps,
                        !lowered(scene).system.time.has_value()};
    for (const Method& method : wishes.methods) {
        bar.show(++done / parts, fmt::format("{}: compiling {}", scene.name, method.name));
        const Contender fighter = contender(compiler, method, scene);
        bar.show(++done / parts, fmt::format("{}: running {}", scene.name, method.name));
        WorkCurve curve{fighter.stepper.tableau.name, fighter.order, false, {}, {}};
        curve.points = work_points(course, [&](std::int64_t count, double seconds) {
            return measure(fighter.program, {until / static_cast<double>(count), count}, seconds);
        });
        curve.departures = departures(fighter, curve.points, until);
        report.curves.push_back(std::move(curve));
    }
    for (const PeerLibrary& library : wishes.libraries) {
        bar.show(++done / parts, fmt::format("{}: {}", scene.name, library.name));
        for (WorkCurve& curve : peer_curves(compiler, library, scene, course))
            report.curves.push_back(std::move(curve));
    }
    return report;
}

}  // namespace hvi::gen

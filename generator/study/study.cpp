// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/study/study.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <utility>

#include "generator/exact/functions/start.hpp"
#include "generator/exact/methods/order.hpp"
#include "generator/simulate/simulation.hpp"
#include "generator/study/departures.hpp"
#include "generator/study/peers.hpp"
#include "generator/study/work.hpp"
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
    Build build;
};

/// Integrators of a library.
struct Team {
    const PeerLibrary& library;
    Build build;
};

Contender contender(Builds& builds, const Method& method, const Scene& scene) {
    SceneStepper stepper = scene_stepper(method, scene, simulation_wishes(Solver::automatic));
    check_simulation(stepper);
    const int order = orders(stepper.tableau, highest_order).general.order;
    Build build = builds.order(simulation_program(stepper));
    return {std::move(stepper), order, std::move(build)};
}

/// The program of a reference solution, where the scene has none that is exact.
Build reference_build(Builds& builds, const Scene& scene) {
    if (!scene.exact.empty()) return {};
    const auto name = std::make_shared<const Source>(Source{"--method", reference_method});
    return builds.order(reference_program(scene_stepper(
        named_method(name), scene, {.solver = Solver::fixed_point, .float128 = true})));
}

Reference reference(const Build& build, const Scene& scene, double until, std::int64_t count) {
    constexpr double wanted = 1e-18, seconds = 30;
    // Of so high an order, larger steps than the scene's may do.
    const std::int64_t begin = std::max<std::int64_t>(1, count / 16);
    if (!scene.exact.empty()) return {"exact", 0, exact_state(scene, until)};
    const ReferenceSolution found = find_reference(built(build), until, begin, wanted, seconds);
    if (found.state.empty())
        throw MathError(
            fmt::format("there is no reference solution: {} in {} bits does not come to "
                        "the end",
                        reference_method, found.bits),
            {}, "give the scene an [exact] solution, or another end by `until`");
    return {fmt::format("{} in {} bits", reference_method, found.bits), found.error, found.state};
}

/// Everything that is to be compiled. NOTE: all of it is, before anything is timed.
struct Programs {
    Build reference;
    std::vector<Contender> contenders;
    std::optional<SceneStepper> for_peers;
    std::vector<Team> teams;

    void wait() const {
        if (reference.valid()) static_cast<void>(built(reference));
        for (const Contender& contender : contenders) static_cast<void>(built(contender.build));
        for (const Team& team : teams) static_cast<void>(built(team.build));
    }
};

Programs programs(Builds& builds, const Scene& scene, const StudyWishes& wishes) {
    Programs all{reference_build(builds, scene), {}, {}, {}};
    for (const Method& method : wishes.methods)
        all.contenders.push_back(contender(builds, method, scene));
    if (!wishes.libraries.empty()) all.for_peers = stepper_for_peers(scene);
    for (const PeerLibrary& library : wishes.libraries)
        all.teams.push_back(
            {library, builds.order(driver_program(*all.for_peers, library.driver))});
    return all;
}

WorkCurve curve(const Contender& contender, const Course& course) {
    WorkCurve curve{contender.stepper.tableau.name, contender.order, false, {}, {}};
    curve.points = work_points(course, [&](std::int64_t count, double seconds) {
        return measure(built(contender.build), {course.until / static_cast<double>(count), count},
                       seconds);
    });
    curve.departures = departures(course, curve.points, [&](const WorkPoint& point) {
        const Steps steps{course.until / static_cast<double>(point.steps), point.steps};
        return sample_departures(built(contender.build), steps, departure_parts);
    });
    return curve;
}

}  // namespace

void study(Builds& builds, const Scene& scene, double until, std::int64_t first_count,
           const StudyWishes& wishes, SceneReport& report, TimeSpent& time_spent) {
    report = {scene.name, scene.description, until, {}, {}};
    Bar bar;
    const auto parts = static_cast<double>(wishes.methods.size() + wishes.libraries.size() + 2);
    double done = 0;
    const auto begin = [&](const std::string& what) {
        bar.show(done++ / parts, scene.name + ": " + what);
        return TimeSpent::Part(time_spent, what);
    };
    const Programs all = [&] {
        const auto part = begin("deriving and writing steppers");
        return programs(builds, scene, wishes);
    }();
    {
        const auto part = begin("compiling");
        all.wait();
    }
    {
        const auto part = begin("reference");
        report.reference = reference(all.reference, scene, until, first_count);
    }
    const Course course{report.reference, until, first_count, wishes.steps,
                        !lowered(scene).system.time.has_value()};
    for (const Contender& contender : all.contenders) {
        const auto part = begin("running " + contender.stepper.tableau.name);
        report.curves.push_back(curve(contender, course));
    }
    for (const Team& team : all.teams) {
        const auto part = begin("running " + team.library.name);
        for (WorkCurve& curve :
             peer_curves(built(team.build), team.library, *all.for_peers, course))
            report.curves.push_back(std::move(curve));
    }
}

}  // namespace hvi::gen

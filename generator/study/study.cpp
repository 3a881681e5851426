// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/study/study.hpp"

#include "generator/simulate/simulation.hpp"
#include "generator/study/contender.hpp"
#include "generator/study/departures.hpp"
#include "generator/study/peers.hpp"
#include "generator/study/work.hpp"
#include "generator/support/bar.hpp"

namespace hvi::gen {

namespace {

constexpr int more_rounds = 2;  // of timing, after all has been run

/// Integrators of a library.
struct Team {
    const PeerLibrary& library;
    Build build;
};

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
    for (const ComposedMethod& method : wishes.methods)
        all.contenders.push_back(contender(builds, method, scene, Solver::automatic));
    if (!wishes.libraries.empty()) all.for_peers = stepper_for_peers(scene);
    for (const PeerLibrary& library : wishes.libraries)
        all.teams.push_back(
            {library, builds.order(driver_program(*all.for_peers, library.driver))});
    return all;
}

WorkCurve curve(const Contender& contender, const Course& course) {
    WorkCurve curve{contender.stepper.method.title(), contender.order, false, {}, {}};
    curve.points = work_points(course, measured(contender, course.until));
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
    const auto parts =
        static_cast<double>(wishes.methods.size() + wishes.libraries.size() + 2 + more_rounds);
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
        report.reference = reference(all.reference, scene, until, first_count, 1e-18);
    }
    const Course course{report.reference, until, first_count, wishes.steps,
                        !system_of(scene).time.has_value()};
    std::vector<MeasureAgain> again;  // of each curve
    for (const Contender& contender : all.contenders) {
        const auto part = begin("running " + contender.stepper.method.title());
        report.curves.push_back(curve(contender, course));
        again.push_back(
            [measure = measured(contender, until)](const WorkPoint& point, double seconds) {
                return measure(point.steps, seconds);
            });
    }
    for (const Team& team : all.teams) {
        const auto part = begin("running " + team.library.name);
        for (PeerCurve& peer :
             peer_curves(built(team.build), team.library, *all.for_peers, course)) {
            report.curves.push_back(std::move(peer.curve));
            again.push_back(std::move(peer.again));
        }
    }
    for (int round = 0; round < more_rounds; ++round) {
        const auto part = begin("running all once more");
        for (std::size_t i = 0; i < again.size(); ++i)
            time_again(report.curves[i].points, again[i]);
    }
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/study/study.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "generator/simulate/simulation.hpp"
#include "generator/study/departures.hpp"
#include "generator/study/eventful.hpp"
#include "generator/study/large_reference.hpp"
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
        for (const Contender& contender : contenders) contender.module.wait_for_all();
        for (const Team& team : teams) static_cast<void>(built(team.build));
    }
};

Programs programs(Builds& builds, const LoweredScene& scene, const StudyWishes& wishes) {
    Programs all{reference_build(builds, scene), {}, {}, {}};
    all.contenders = contenders(builds, wishes.methods, scene, wishes.sweeps);
    if (!wishes.libraries.empty()) all.for_peers = stepper_for_peers(scene);
    for (const PeerLibrary& library : wishes.libraries)
        all.teams.push_back(
            {library, builds.order(driver_program(*all.for_peers, library.driver))});
    return all;
}

/// Programs for a scene of any size.
struct LargePrograms {
    LargeReference reference;
    std::vector<Contender> all;

    LargePrograms(Builds& builds, const LoweredScene& scene, double until,
                  const StudyWishes& wishes)
        : reference(builds, scene.scene, until),
          all(contenders(builds, wishes.methods, scene, wishes.sweeps)) {}

    void wait() const {
        reference.wait();
        for (const Contender& contender : all) contender.module.wait_for_all();
    }
};

/// Runs of a method on a scene.
struct RunsOfMethod {
    MeasureSteps measure;
    MeasureAgain again;
    SampleDepartures sample;
};

/// Runs of equal steps that lead to the end.
RunsOfMethod equal_steps(const Contender& contender, const Course& course, MeasureSteps measure) {
    return {
        measure,
        [measure](const WorkPoint& point, double seconds) { return measure(point.steps, seconds); },
        [contender, until = course.until](const WorkPoint& point) {
            const Steps steps{until / static_cast<double>(point.steps), point.steps};
            return sample_departures(contender.module.target(), steps, departure_parts);
        }};
}

RunsOfMethod eventful_steps(const Contender& contender, const Course& course,
                            const EventfulRuns& runs) {
    return {[=](std::int64_t count, double seconds) {
                return runs.measured(contender, course.size_of(count), seconds);
            },
            [=](const WorkPoint& point, double seconds) {
                return runs.measured(contender, point.h, seconds);
            },
            [=](const WorkPoint& point) {
                return runs.departures(contender, point.h, departure_parts);
            }};
}

WorkCurve curve(const Contender& contender, const Course& course, const RunsOfMethod& runs) {
    WorkCurve curve{contender.title, contender.order, false, {}, {}, {}, contender.sweeps};
    curve.points = work_points(course, runs.measure);
    curve.departures = departures(course, curve.points, runs.sample);
    return curve;
}

/// Not more steps to begin a search with than a run may have that is not too long.
std::int64_t affordable(const Contender& contender, const Course& course) {
    const auto count = static_cast<double>(course.first_count);
    const Steps steps{course.until / count, std::min<std::int64_t>(course.first_count, 8)};
    const double each = pace(contender.module.target(), steps);
    if (each * count <= course.longest_run) return course.first_count;
    return std::max<std::int64_t>(1, std::llround(course.longest_run / each));
}

/// The study of one scene as it goes on.
class Study {
public:
    Study(SceneReport& report, TimeSpent& time_spent, std::size_t parts)
        : report_(report), time_spent_(time_spent), parts_(static_cast<double>(parts)) {}

    /// Shows what is done, and counts its time while the result lives.
    [[nodiscard]] TimeSpent::Part begin(const std::string& what) {
        bar_.show(done_++ / parts_, report_.name + ": " + what);
        return TimeSpent::Part(time_spent_, what);
    }

    void run(const Contender& contender, const Course& course, const RunsOfMethod& runs) {
        const auto part = begin("running " + contender.title);
        add(curve(contender, course, runs), runs.again);
    }

    void run(const Team& team, const SceneStepper& stepper, const Course& course) {
        const auto part = begin("running " + team.library.name);
        for (PeerCurve& peer : peer_curves(built(team.build), team.library, stepper, course))
            add(std::move(peer.curve), std::move(peer.again));
    }

    void run_again() {
        for (int round = 0; round < more_rounds; ++round) {
            const auto part = begin("running all once more");
            for (std::size_t i = 0; i < again_.size(); ++i)
                time_again(report_.curves[i].points, again_[i]);
        }
    }

private:
    void add(WorkCurve curve, MeasureAgain again) {
        report_.curves.push_back(std::move(curve));
        again_.push_back(std::move(again));
    }

    SceneReport& report_;
    TimeSpent& time_spent_;
    double parts_, done_ = 0;
    std::vector<MeasureAgain> again_;  // of each curve
    Bar bar_;
};

constexpr std::size_t other_parts = 3 + more_rounds;  // than runs of one method, or library

/// Parts of a study, but for libraries; at most so many where sweeps are counted.
std::size_t parts_of(const StudyWishes& wishes) {
    return (wishes.sweeps > 0 ? 2 : 1) * wishes.methods.size() + other_parts;
}

void study_written_out(Builds& builds, const LoweredScene& scene, double until,
                       std::int64_t first_count, const StudyWishes& wishes, SceneReport& report,
                       TimeSpent& time_spent) {
    Study study(report, time_spent, parts_of(wishes) + wishes.libraries.size());
    const Programs all = [&] {
        const auto part = study.begin("deriving and writing steppers");
        return programs(builds, scene, wishes);
    }();
    {
        const auto part = study.begin("compiling");
        all.wait();
    }
    {
        const auto part = study.begin("reference");
        report.reference = reference(all.reference, *scene.written, until, first_count, 1e-18);
    }
    const Course course{report.reference, until, first_count, wishes.steps,
                        !scene.system.time.has_value()};
    for (const Contender& contender : all.contenders)
        study.run(contender, course, equal_steps(contender, course, measured(contender, until)));
    for (const Team& team : all.teams) study.run(team, *all.for_peers, course);
    study.run_again();
}

/// NOTE: of scaled time the length of a run is not known, and does not matter.
void study_eventful(Builds& builds, const LoweredScene& scene, double until,
                    std::int64_t first_count, const StudyWishes& wishes, SceneReport& report,
                    TimeSpent& time_spent) {
    Study study(report, time_spent, parts_of(wishes));
    const EventfulRuns runs(scene, until);
    std::optional<Contender> fine;
    std::vector<Contender> all;
    {
        const auto part = study.begin("deriving and writing steppers");
        fine = eventful_reference_contender(builds, scene);
        all = contenders(builds, wishes.methods, scene, wishes.sweeps);
    }
    {
        const auto part = study.begin("compiling");
        fine->module.wait_for_all();
        for (const Contender& each : all) each.module.wait_for_all();
    }
    {
        const auto part = study.begin("reference");
        report.reference = runs.reference(*fine, until, first_count);
    }
    Course course{report.reference, until, first_count, wishes.steps, !scene.system.time};
    course.variable = runs.variable();
    for (const Contender& contender : all)
        study.run(contender, course, eventful_steps(contender, course, runs));
    study.run_again();
}

void study_with_loops(Builds& builds, const LoweredScene& scene, double until,
                      std::int64_t first_count, const StudyWishes& wishes, SceneReport& report,
                      TimeSpent& time_spent) {
    Study study(report, time_spent, parts_of(wishes));
    const auto all = [&] {
        const auto part = study.begin("deriving and writing steppers");
        return std::make_unique<LargePrograms>(builds, scene, until, wishes);
    }();
    {
        const auto part = study.begin("compiling");
        all->wait();
    }
    {
        const auto part = study.begin("reference");
        report.reference = all->reference.compute(first_count);
    }
    for (const Contender& contender : all->all) {
        Course course{report.reference, until, first_count, wishes.steps};
        course.longest_run = longest_of_large_search;
        course.first_count = affordable(contender, course);
        study.run(contender, course,
                  equal_steps(contender, course, all->reference.measured(contender)));
    }
    study.run_again();
}

}  // namespace

void study(Builds& builds, const Scene& scene, double until, std::int64_t first_count,
           const StudyWishes& wishes, SceneReport& report, TimeSpent& time_spent) {
    report = {scene.name, scene.description, until, {}, {}};
    const LoweredScene system = lowered(scene, wishes.sums);
    const auto& of_form = is_eventful(scene) ? study_eventful
                          : system.written   ? study_written_out
                                             : study_with_loops;
    of_form(builds, system, until, first_count, wishes, report, time_spent);
}

}  // namespace hvi::gen

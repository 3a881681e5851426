// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/study/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

#include "generator/lower/system.hpp"
#include "generator/study/contender.hpp"
#include "generator/study/path_to_accuracy.hpp"
#include "generator/support/bar.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

// NOTE: of the other compositions none was the fastest on any of the scenes that come with the
// program: yoshida:8 takes twice as long as kahan-li:8 or blanes-moan:6, or more.
constexpr const char* explicit_methods[] = {"stormer-verlet", "stormer-verlet-yoshida:4",
                                            "stormer-verlet-blanes-moan:6",
                                            "stormer-verlet-kahan-li:8"};
// Stages fill registers: of 9 to 12 as many lanes are computed as of 16 where registers hold 8.
constexpr const char* implicit_methods[] = {"gauss:2", "gauss:3", "gauss:4",
                                            "gauss:6", "gauss:8", "gauss:16"};

ComposedMethod named(const char* name) { return composed_method(given("--accuracy", name)); }

/// Those that solve nothing first, where there are any.
std::vector<Candidate> candidates(const Structure& structure, const AdviceWishes& wishes) {
    std::vector<Candidate> all;
    if (structure.is_separable)
        for (const char* name : explicit_methods)
            if (ComposedMethod method = named(name); !wishes.has_curve || !method.composition)
                all.push_back({std::move(method)});
    for (const char* name : implicit_methods) all.push_back({named(name)});
    return all;
}

/// The runs of the candidates.
class Race {
public:
    Race(Course course, double accuracy, const std::vector<Contender>& contenders)
        : course_(std::move(course)), accuracy_(accuracy) {
        for (const Contender& contender : contenders) {
            curves_.push_back({contender.title, contender.order, false, {}, {}});
            measures_.push_back(measured(contender, course_.until));
        }
    }

    /// From the step of the scene on, until the error is that of an order.
    void begin(std::size_t i) {
        run(i, course_.first_count, seconds_of_look);
        while (!std::isfinite(predicted_seconds(curves_[i], accuracy_))) {
            const auto next = next_count(curves_[i], accuracy_);
            if (!next) return;
            run(i, *next, seconds_of_look);
        }
    }

    /// To the accuracy, or as long as there is hope to be the fastest.
    void finish(std::size_t i) {
        while (const auto next = next_count(curves_[i], accuracy_)) {
            if (has_no_hope(i)) return;
            run(i, *next, seconds_of_look);
        }
    }

    /// By rising time that they will take.
    [[nodiscard]] std::vector<std::size_t> by_prediction() const {
        std::vector<std::size_t> order(curves_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto seconds = [&](std::size_t i) {
            return predicted_seconds(curves_[i], accuracy_);
        };
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t i, std::size_t j) { return seconds(i) < seconds(j); });
        return order;
    }

    /// What may be the fastest runs again, for longer, and in turn: so a disturbance meets all.
    void time_the_best() {
        constexpr double near = 2;
        constexpr int rounds = 4;
        constexpr double seconds = seconds_of_timing / 2;  // of each
        const double most = near * seconds_of_best();
        for (int round = 0; round < rounds; ++round)
            for (std::size_t i = 0; i < curves_.size(); ++i)
                for (const WorkPoint& point : std::vector<WorkPoint>(curves_[i].points))
                    if (point.ok() && point.error <= accuracy_ && point.seconds < most)
                        run(i, point.steps, seconds);
    }

    [[nodiscard]] const std::vector<WorkCurve>& curves() const { return curves_; }

private:
    static constexpr double seconds_of_look = 1e-6;  // three repetitions
    static constexpr double seconds_of_second_look = 0.01;
    static constexpr double patience = 10, least_patience = 0.1;  // see seconds_of_best()

    /// NOTE: three repetitions may all have been disturbed, so it is timed once more before.
    bool has_no_hope(std::size_t i) {
        if (!is_hopeless(curves_[i], accuracy_, seconds_of_best())) return false;
        run(i, curves_[i].points.back().steps, seconds_of_second_look);
        return is_hopeless(curves_[i], accuracy_, seconds_of_best());
    }

    void run(std::size_t i, std::int64_t count, double seconds) {
        add_point(curves_[i], work_point(course_, measures_[i], count, seconds));
    }

    /// Where none gets there yet, so much longer than one may take as is worth while to wait.
    [[nodiscard]] double seconds_of_best() const {
        if (const auto best = fastest(curves_, accuracy_))
            return cheapest(curves_[*best], accuracy_)->seconds;
        double least = std::numeric_limits<double>::infinity();
        for (const WorkCurve& curve : curves_)
            least = std::min(least, predicted_seconds(curve, accuracy_));
        return std::max(least_patience, patience * least);
    }

    Course course_;
    double accuracy_;
    std::vector<WorkCurve> curves_;
    std::vector<MeasureSteps> measures_;
};

/// The run with the smallest error, of all.
MathError out_of_reach(const Scene& scene, const std::vector<WorkCurve>& curves, double accuracy) {
    const WorkPoint* best = nullptr;
    const WorkCurve* by = nullptr;
    for (const WorkCurve& curve : curves)
        for (const WorkPoint& point : curve.points)
            if (point.ok() && (best == nullptr || point.error < best->error)) {
                best = &point;
                by = &curve;
            }
    const std::string what =
        fmt::format("no method takes {} to its end with an error of {}", scene.name, accuracy);
    if (best == nullptr) return MathError(what, {}, "none comes to the end at all");
    return MathError(
        what, {},
        fmt::format("the best is {:.2e}, by {} in {} steps", best->error, by->name, best->steps));
}

/// Of which double is enough to be known to a hundredth of it.
constexpr double coarsest_of_quadruple = 1e-9;
constexpr double part_of_accuracy = 1e-2;

/// By a method of high order, whose steps are halved until the end moves little.
Reference reference_in_double(const Contender& contender, const AdviceWishes& wishes) {
    constexpr int most_halvings = 12;
    const MeasureSteps measure = measured(contender, wishes.until);
    Course course{{contender.title + " in 53 bits", std::numeric_limits<double>::infinity(), {}},
                  wishes.until,
                  wishes.first_count,
                  {},
                  false};
    Reference& found = course.reference;
    std::int64_t count = wishes.first_count;
    for (int i = 0; i <= most_halvings; ++i, count *= 2) {
        const Measurement run = measure(count, 0);
        if (!run.ok()) continue;
        if (!found.state.empty()) found.error = work_point(course, run).error;
        found.state = std::get<EndOfRun>(run.end).state;
        if (found.error <= part_of_accuracy * wishes.accuracy) break;
    }
    return found;
}

/// Throws MathError where it is not known to a hundredth of the accuracy.
Reference good_reference(const Build& quadruple, const Contender& contender, const Scene& scene,
                         const AdviceWishes& wishes) {
    const double wanted = part_of_accuracy * wishes.accuracy;
    const bool is_fine = has_exact_states(scene) || wishes.accuracy < coarsest_of_quadruple;
    Reference found = is_fine
                          ? reference(quadruple, scene, wishes.until, wishes.first_count, wanted)
                          : reference_in_double(contender, wishes);
    if (!std::isfinite(found.error))
        throw MathError(
            fmt::format("there is no reference solution of {} in half a minute", scene.name), {},
            "ask for less, or for an earlier end by --until");
    if (!(found.error <= wanted))
        throw MathError(fmt::format("the motion of {} is known with an error of {:.1e} only",
                                    scene.name, found.error),
                        {}, "ask for less, or for an earlier end by --until");
    return found;
}

}  // namespace

Advice advice(Builds& builds, const Scene& scene, const AdviceWishes& wishes) {
    const System system = system_of(scene);
    Advice result;
    result.candidates = candidates(system.structure, wishes);
    const auto parts = static_cast<double>(2 * result.candidates.size() + 2);
    double done = 0;
    Bar bar;
    const auto show = [&](const std::string& what) {
        bar.show(done++ / parts, scene.name + ": " + what);
    };
    show("deriving and writing steppers");
    const Build quadruple =
        wishes.accuracy < coarsest_of_quadruple ? reference_build(builds, scene) : Build();
    std::vector<Contender> contenders;
    for (const Candidate& candidate : result.candidates)
        contenders.push_back(contender(builds, candidate.method, scene, candidate.solver));
    for (const Contender& contender : contenders) {
        result.costs.push_back(contender.costs);
        show("compiling " + contender.title);
        static_cast<void>(built(contender.build));
    }
    show("reference");
    result.reference = good_reference(quadruple, contenders.back(), scene, wishes);
    const Course course{
        result.reference, wishes.until, wishes.first_count, {}, !system.time.has_value()};
    Race race(course, wishes.accuracy, contenders);
    for (std::size_t i = 0; i < contenders.size(); ++i) race.begin(i);
    for (const std::size_t i : race.by_prediction()) {
        show("running " + race.curves()[i].name);
        race.finish(i);
    }
    race.time_the_best();
    result.curves = race.curves();
    const auto chosen = fastest(result.curves, wishes.accuracy);
    if (!chosen) throw out_of_reach(scene, result.curves, wishes.accuracy);
    result.chosen = *chosen;
    result.point = *cheapest(result.curves[*chosen], wishes.accuracy);
    return result;
}

}  // namespace hvi::gen

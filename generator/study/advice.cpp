// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/study/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "generator/lower/system.hpp"
#include "generator/study/eventful.hpp"
#include "generator/study/large_reference.hpp"
#include "generator/study/path_to_accuracy.hpp"
#include "generator/study/raced_splittings.hpp"
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

// NOTE: measured on seven scenes that come with the program. Between these two gauss:6 was never
// the fastest.
constexpr const char* swept_methods[] = {"gauss:4", "gauss:8"};

/// Numbers of sweeps that may do, as each gains one or two digits.
std::vector<int> sweeps_for(double accuracy) {
    if (accuracy >= 1e-5) return {3, 4, 6};
    return accuracy >= 1e-9 ? std::vector{4, 6, 8} : std::vector{6, 8};
}

ComposedMethod named(const char* name) { return composed_method(given("--accuracy", name)); }

/// Candidates; explicit ones first, where there are any.
std::vector<Candidate> candidates(const LoweredScene& scene, const AdviceWishes& wishes) {
    std::vector<Candidate> all;
    if (scene.system.structure.is_separable)
        for (const char* name : explicit_methods)
            if (ComposedMethod method = named(name); !wishes.has_curve || !method.composition)
                all.push_back({studied(exact_method(std::move(method)))});
    if (!wishes.has_curve && !wishes.has_action)
        for (const char* name : raced_splittings(scene))
            all.push_back({studied(exact_method(named(name)))});
    for (const char* name : implicit_methods) all.push_back({studied(exact_method(named(name)))});
    return all;
}

/// The time that runs may take.
class Deadline {
public:
    explicit Deadline(double seconds) : end_(Clock::now() + Seconds(seconds)) {}

    [[nodiscard]] bool has(double seconds) const { return Clock::now() + Seconds(seconds) < end_; }

private:
    using Clock = std::chrono::steady_clock;
    using Seconds = std::chrono::duration<double>;
    std::chrono::time_point<Clock, Seconds> end_;
};

/// Runs of one method, made only where there is time for it by what the last one took.
class PatientRuns {
public:
    PatientRuns(MeasureSteps measure, const Deadline& deadline)
        : measure_(std::move(measure)), deadline_(&deadline) {}

    [[nodiscard]] std::optional<Measurement> operator()(std::int64_t count, double seconds) {
        const auto steps = static_cast<double>(count);
        if (!deadline_->has(seconds_of_step_ * steps)) return {};
        const auto start = std::chrono::steady_clock::now();
        Measurement run = measure_(count, seconds);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        seconds_of_step_ = taken.count() / steps;
        return run;
    }

private:
    MeasureSteps measure_;
    const Deadline* deadline_;
    double seconds_of_step_ = 0;  ///< with repetitions
};

/// The runs of the candidates.
class Race {
public:
    /// `measures`: the runs of the contenders.
    Race(Course course, double accuracy, const std::vector<Contender>& contenders,
         const std::vector<MeasureSteps>& measures, const Deadline& deadline)
        : course_(std::move(course)), accuracy_(accuracy) {
        for (const Contender& contender : contenders)
            curves_.push_back({contender.title, contender.order, false, {}, {}});
        for (const MeasureSteps& measure : measures) measures_.emplace_back(measure, deadline);
    }

    /// From the step of the scene on, until the error is that of an order.
    void begin(std::size_t i) {
        if (!run(i, course_.first_count, seconds_of_look)) return;
        while (!std::isfinite(predicted_seconds(curves_[i], accuracy_))) {
            const auto next = next_count(curves_[i], accuracy_);
            if (!next || !run(i, *next, seconds_of_look)) return;
        }
    }

    /// To the accuracy, or as long as there is hope to be the fastest.
    void finish(std::size_t i) {
        if (curves_[i].points.empty()) return;
        while (const auto next = next_count(curves_[i], accuracy_))
            if (has_no_hope(i) || !run(i, *next, seconds_of_look)) return;
    }

    /// Candidates by the time that they will take, the shortest first.
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

    /// Runs again, for longer and in turn, what may be the fastest: so a disturbance meets all.
    void time_the_best() {
        constexpr double near = 2;
        constexpr int rounds = 4;
        constexpr double seconds = seconds_of_timing / 2;  // of each
        const double most = near * seconds_of_best();
        for (int round = 0; round < rounds; ++round)
            for (std::size_t i = 0; i < curves_.size(); ++i)
                for (const WorkPoint& point : std::vector<WorkPoint>(curves_[i].points))
                    if (point.ok() && point.error <= accuracy_ && point.seconds < most &&
                        !run(i, point.steps, seconds))
                        return;
    }

    [[nodiscard]] const std::vector<WorkCurve>& curves() const { return curves_; }

    /// Whether a run was not made for want of time.
    [[nodiscard]] bool is_cut_short() const { return is_cut_short_; }

private:
    static constexpr double seconds_of_look = 1e-6;  // three repetitions
    static constexpr double seconds_of_second_look = 0.01;
    static constexpr double patience = 10, least_patience = 0.1;  // see seconds_of_best()

    /// NOTE: three repetitions may all have been disturbed, so it is timed once more before.
    bool has_no_hope(std::size_t i) {
        if (!is_hopeless(curves_[i], accuracy_, seconds_of_best())) return false;
        if (!run(i, curves_[i].points.back().steps, seconds_of_second_look)) return true;
        return is_hopeless(curves_[i], accuracy_, seconds_of_best());
    }

    /// Whether there was time for it.
    [[nodiscard]] bool run(std::size_t i, std::int64_t count, double seconds) {
        const auto measured = measures_[i](count, seconds);
        is_cut_short_ = is_cut_short_ || !measured;
        if (!measured) return false;
        const auto known = [&](std::int64_t, double) { return *measured; };
        add_point(curves_[i], work_point(course_, known, count, seconds));
        return true;
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
    std::vector<PatientRuns> measures_;
    bool is_cut_short_ = false;
};

/// The fastest that gets to the accuracy, else the one with the smallest error. Throws MathError
/// where more time would not have led there.
void choose(Advice& advice, const std::string& scene, double accuracy, bool is_cut_short) {
    if (const auto chosen = fastest(advice.curves, accuracy)) {
        advice.chosen = *chosen;
        advice.point = *cheapest(advice.curves[*chosen], accuracy);
        return;
    }
    const WorkPoint* best = nullptr;
    for (std::size_t i = 0; i < advice.curves.size(); ++i)
        for (const WorkPoint& point : advice.curves[i].points)
            if (point.ok() && (best == nullptr || point.error < best->error)) {
                best = &point;
                advice.chosen = i;
            }
    const std::string what =
        fmt::format("no method takes {} to its end with an error of {}", scene, accuracy);
    if (best == nullptr) throw MathError(what, {}, "none comes to the end at all");
    if (!is_cut_short)
        throw MathError(what, {},
                        fmt::format("the best is {:.2e}, by {} in {} steps", best->error,
                                    advice.curves[advice.chosen].name, best->steps));
    advice.point = *best;
    advice.is_reached = false;
}

/// The smallest accuracy whose reference may be in double, which knows a hundredth of it.
constexpr double coarsest_of_quadruple = 1e-9;
constexpr double part_of_accuracy = 1e-2;

/// A solution, and the run of the last candidate that ends there, where it is of one.
struct FoundReference {
    Reference reference;
    std::optional<WorkPoint> run = {};
};

/// A reference by a method of high order, whose steps are halved until the end moves little, or for
/// so many seconds.
FoundReference reference_in_double(const Contender& contender, const AdviceWishes& wishes,
                                   double seconds) {
    constexpr std::int64_t most_steps = 1'000'000'000;
    const Deadline deadline(seconds);
    PatientRuns runs(measured(contender, wishes.until), deadline);
    Course course{{contender.title + " in 53 bits", std::numeric_limits<double>::infinity(), {}},
                  wishes.until,
                  wishes.first_count,
                  {},
                  false};
    FoundReference found;
    for (std::int64_t count = wishes.first_count; count < most_steps; count *= 2) {
        const std::optional<Measurement> run = runs(count, 0);
        if (!run) break;
        if (!run->ok()) continue;
        Reference& reference = course.reference;
        if (reference.state.empty()) reference.state = std::get<EndOfRun>(run->end).state;
        const WorkPoint point = work_point(course, *run);
        if (found.run) reference.error = point.error;
        found.run = point;
        found.run->error = reference.error;
        reference.state = std::get<EndOfRun>(run->end).state;
        if (reference.error <= part_of_accuracy * wishes.accuracy) break;
    }
    found.reference = course.reference;
    return found;
}

[[noreturn]] void refuse_reference(const std::string& scene, double error) {
    throw MathError(
        fmt::format("the motion of {} is known with an error of {:.1e} only", scene, error), {},
        "ask for less, for an earlier end by --until, or for more by --budget");
}

/// Throws MathError where it is not known to a hundredth of the accuracy, and there is no run.
FoundReference good_reference(const Build& quadruple, const Contender& contender,
                              const WrittenOutScene& scene, const AdviceWishes& wishes) {
    const double wanted = part_of_accuracy * wishes.accuracy;
    const double seconds = wishes.seconds / 2;  // the rest is for the race
    const bool is_fine = has_exact_states(scene) || wishes.accuracy < coarsest_of_quadruple;
    FoundReference found = is_fine ? FoundReference{reference(quadruple, scene, wishes.until,
                                                              wishes.first_count, wanted, seconds)}
                                   : reference_in_double(contender, wishes, seconds);
    const double error = found.reference.error;
    if (!std::isfinite(error))
        throw MathError(
            fmt::format("there is no reference solution of {} in {:.3g} s", scene.name, seconds),
            {}, "ask for less, for an earlier end by --until, or for more by --budget");
    if (!(error <= wanted) && !found.run) refuse_reference(scene.name, error);
    return found;
}

/// An advice on the way: what is compiled, and what is said meanwhile.
class Adviser {
public:
    Adviser(const LoweredScene& scene, const AdviceWishes& wishes) : scene_(scene.scene.name) {
        advice_.candidates = candidates(scene, wishes);
        if (!wishes.has_action) sweeps_ = sweeps_for(wishes.accuracy);
        parts_ = static_cast<double>(2 * advice_.candidates.size() + 2);
        show("deriving and writing steppers");
    }

    /// Compiles the contender of each candidate, which `make(candidate)` orders.
    void compile(const std::function<Contender(const Candidate&)>& make) {
        for (const Candidate& candidate : advice_.candidates)
            contenders_.push_back(make(candidate));
        count_sweeps(make);
        for (const Contender& contender : contenders_) {
            advice_.costs.push_back(contender.costs);
            show("compiling " + contender.title);
            contender.module.wait_for_all();
        }
        show("reference");
    }

    [[nodiscard]] const std::vector<Contender>& contenders() const { return contenders_; }

    /// Where nothing else is known so well as this run of the last contender.
    [[nodiscard]] Advice with(const FoundReference& found) && {
        advice_.reference = found.reference;
        for (const Contender& contender : contenders_)
            advice_.curves.push_back({contender.title, contender.order, false, {}, {}});
        advice_.curves.back().points.push_back(*found.run);
        advice_.chosen = contenders_.size() - 1;
        advice_.point = *found.run;
        advice_.is_reached = false;
        return std::move(advice_);
    }

    /// The best of a race.
    [[nodiscard]] Advice with_race(const Course& course, double accuracy,
                                   const std::vector<MeasureSteps>& measures,
                                   const Deadline& deadline) && {
        advice_.reference = course.reference;
        Race race(course, accuracy, contenders_, measures, deadline);
        for (std::size_t i = 0; i < contenders_.size(); ++i) race.begin(i);
        for (const std::size_t i : race.by_prediction()) {
            show("running " + race.curves()[i].name);
            race.finish(i);
        }
        race.time_the_best();
        advice_.curves = race.curves();
        choose(advice_, scene_, accuracy, race.is_cut_short());
        return std::move(advice_);
    }

private:
    /// Adds candidates of counted sweeps. NOTE: the last one of all stays the last, as references
    /// are by it.
    void count_sweeps(const std::function<Contender(const Candidate&)>& make) {
        std::vector<Candidate> candidates;
        for (std::size_t i = 0; i < contenders_.size(); ++i)
            if (contenders_[i].takes_sweeps &&
                std::count(std::begin(swept_methods), std::end(swept_methods),
                           contenders_[i].title) > 0)
                for (const int sweeps : sweeps_)
                    candidates.push_back({advice_.candidates[i].method, Solver::automatic, sweeps});
        std::vector<Contender> contenders;
        for (const Candidate& candidate : candidates) contenders.push_back(make(candidate));
        parts_ += 2 * static_cast<double>(candidates.size());
        advice_.candidates.insert(advice_.candidates.end() - 1, candidates.begin(),
                                  candidates.end());
        contenders_.insert(contenders_.end() - 1, contenders.begin(), contenders.end());
    }

    void show(const std::string& what) { bar_.show(done_++ / parts_, scene_ + ": " + what); }

    std::string scene_;
    Advice advice_;
    std::vector<Contender> contenders_;
    std::vector<int> sweeps_;  ///< numbers of them that are tried
    double parts_ = 1, done_ = 0;
    Bar bar_;
};

Advice advice_written_out(Builds& builds, const LoweredScene& scene, const AdviceWishes& wishes) {
    Adviser adviser(scene, wishes);
    const Build quadruple =
        wishes.accuracy < coarsest_of_quadruple ? reference_build(builds, scene) : Build();
    adviser.compile([&](const Candidate& candidate) {
        return contender(builds, candidate.method, scene, candidate.solver, candidate.sweeps);
    });
    const Deadline deadline(wishes.seconds);
    const FoundReference found =
        good_reference(quadruple, adviser.contenders().back(), *scene.written, wishes);
    if (!(found.reference.error <= part_of_accuracy * wishes.accuracy))
        return std::move(adviser).with(found);
    const Course course{
        found.reference, wishes.until, wishes.first_count, {}, !scene.system.time.has_value()};
    std::vector<MeasureSteps> measures;
    for (const Contender& contender : adviser.contenders())
        measures.push_back(measured(contender, course.until));
    return std::move(adviser).with_race(course, wishes.accuracy, measures, deadline);
}

/// Beside a reference in long double, or its exact one.
Advice advice_with_loops(Builds& builds, const LoweredScene& scene, const AdviceWishes& wishes) {
    Adviser adviser(scene, wishes);
    const LargeReference large(builds, scene.scene, wishes.until);
    adviser.compile([&](const Candidate& candidate) {
        return contender(builds, candidate.method, scene, candidate.solver, candidate.sweeps);
    });
    large.wait();
    const Deadline deadline(wishes.seconds);
    const Course course{large.compute(wishes.first_count, wishes.seconds / 2),
                        wishes.until,
                        wishes.first_count,
                        {},
                        !scene.system.time.has_value()};
    if (!(course.reference.error <= part_of_accuracy * wishes.accuracy))
        refuse_reference(scene.scene.name, course.reference.error);
    std::vector<MeasureSteps> measures;
    for (const Contender& contender : adviser.contenders())
        measures.push_back(large.measured(contender));
    return std::move(adviser).with_race(course, wishes.accuracy, measures, deadline);
}

/// Throws InputError where sums stay loops. NOTE: of scaled time the length of a run is that of s,
/// and the number of steps is one of whole ones, or one less.
Advice advice_eventful(Builds& builds, const LoweredScene& scene, const AdviceWishes& wishes) {
    if (!scene.written)
        throw InputError("--accuracy is not built for jumps, kinks that end steps and scaled time "
                         "where sums stay loops",
                         scene.scene.place,
                         "--unroll yes writes the sums out, up to 256 degrees of freedom");
    constexpr std::int64_t far_more = 16;
    Adviser adviser(scene, wishes);
    const EventfulRuns runs(scene, wishes.until);
    const Contender fine = eventful_reference_contender(builds, scene);
    adviser.compile([&](const Candidate& candidate) {
        return contender(builds, candidate.method, scene, candidate.solver, candidate.sweeps);
    });
    fine.module.wait_for_all();
    const Deadline deadline(wishes.seconds);
    const double wanted = part_of_accuracy * wishes.accuracy;
    const double h = wishes.until / static_cast<double>(wishes.first_count);
    const double length = runs.length(fine, h, wishes.seconds / 4);
    const std::int64_t count = std::max<std::int64_t>(1, std::llround(length / h));
    const Course course{runs.reference(fine, length, count, wanted, wishes.seconds / 4),
                        length,
                        count,
                        {},
                        !scene.system.time.has_value()};
    if (!(course.reference.error <= wanted))
        refuse_reference(scene.scene.name, course.reference.error);
    std::vector<MeasureSteps> measures;
    for (const Contender& contender : adviser.contenders())
        measures.emplace_back([&runs, &contender, length](std::int64_t steps, double seconds) {
            return runs.measured(contender, length / static_cast<double>(steps), seconds,
                                 far_more * (steps + 1));
        });
    return std::move(adviser).with_race(course, wishes.accuracy, measures, deadline);
}

}  // namespace

Advice advice(Builds& builds, const Scene& scene, const AdviceWishes& wishes) {
    const LoweredScene system = lowered(scene, wishes.sums);
    if (is_eventful(scene)) return advice_eventful(builds, system, wishes);
    return system.written ? advice_written_out(builds, system, wishes)
                          : advice_with_loops(builds, system, wishes);
}

}  // namespace hvi::gen

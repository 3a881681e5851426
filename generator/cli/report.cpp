// `hvi-gen report`: what a digit costs with which method.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/cli/commands.hpp"
#include "generator/cli/keeping.hpp"
#include "generator/cli/method.hpp"
#include "generator/cli/run_wishes.hpp"
#include "generator/cli/words.hpp"
#include "generator/edges/edges.hpp"
#include "generator/edges/program.hpp"
#include "generator/read/scene_times.hpp"
#include "generator/read/unrolling.hpp"
#include "generator/render/statements.hpp"
#include "generator/report/render.hpp"
#include "generator/scene/step_count.hpp"
#include "generator/study/eventful.hpp"
#include "generator/study/study.hpp"
#include "generator/support/output_file.hpp"
#include "generator/support/process.hpp"
#include "generator/symmetry/watched.hpp"

namespace hvi::gen {

namespace {

namespace fs = std::filesystem;

constexpr const char* usual_on_scenes =
    "stormer-verlet, stormer-verlet-blanes-moan:6, lobatto:3, gauss:2, gauss:4, gauss:8";
/// Degrees of freedom of scenes at edges: derivatives of steps have four times the square of them.
constexpr std::size_t most_at_edges = 64;
constexpr const char* usual_at_edges = "stormer-verlet, trig3, lobatto:3, gauss:2, gauss:4";

/// A scene with the words of [run] that a report needs.
struct Subject {
    Scene scene;
    double until = 0;
    std::int64_t first_count = 0;
    std::vector<double> steps = {};
    Watched watched = {};
};

/// Throws InputError where an option is given that a scene does not go with.
void refuse(const std::optional<Place>& option, const char* what, const char* help) {
    if (option)
        throw InputError(fmt::format("{} not built for scenes of so many degrees of freedom", what),
                         *option, help);
}

void refuse_peers(const ReportOptions& options) {
    refuse(options.peers, "integrators of other libraries are",
           "without --peers it compares methods of ours");
}

void refuse_edges(const ReportOptions& options) {
    refuse(options.edges, "stiff and extreme cases, and derivatives of steps, are",
           "without SCENE they are those of scenes that come with the program");
}

/// A scene of the report, which has what is asked of it.
Scene scene_for(const Given& name, const ReportOptions& options) {
    Scene scene = find_scene(name);
    const std::size_t degrees = degrees_of_freedom(scene);
    if (degrees > most_degrees_of_freedom) refuse_peers(options);
    if (degrees > most_at_edges) refuse_edges(options);
    if (!unroll_decision(scene, options.sums).writes_out) {
        refuse_peers(options);
        refuse_edges(options);
        if (is_eventful(scene))
            throw InputError("a report is not built for jumps, kinks that end steps and scaled "
                             "time where sums stay loops",
                             scene.place,
                             "--unroll yes writes the sums out, up to 256 degrees of freedom");
    }
    if (options.peers) refuse_rotations(scene, "a comparison with other libraries");
    if (options.peers && is_eventful(scene))
        throw InputError("integrators of other libraries are not built for scaled time, jumps and "
                         "kinks that end steps",
                         *options.peers, "without --peers it compares methods of ours");
    return scene;
}

std::string name_of(const Subject& subject) { return subject.scene.name; }

/// The step of the scene; where it has none, the first of those that are asked for.
NamedExpression first_step(const SceneTimes& times, const ReportOptions& options) {
    const bool is_given = !times.step && options.steps;
    return wish(times, is_given ? list_items(options.steps).front() : nullptr, times.step, "step",
                "--steps 1/10,1/20");
}

/// Throws MathError where steps of this size in scaled time do not lead to the end.
double scaled_step(const SceneTimes& times, const NamedExpression& step, double until) {
    const double size = nearest_value(times, step);
    if (size * until > 0) return size;
    throw MathError("steps of this size lead away from the end of the run, or nowhere", step.place,
                    "step and until have the same sign");
}

/// Steps of a scene in scaled time, of which none lead just to the end.
void set_scaled_steps(Subject& subject, const SceneTimes& times, const NamedExpression& first,
                      const ReportOptions& options) {
    const double size = scaled_step(times, first, subject.until);
    subject.first_count = std::max<std::int64_t>(1, std::llround(subject.until / size));
    if (!options.steps) return;
    for (const auto& item : list_items(options.steps))
        subject.steps.push_back(
            scaled_step(times, expression_of_parameters(times, "step", item), subject.until));
}

Subject subject(const Given& name, const ReportOptions& options) {
    Subject result{scene_for(name, options)};
    const SceneTimes times = times_of(result.scene);
    const NamedExpression until = wish(times, options.until, times.until, "until");
    const NamedExpression step = first_step(times, options);
    result.until = nearest_value(times, until);
    if (result.scene.scale) {
        set_scaled_steps(result, times, step, options);
        return result;
    }
    result.first_count = std::max<std::int64_t>(1, steps_until(times, step, until).count);
    if (!options.steps) return result;
    for (const auto& item : list_items(options.steps)) {
        const NamedExpression h = expression_of_parameters(times, "step", item);
        static_cast<void>(steps_until(times, h, until));  // it leads there
        result.steps.push_back(nearest_value(times, h));
    }
    return result;
}

/// METHOD, then those of --methods; where there are none of both, the usual ones.
std::vector<ExactMethod> methods(const ReportOptions& options) {
    std::vector<ExactMethod> result;
    const MethodOptions& method = options.method;
    const bool is_given = method.name || method.basis || method.file;
    if (!is_given && !method.parameters.empty())
        throw InputError("--param is of METHOD, and none is given",
                         whole(method.parameters.front()), "for example --method-file mine.toml");
    if (is_given) result.push_back(exact_method({method_of(method)}));
    Given names = options.methods;
    if (!names && result.empty())
        names = given("--methods", options.scenes.empty() ? usual_at_edges : usual_on_scenes);
    if (!names) return result;
    for (const Given& name : list_items(names))
        result.push_back(exact_method(composed_method(name)));
    return result;
}

std::string joined(const std::vector<std::string>& words) {
    return fmt::format("{}", fmt::join(words, " "));
}

/// Finds the libraries that are installed. The report notes which these are, and which are left
/// out.
void find_peers(Builds& builds, StudyWishes& wishes, Report& report) {
    for (const PeerLibrary& library : peer_libraries()) {
        const auto version = installed_version(builds, library);
        if (version) wishes.libraries.push_back(library);
        report.notes.push_back(
            version ? fmt::format("{} is {} {}", library.name, library.title, *version)
                    : fmt::format("{} is not installed, and left out", library.title));
    }
}

/// A sentence where errors of methods are hidden by that of the reference.
void note_reference(Report& report, const SceneReport& scene) {
    constexpr double rough = 1e-6;
    if (scene.reference.error <= rough) return;
    report.notes.push_back(fmt::format(
        "the reference solution of {} is known to {:.1e} only: an earlier --until has a better one",
        scene.name, scene.reference.error));
}

/// A sentence where nothing is said of what methods keep.
void note_left_out(Report& report, const Subject& subject) {
    if (subject.watched.left_out.empty()) return;
    report.notes.push_back(fmt::format("symmetries of {} are not looked for: {}", name_of(subject),
                                       subject.watched.left_out));
}

/// Sentences on what runs of the scene are.
void note_events(Report& report, const Scene& scene) {
    if (scene.scale)
        report.notes.push_back(fmt::format(
            "steps of {} are of scaled time: h is one of s, and the end is at t", scene.name));
    for (const IndexedEvent& event : scene.events)
        if (event.set)
            report.notes.push_back(fmt::format(
                "the event {} of {} jumps, and stops no run: what is said to be kept is "
                "kept between its jumps, and run times have the search for it",
                event.name, scene.name));
    if (scene.kinks)
        report.notes.push_back(fmt::format("steps of {} end at kinks of its H", scene.name));
}

/// A sentence on the drift of counted sweeps, in the runs of fewest and of most steps.
void note_sweeps(Report& report, const SceneReport& scene) {
    for (const WorkCurve& curve : scene.curves) {
        if (curve.sweeps == 0) continue;
        std::string drift;
        for (const WorkPoint& point : curve.points) {
            const bool is_end = &point == &curve.points.front() || &point == &curve.points.back();
            if (is_end && point.ok() && std::isfinite(point.drift))
                drift += fmt::format("{} by {:.1e} a step of h = {:.3g}", drift.empty() ? "" : ",",
                                     point.drift, point.h);
        }
        report.notes.push_back(
            fmt::format("{} on {} is explicit, and symplectic up to the last change alone{}{}",
                        curve.name, scene.name, drift.empty() ? "" : "; the energy drifts", drift));
    }
}

/// Sets the verdicts on each method beside what was measured. NOTE: curves of methods come first,
/// in the order of the methods; those of counted sweeps keep nothing for sure.
void set_kept(SceneReport& of_scene, const Subject& subject, const StudyWishes& wishes) {
    const Watched& watched = subject.watched;
    const std::vector<std::string>& names = watched.names;
    const std::vector<StudiedMethod>& methods = wishes.methods;
    for (std::size_t i = 0; i < methods.size() && i < of_scene.curves.size(); ++i) {
        WorkCurve& curve = of_scene.curves[i];
        KeepingFacts facts = keeping_facts(methods[i].base);
        if (watched.found)
            add_parts(facts, methods[i].method, subject.scene, wishes.sums, *watched.found);
        for (const Statement& statement : watched.statements(facts)) {
            const auto place = std::find(names.begin(), names.end(), statement.name);
            const auto at = static_cast<std::size_t>(place - names.begin());
            const std::vector<double>& largest = curve.departures.largest;
            curve.kept.push_back({statement.name, to_text(statement.expression),
                                  std::string(keeping_text(statement.keeping)), statement.reason,
                                  at < largest.size() ? largest[at] : std::nan("")});
        }
    }
}

void add_scenes(Report& report, Builds& builds, const std::vector<Subject>& subjects,
                const std::vector<ExactMethod>& methods, StudyWishes wishes) {
    {
        const TimeSpent::Part part(report.time_spent, "looking for orders");
        for (const ExactMethod& method : methods) wishes.methods.push_back(studied(method));
    }
    for (const Subject& subject : subjects) {
        wishes.steps = subject.steps;
        SceneReport& of_scene = report.scenes.emplace_back();
        note_left_out(report, subject);
        note_events(report, subject.scene);
        try {
            study(builds, subject.scene, subject.until, subject.first_count, wishes, of_scene,
                  report.time_spent);
            note_reference(report, of_scene);
            note_sweeps(report, of_scene);
            set_kept(of_scene, subject, wishes);
        } catch (const Error& error) {
            report.incomplete = name_of(subject) + ": " + error.what();
            if (of_scene.curves.empty()) report.scenes.pop_back();
            throw;
        }
    }
}

std::vector<Scene> scenes_by_name(const std::vector<std::string>& names) {
    std::vector<Scene> scenes;
    for (const std::string& name : names) scenes.push_back(edge_scene(name));
    return scenes;
}

/// Scenes that come with the program, but for large ones, whose steps have derivatives of too many
/// parts, and those in scaled time. NOTE: of events there is nothing to see here.
std::vector<Scene> all_scenes() {
    std::vector<Scene> result;
    for (const SceneEntry& entry : scenes()) {
        if (entry.degrees_of_freedom > most_at_edges) continue;
        Scene scene = edge_scene(std::string(entry.name));
        if (!scene.scale) result.push_back(std::move(scene));
    }
    return result;
}

/// On the scenes of the report that are small and written out; where it has no scene, on some that
/// come with the program.
void add_edges(Report& report, Builds& builds, const std::vector<ExactMethod>& methods,
               const std::vector<Subject>& subjects, const ReportOptions& options) {
    // Each kind of stepper occurs, and a collision.
    const std::vector<std::string> various{"pendulum", "kepler", "henon-heiles", "nonseparable",
                                           "harmonic-oscillator"};
    std::vector<Scene> given;
    for (const Subject& subject : subjects)
        if (subject.scene.scale)
            report.notes.push_back(fmt::format("single steps of {}, in scaled time, are not looked "
                                               "at: the chapter `time` of --edges has some",
                                               name_of(subject)));
        else if (degrees_of_freedom(subject.scene) <= most_at_edges &&
                 unroll_decision(subject.scene, options.sums).writes_out)
            given.push_back(subject.scene);
    if (given.empty() && !subjects.empty()) return;
    const auto add = [&](ReportItem item, const std::string& name, auto chapter) {
        if (!options.items.contains(item)) return;
        const TimeSpent::Part part(report.time_spent, name);
        report.edges.push_back(chapter());
    };
    add(ReportItem::rejections, "rejections", [&] {
        return rejections(builds, methods, given.empty() ? scenes_by_name(various) : given);
    });
    add(ReportItem::stiff, "stiff", [&] { return stiff(builds, methods); });
    add(ReportItem::stiff, "chain", [&] { return chain(builds, methods); });
    add(ReportItem::extreme, "extreme", [&] { return extreme(builds, methods); });
    add(ReportItem::long_runs, "long runs", [&] { return long_runs(builds, methods); });
    add(ReportItem::time, "events and scaled time",
        [&] { return events_and_scales(builds, methods); });
    add(ReportItem::symplecticity, "symplecticity",
        [&] { return symplecticity(builds, methods, given.empty() ? all_scenes() : given); });
}

/// NOTE: numbers first, as pictures take another program, which may be missing.
void write(const Report& report, const ReportOptions& options, const fs::path& directory) {
    const auto has = [&](ReportItem item) { return options.items.contains(item); };
    make_directory(directory);
    if (has(ReportItem::json)) write_file(directory / "report.json", report_json(report));
    if (has(ReportItem::csv) && !report.scenes.empty())
        write_file(directory / "report.csv", report_csv(report));
    if (has(ReportItem::csv) && !report.scenes.empty())
        write_file(directory / "times.csv", times_csv(report));
    if (has(ReportItem::csv) && !report.edges.empty())
        write_file(directory / "edges.csv", edges_csv(report));
    if (!has(ReportItem::html) && !has(ReportItem::svg)) return;
    const Pictures pictures = report_pictures(report);
    if (has(ReportItem::svg))
        for (const auto* subjects : {&pictures.of_scenes, &pictures.of_edges})
            for (const std::vector<Picture>& all : *subjects)
                for (const Picture& picture : all)
                    write_file(directory / (picture.name + ".svg"), picture.svg);
    if (has(ReportItem::html)) write_file(directory / "report.html", report_html(report, pictures));
}

/// Throws MathError with the first case that is not as expected.
void check_edges(const Report& report, const fs::path& directory) {
    const EdgeCheck* first = nullptr;
    std::size_t wrong = 0, all = 0;
    for (const EdgeChapter& chapter : report.edges)
        for (const EdgeCheck& check : chapter.checks) {
            ++all;
            if (check.agrees) continue;
            ++wrong;
            if (first == nullptr) first = &check;
        }
    if (first == nullptr) return;
    throw MathError(
        fmt::format("{} on {}, {}: expected {}; seen {}", first->method, first->scene, first->what,
                    first->expected, first->seen),
        {},
        fmt::format("{} of {} cases are not as expected: see {}", wrong, all, directory.string()));
}

}  // namespace

void run(const ReportOptions& options) {
    const std::vector<ExactMethod> exact = methods(options);
    std::vector<Subject> subjects;
    for (const Given& scene : options.scenes) subjects.push_back(subject(scene, options));
    if (options.items.contains(ReportItem::work) && options.symmetries)
        for (Subject& subject : subjects) subject.watched = watch(subject.scene, options.sums);

    const InterruptionsHeld held;
    Builds builds(find_compiler());
    const Compiler& compiler = builds.compiler();
    Report report{this_machine(),
                  joined(compiler.command) + " " + joined(compiler_options(Artifact::program)),
                  compiler.version};
    const fs::path directory = options.output.value_or("report");
    try {
        StudyWishes wishes;
        wishes.sums = options.sums;
        wishes.sweeps = options.sweeps;
        if (options.peers) find_peers(builds, wishes, report);
        if (options.items.contains(ReportItem::work))
            add_scenes(report, builds, subjects, exact, std::move(wishes));
        add_edges(report, builds, exact, subjects, options);
    } catch (const Interruption&) { throw; } catch (const Error& error) {
        if (report.incomplete.empty()) report.incomplete = error.what();
        write(report, options, directory);
        throw;
    }
    write(report, options, directory);
    check_edges(report, directory);
}

}  // namespace hvi::gen

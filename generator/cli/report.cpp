// `hvi-gen report`: what a digit costs with which method.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "generator/cli/commands.hpp"
#include "generator/cli/edges.hpp"
#include "generator/cli/run_wishes.hpp"
#include "generator/cli/words.hpp"
#include "generator/exact/functions/step_count.hpp"
#include "generator/report/pictures.hpp"
#include "generator/report/render.hpp"
#include "generator/report/study.hpp"
#include "generator/support/output_file.hpp"
#include "generator/support/process.hpp"

namespace hvi::gen {

namespace {

namespace fs = std::filesystem;

constexpr const char* usual_methods = "stormer-verlet, lobatto:3, gauss:2, gauss:4, gauss:8";

/// A scene with the words of [run] that a report needs.
struct Subject {
    Scene scene;
    double until;
    std::int64_t first_count;
    std::vector<double> steps;
};

Subject subject(const std::string& name, const ReportOptions& options) {
    Scene scene =
        find_scene(name, {std::make_shared<const Source>(Source{"SCENE", name}), {0, name.size()}});
    const NamedExpression until = wish(scene, options.until, scene.run.until, "until");
    const NamedExpression step = wish(scene, {}, scene.run.step, "step");
    Subject result{scene, nearest_value(scene, until), 0, {}};
    result.first_count = std::max<std::int64_t>(1, steps_until(scene, step, until).count);
    if (!options.steps) return result;
    for (const auto& item : list_items("--steps", *options.steps)) {
        const NamedExpression h = expression_of_parameters(scene, "step", item);
        static_cast<void>(steps_until(scene, h, until));  // it leads there
        result.steps.push_back(nearest_value(scene, h));
    }
    return result;
}

std::string joined(const std::vector<std::string>& words) {
    return fmt::format("{}", fmt::join(words, " "));
}

/// What is not installed is left out, and the report says so.
void find_peers(const Compiler& compiler, StudyWishes& wishes, Report& report) {
    for (const PeerLibrary& library : peer_libraries()) {
        const auto version = installed_version(compiler, library);
        if (version) wishes.libraries.push_back(library);
        report.notes.push_back(
            version ? fmt::format("{} is {} {}", library.name, library.title, *version)
                    : fmt::format("{} is not installed, and left out", library.title));
    }
}

void write(const Report& report, const ReportOptions& options, const fs::path& directory) {
    make_directory(directory);
    if (options.json) write_file(directory / "report.json", report_json(report));
    if (options.csv) write_file(directory / "report.csv", report_csv(report));
    if (!options.html && !options.svg) return;
    Pictures all;
    for (const SceneReport& scene : report.scenes) all.merge(report_pictures(scene));
    if (options.svg)
        for (const auto& [name, svg] : all) write_file(directory / (name + ".svg"), svg);
    if (options.html) write_file(directory / "report.html", report_html(report, all));
}

}  // namespace

void run(const ReportOptions& options) {
    StudyWishes wishes;
    for (const auto& name : list_items("--methods", options.methods.value_or(usual_methods)))
        wishes.methods.push_back(named_method(name));
    std::vector<Subject> subjects;
    for (const std::string& scene : options.scenes) subjects.push_back(subject(scene, options));

    const InterruptionsHeld held;
    const Compiler compiler = find_compiler();
    if (subjects.empty()) return report_edges(options, compiler);
    Report report{this_machine(),
                  joined(compiler.command) + " " + joined(compiler_options()),
                  compiler.version,
                  {},
                  {},
                  {}};
    if (options.peers) find_peers(compiler, wishes, report);
    const fs::path directory = options.output.value_or("report");
    for (Subject& subject : subjects) {
        wishes.steps = subject.steps;
        try {
            report.scenes.push_back(
                study(compiler, subject.scene, subject.until, subject.first_count, wishes));
        } catch (const Interruption&) { throw; } catch (const Error& error) {
            report.incomplete = subject.scene.name + ": " + error.what();
            write(report, options, directory);
            throw;
        }
    }
    write(report, options, directory);
    if (options.edges) report_edges(options, compiler);
}

}  // namespace hvi::gen

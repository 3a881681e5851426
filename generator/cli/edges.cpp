// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/edges.hpp"

#include <fmt/format.h>

#include "generator/cli/run_wishes.hpp"
#include "generator/cli/words.hpp"
#include "generator/edges/edges.hpp"
#include "generator/support/error.hpp"
#include "generator/support/output_file.hpp"

namespace hvi::gen {

namespace {

namespace fs = std::filesystem;

constexpr const char* usual_methods = "stormer-verlet, trig3, lobatto:3, gauss:2, gauss:4";

/// Throws MathError with the first case that is not as expected.
void check(const EdgeReport& report, const fs::path& directory) {
    const EdgeCheck* first = nullptr;
    std::size_t wrong = 0, all = 0;
    for (const EdgeChapter& chapter : report.chapters)
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

void report_edges(const ReportOptions& options, const Compiler& compiler) {
    std::vector<Method> methods;
    for (const auto& name : list_items("--methods", options.methods.value_or(usual_methods)))
        methods.push_back(named_method(name));
    std::string command;
    for (const auto* words : {&compiler.command, &compiler_options()})
        for (const std::string& word : *words) command += (command.empty() ? "" : " ") + word;
    EdgeReport report{this_machine(), command, compiler.version, {}};
    for (const auto chapter : {rejections, stiff, long_runs, symplecticity})
        report.chapters.push_back(chapter(compiler, methods));

    const fs::path directory = options.output.value_or("report");
    make_directory(directory);
    if (options.json) write_file(directory / "edges.json", edges_json(report));
    if (options.html) write_file(directory / "edges.html", edges_html(report));
    check(report, directory);
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/emit/text/embedded.hpp"
#include "generator/emit/text/text.hpp"
#include "generator/report/markup.hpp"
#include "generator/report/render.hpp"
#include "generator/report/sections.hpp"
#include "generator/study/time_to_accuracy.hpp"

namespace hvi::gen {

namespace {

/// With the tolerance that has led to it.
std::string step_size(const WorkPoint& point) {
    const std::string h = fmt::format("{:.4g}", point.h);
    return escaped(point.tolerance > 0 ? fmt::format("{} ({:.0e})", h, point.tolerance) : h);
}

std::string spread(const WorkPoint& point) {
    if (point.seconds <= 0 || !std::isfinite(point.spread)) return "-";
    return fmt::format("{:.0f}&nbsp;%{}", 100 * point.spread, point.is_noisy() ? " noisy" : "");
}

/// The columns of runs. Where all runs end well there is none that says so.
std::vector<std::string> heads_of_runs(bool has_status) {
    std::vector<std::string> heads{
        "h", "error", "energy error", "ms", "spread", "evalua&shy;tions", "itera&shy;tions"};
    if (has_status) heads.push_back("status");
    return heads;
}

std::string row(const WorkPoint& point, bool has_status) {
    std::vector<std::string> cells{step_size(point),
                                   number_markup(point.error),
                                   number_markup(point.energy_error),
                                   point.seconds > 0 ? fmt::format("{:.3g}", 1e3 * point.seconds)
                                                     : "-",
                                   spread(point),
                                   std::to_string(point.evaluations),
                                   fmt::format("{:.2f}", point.iterations)};
    if (has_status) cells.push_back(escaped(point.status));
    std::string text = point.is_noisy() ? "<tr class=\"noisy\">" : "<tr>";
    for (const std::string& cell : cells) text += "<td>" + cell + "</td>";
    return text + "</tr>\n";
}

std::string table_of_runs(const SceneReport& scene) {
    const bool has_status =
        std::any_of(scene.curves.begin(), scene.curves.end(), [](const WorkCurve& curve) {
            return std::any_of(curve.points.begin(), curve.points.end(),
                               [](const WorkPoint& point) { return !point.ok(); });
        });
    const std::vector<std::string> heads = heads_of_runs(has_status);
    std::string text = table_of("numbers", "All runs of " + scene.name, heads);
    for (const WorkCurve& curve : scene.curves) {
        if (curve.points.empty()) continue;
        text += group_row(fmt::format("{}, {}", curve.name,
                                      curve.order > 0 ? fmt::format("order {}", curve.order)
                                                      : "of an order that varies"),
                          heads.size());
        for (const WorkPoint& point : curve.points) text += row(point, has_status);
    }
    return text + end_of_table;
}

std::string cells(const std::optional<Quickest>& found) {
    if (!found) return "<td>-</td><td>-</td>";
    return fmt::format("<td>{}</td><td>{:.3g}</td>", escaped(found->method), 1e3 * found->seconds);
}

/// The fastest of ours beside the fastest of other libraries; empty where none of these was
/// measured, as the summary says the rest.
std::string table_of_peers(const SceneReport& scene) {
    if (std::none_of(scene.curves.begin(), scene.curves.end(),
                     [](const WorkCurve& curve) { return curve.is_peer; }))
        return "";
    std::string text =
        table_of("numbers", "Beside other libraries on " + scene.name,
                 {"error at most", "fastest", "ms", "of other libraries", "ms", "times as long"});
    for (const TimeToAccuracy& time : times_to_accuracies(scene))
        text += fmt::format(
            "<tr><td>{}</td>{}{}<td>{}</td></tr>\n", escaped(fmt::format("{:.0e}", time.accuracy)),
            cells(time.own), cells(time.peer),
            time.own && time.peer ? fmt::format("{:.2f}", time.peer->seconds / time.own->seconds)
                                  : "-");
    return text + end_of_table;
}

/// Verdicts on methods and conserved quantities, and the largest departures in runs.
std::string table_of_kept(const SceneReport& scene) {
    const std::vector<std::string> heads{"conserved", "by each step", "why", "largest departure"};
    std::string rows;
    for (const WorkCurve& curve : scene.curves) {
        if (curve.kept.empty()) continue;
        rows += group_row(curve.name, heads.size());
        for (const KeptQuantity& kept : curve.kept)
            rows +=
                fmt::format("<tr><td title=\"{}\">{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                            attribute(kept.expression), escaped(kept.name), escaped(kept.verdict),
                            escaped(kept.reason), number_markup(kept.largest));
    }
    if (rows.empty()) return "";
    return table_of("words", "What methods keep on " + scene.name, heads) + rows + end_of_table;
}

std::string reference(const SceneReport& scene) {
    const Reference& reference = scene.reference;
    if (reference.kind == "exact") return "the exact solution of the scene";
    return fmt::format("{}, whose end moves by {:.1e} when its steps are halved", reference.kind,
                       reference.error);
}

/// `compiling 12 s, running gauss:4 3.1 s`.
std::string text(const TimeSpent& time_spent) {
    std::string text;
    for (const auto& [what, seconds] : time_spent.parts())
        text += fmt::format("{}{} {:.2g} s", text.empty() ? "" : ", ", what, seconds);
    return text;
}

std::string section(const SceneReport& scene, const std::vector<Picture>& pictures,
                    const std::string& id) {
    std::string text =
        fmt::format("<h3 id=\"{}\">{}</h3>\n<p>{}{}To t = {:.10g}. Reference: {}.</p>\n", id,
                    escaped(scene.name), escaped(scene.description),
                    scene.description.empty() ? "" : ". ", scene.until, escaped(reference(scene)));
    return text + pictures_html(pictures, id) + table_of_peers(scene) + table_of_kept(scene) +
           table_of_runs(scene);
}

}  // namespace

std::string pictures_html(const std::vector<Picture>& pictures, const std::string& section) {
    if (pictures.empty()) return "";
    std::string text = "<div class=\"pictures\">\n";
    for (std::size_t i = 0; i < pictures.size(); ++i)
        text += "<figure>" +
                inlined(pictures[i].svg, pictures[i].title, fmt::format("{}-{}-", section, i + 1)) +
                "</figure>\n";
    return text + "</div>\n";
}

std::string report_html(const Report& report, const Pictures& pictures) {
    std::string scenes = report.scenes.empty() ? "" : std::string(embedded_template("work.html"));
    for (std::size_t i = 0; i < report.scenes.size(); ++i)
        scenes += section(report.scenes[i], pictures.of_scenes[i], id_of_scene(i));
    if (!scenes.empty()) scenes += "</section>\n";
    const std::string incomplete =
        report.incomplete.empty()
            ? ""
            : fmt::format("<p class=\"incomplete\">Incomplete: {}</p>", escaped(report.incomplete));
    return fill("report.html.in",
                {{"style", std::string(embedded_template("report.css"))},
                 {"title", attribute(report_title(report))},
                 {"incomplete", incomplete},
                 {"summary", summary_html(report)},
                 {"contents", contents_html(report)},
                 {"machine", escaped(fmt::format("{}, {} threads, {}", report.machine.processor,
                                                 report.machine.threads, report.machine.system))},
                 {"compiler", escaped(report.compiler_version + ": " + report.compiler)},
                 {"time_spent", escaped(text(report.time_spent))},
                 {"scenes", scenes},
                 {"edges", edges_html(report, pictures)}});
}

}  // namespace hvi::gen

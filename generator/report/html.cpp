// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "generator/emit/text/embedded.hpp"
#include "generator/emit/text/text.hpp"
#include "generator/report/markup.hpp"
#include "generator/report/render.hpp"
#include "generator/study/time_to_accuracy.hpp"

namespace hvi::gen {

namespace {

std::string number(double value) {
    return std::isfinite(value) ? fmt::format("{:.2e}", value) : "-";
}

/// With the tolerance that has led to it.
std::string step_size(const WorkPoint& point) {
    const std::string h = fmt::format("{:.5g}", point.h);
    return point.tolerance > 0 ? fmt::format("{} ({:.0e})", h, point.tolerance) : h;
}

std::string row(const WorkCurve& curve, const WorkPoint& point, bool is_first) {
    const std::vector<std::string> cells{
        is_first ? escaped(curve.name) : "",
        is_first ? (curve.order > 0 ? std::to_string(curve.order) : "varies") : "",
        step_size(point),
        number(point.error),
        number(point.energy_error),
        point.seconds > 0 ? fmt::format("{:.3g}", 1e3 * point.seconds) : "-",
        point.seconds > 0 ? fmt::format("{:.0f} %", 100 * point.spread) : "-",
        std::to_string(point.evaluations),
        fmt::format("{:.2f}", point.iterations),
        escaped(point.status)};
    std::string text = is_first ? "<tr class=\"first\">" : "<tr>";
    for (const std::string& cell : cells) text += "<td>" + cell + "</td>";
    return text + "</tr>\n";
}

std::string table(const SceneReport& scene) {
    std::string text = "<div class=\"scroll\"><table>\n<tr>";
    for (const char* head : {"method", "order", "h", "error", "energy error", "ms", "spread",
                             "evaluations", "iterations", "status"})
        text += fmt::format("<th>{}</th>", head);
    text += "</tr>\n";
    for (const WorkCurve& curve : scene.curves)
        for (const WorkPoint& point : curve.points)
            text += row(curve, point, &point == &curve.points.front());
    return text + "</table></div>\n";
}

std::string cells(const std::optional<Quickest>& found) {
    if (!found) return "<td>-</td><td>-</td>";
    return fmt::format("<td>{}</td><td>{:.3g}</td>", escaped(found->method), 1e3 * found->seconds);
}

/// What is there first. Other libraries have columns where they were measured.
std::string table_of_times(const SceneReport& scene) {
    bool has_peers = false;
    for (const WorkCurve& curve : scene.curves) has_peers = has_peers || curve.is_peer;
    std::string text =
        "<div class=\"scroll\"><table>\n<tr><th>error at most</th><th>fastest</th><th>ms</th>";
    if (has_peers) text += "<th>of other libraries</th><th>ms</th><th>times as long</th>";
    text += "</tr>\n";
    for (const TimeToAccuracy& time : times_to_accuracies(scene)) {
        text += fmt::format("<tr><td>{:.0e}</td>{}", time.accuracy, cells(time.own));
        const bool both = time.own && time.peer;
        if (has_peers)
            text += fmt::format("{}<td>{}</td>", cells(time.peer),
                                both ? fmt::format("{:.2f}", time.peer->seconds / time.own->seconds)
                                     : "-");
        text += "</tr>\n";
    }
    return text + "</table></div>\n";
}

/// What is said of methods and conserved quantities, and what was seen of it.
std::string table_of_kept(const SceneReport& scene) {
    std::string text;
    for (const WorkCurve& curve : scene.curves)
        for (const KeptQuantity& kept : curve.kept)
            text += fmt::format("{}<td>{}</td><td title=\"{}\">{}</td><td>{}</td><td>{}</td>"
                                "<td>{}</td></tr>\n",
                                &kept == &curve.kept.front() ? "<tr class=\"first\">" : "<tr>",
                                &kept == &curve.kept.front() ? escaped(curve.name) : "",
                                escaped(kept.expression), escaped(kept.name), escaped(kept.verdict),
                                escaped(kept.reason), number(kept.largest));
    if (text.empty()) return "";
    return "<div class=\"scroll\"><table>\n<tr><th>method</th><th>conserved</th><th>by each step"
           "</th><th>why</th><th>largest departure</th></tr>\n" +
           text + "</table></div>\n";
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

std::string section(const SceneReport& scene, const std::vector<Picture>& pictures) {
    std::string text =
        fmt::format("<h3>{}</h3>\n<p>{}{}To t = {:.10g}. Reference: {}.</p>\n", escaped(scene.name),
                    escaped(scene.description), scene.description.empty() ? "" : ". ", scene.until,
                    escaped(reference(scene)));
    for (const Picture& picture : pictures) text += inlined(picture.svg) + "\n";
    return text + table_of_kept(scene) + table_of_times(scene) + table(scene);
}

}  // namespace

std::string report_html(const Report& report, const Pictures& pictures) {
    std::string scenes = report.scenes.empty() ? "" : std::string(embedded_template("work.html"));
    for (std::size_t i = 0; i < report.scenes.size(); ++i)
        scenes += section(report.scenes[i], pictures.of_scenes[i]);
    const std::string incomplete =
        report.incomplete.empty()
            ? ""
            : fmt::format("<p class=\"incomplete\">Incomplete: {}</p>", escaped(report.incomplete));
    std::string notes;
    for (const std::string& note : report.notes) notes += "<br>" + escaped(note);
    return fill("report.html.in",
                {{"style", std::string(embedded_template("report.css"))},
                 {"incomplete", incomplete},
                 {"machine", escaped(fmt::format("{}, {} threads, {}", report.machine.processor,
                                                 report.machine.threads, report.machine.system))},
                 {"compiler", escaped(report.compiler_version + ": " + report.compiler)},
                 {"notes", notes},
                 {"time_spent", escaped(text(report.time_spent))},
                 {"scenes", scenes},
                 {"edges", edges_html(report, pictures)}});
}

}  // namespace hvi::gen

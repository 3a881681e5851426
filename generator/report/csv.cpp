// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "generator/report/render.hpp"
#include "generator/study/time_to_accuracy.hpp"

namespace hvi::gen {

namespace {

/// Empty for what is no finite number.
std::string cell(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

/// In quotes, as what may have a comma in it.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
}

std::string remarks(const Report& report) {
    std::string text;
    for (const std::string& note : report.notes) text += "# " + note + "\n";
    if (!report.incomplete.empty()) text += "# incomplete: " + report.incomplete + "\n";
    return text;
}

}  // namespace

std::string report_csv(const Report& report) {
    std::string text =
        "scene,method,order,peer,h,tolerance,steps,error,energy_error,seconds,spread,"
        "evaluations,iterations,status\n";
    for (const SceneReport& scene : report.scenes)
        for (const WorkCurve& curve : scene.curves)
            for (const WorkPoint& point : curve.points)
                text += fmt::format(
                    "{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", quoted(scene.name),
                    quoted(curve.name), curve.order > 0 ? std::to_string(curve.order) : "",
                    curve.is_peer, point.h, point.tolerance > 0 ? cell(point.tolerance) : "",
                    point.steps, cell(point.error), cell(point.energy_error),
                    point.seconds > 0 ? cell(point.seconds) : "",
                    point.seconds > 0 ? cell(point.spread) : "", point.evaluations,
                    point.iterations, quoted(point.status));
    return text + remarks(report);
}

std::string times_csv(const Report& report) {
    const auto cells = [](const std::optional<Quickest>& found) {
        return found ? fmt::format("{},{}", quoted(found->method), found->seconds) : ",";
    };
    std::string text = "scene,accuracy,method,seconds,peer,peer_seconds,ratio\n";
    for (const SceneReport& scene : report.scenes)
        for (const TimeToAccuracy& time : times_to_accuracies(scene))
            text += fmt::format("{},{},{},{},{}\n", quoted(scene.name), time.accuracy,
                                cells(time.own), cells(time.peer),
                                time.own && time.peer
                                    ? fmt::format("{:.2f}", time.peer->seconds / time.own->seconds)
                                    : "");
    return text + remarks(report);
}

std::string edges_csv(const Report& report) {
    std::string text = "chapter,method,scene,case,expected,seen,agrees\n";
    for (const EdgeChapter& chapter : report.edges)
        for (const EdgeCheck& check : chapter.checks)
            text += fmt::format("{},{},{},{},{},{},{}\n", chapter.name, quoted(check.method),
                                quoted(check.scene), quoted(check.what), quoted(check.expected),
                                quoted(check.seen), check.agrees);
    return text + remarks(report);
}

}  // namespace hvi::gen

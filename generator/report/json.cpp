// SPDX-License-Identifier: GPL-2.0-or-later
#include <nlohmann/json.hpp>

#include "generator/report/render.hpp"
#include "generator/study/time_to_accuracy.hpp"

namespace hvi::gen {

namespace {

using Json = nlohmann::ordered_json;  // NOTE: it writes null for what is no finite number

Json json_of(const WorkPoint& point) {
    return {{"h", point.h},
            {"tolerance", point.tolerance > 0 ? Json(point.tolerance) : Json(nullptr)},
            {"steps", point.steps},
            {"error", point.error},
            {"energy_error", point.energy_error},
            {"seconds", point.seconds > 0 ? Json(point.seconds) : Json(nullptr)},
            {"spread", point.seconds > 0 ? Json(point.spread) : Json(nullptr)},
            {"evaluations", point.evaluations},
            {"iterations", point.iterations},
            {"status", point.status}};
}

Json json_of(const KeptQuantity& kept) {
    return {{"name", kept.name},
            {"expression", kept.expression},
            {"verdict", kept.verdict},
            {"reason", kept.reason},
            {"largest", kept.largest}};
}

Json json_of(const WorkCurve& curve) {
    Json points = Json::array();
    for (const WorkPoint& point : curve.points) {
        points.push_back(json_of(point));
        if (curve.sweeps > 0) points.back()["drift"] = point.drift;
    }
    Json kept = Json::array();
    for (const KeptQuantity& each : curve.kept) kept.push_back(json_of(each));
    Json json{{"name", curve.name},
              {"order", curve.order > 0 ? Json(curve.order) : Json(nullptr)},
              {"peer", curve.is_peer}};
    if (curve.sweeps > 0) json["sweeps"] = curve.sweeps;
    json["conserved"] = std::move(kept);
    json["points"] = std::move(points);
    return json;
}

Json json_of(const std::optional<Quickest>& found) {
    if (!found) return nullptr;
    return {{"name", found->method}, {"seconds", found->seconds}};
}

Json json_of(const TimeToAccuracy& time) {
    return {{"error", time.accuracy},
            {"fastest", json_of(time.own)},
            {"fastest_peer", json_of(time.peer)}};
}

Json json_of(const SceneReport& scene) {
    Json times = Json::array();
    for (const TimeToAccuracy& time : times_to_accuracies(scene)) times.push_back(json_of(time));

    Json methods = Json::array();
    for (const WorkCurve& curve : scene.curves) methods.push_back(json_of(curve));
    return {{"name", scene.name},
            {"until", scene.until},
            {"reference", {{"kind", scene.reference.kind}, {"error", scene.reference.error}}},
            {"methods", std::move(methods)},
            {"times", std::move(times)}};
}

Json json_of(const EdgeCheck& check) {
    return {{"method", check.method},     {"scene", check.scene}, {"case", check.what},
            {"expected", check.expected}, {"seen", check.seen},   {"agrees", check.agrees}};
}

Json json_of(const EdgeChapter& chapter) {
    Json checks = Json::array();
    for (const EdgeCheck& check : chapter.checks) checks.push_back(json_of(check));
    return {{"name", chapter.name}, {"about", chapter.about}, {"checks", std::move(checks)}};
}

Json json_of(const TimeSpent& time_spent) {
    Json parts = Json::array();
    for (const auto& [what, seconds] : time_spent.parts())
        parts.push_back({{"on", what}, {"seconds", seconds}});
    return parts;
}

}  // namespace

std::string report_json(const Report& report) {
    Json json{{"schema", "hvi-report/1"},
              {"machine",
               {{"processor", report.machine.processor},
                {"threads", report.machine.threads},
                {"system", report.machine.system}}},
              {"compiler", {{"command", report.compiler}, {"version", report.compiler_version}}}};
    if (!report.notes.empty()) json["notes"] = report.notes;
    if (!report.incomplete.empty()) json["incomplete"] = report.incomplete;
    json["scenes"] = Json::array();
    for (const SceneReport& scene : report.scenes) json["scenes"].push_back(json_of(scene));
    json["edges"] = Json::array();
    for (const EdgeChapter& chapter : report.edges) json["edges"].push_back(json_of(chapter));
    json["time_spent"] = json_of(report.time_spent);
    return json.dump(2) + "\n";
}

}  // namespace hvi::gen

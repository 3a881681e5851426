// A certificate as JSON, schema hvi-check/1.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/render/certificate_json.hpp"

#include "generator/render/certificate.hpp"
#include "generator/render/named_lines.hpp"

namespace hvi::gen {

namespace {

constexpr int digits_of_certificate = 50;

}  // namespace

Json exceptions_json(const std::vector<ExceptionalValue>& exceptions) {
    Json json = Json::array();
    for (const ExceptionalValue& value : exceptions) {
        json.push_back({{"parameter", value.parameter},
                        {"value", entry_json(value.value, digits_of_certificate)},
                        {"order", value.order},
                        {"order_is_at_least", value.is_at_least}});
    }
    return json;
}

Json failures_json(const OrderConditions& conditions) {
    if (conditions.is_at_least) { return nullptr; }
    Json json = Json::array();
    for (const FailedCondition& failure : conditions.failures) {
        json.push_back({{"tree", failure.tree->text},
                        {"residual", entry_json(failure.residual, digits_of_certificate)}});
    }
    return json;
}

Json error_constant_json(const OrderConditions& conditions) {
    const auto constant = conditions.error_constant();
    return constant ? entry_json(*constant, digits_of_certificate) : Json(nullptr);
}

namespace {

Json places_json(const std::vector<Number>& places) {
    Json json = Json::array();
    for (const Number& place : places) { json.push_back(place.nearest_double()); }
    return json;
}

Json intervals_json(const std::vector<StabilityInterval>& intervals) {
    Json json = Json::array();
    for (const StabilityInterval& interval : intervals) {
        json.push_back(places_json({interval.low, interval.high}));
    }
    return json;
}

Json touching_json(const std::vector<TouchingPoint>& points) {
    Json json = Json::array();
    for (const TouchingPoint& point : points) {
        json.push_back({{"z", point.z.nearest_double()},
                        {"half_trace", point.half_trace},
                        {"identity", point.is_identity}});
    }
    return json;
}

Json limit_json(const LimitOfHalfTrace& limit) {
    return {{"half_trace",
             limit.value ? entry_json(*limit.value, digits_of_certificate) : Json(nullptr)},
            {"sign", limit.sign},
            {"stable", limit.is_stable}};
}

}  // namespace

Json stability_json(const Findings& findings) {
    Json json;
    const auto& map = findings.oscillator;
    const auto half_trace = map ? closed_form(map->half_trace) : std::nullopt;
    json["half_trace"] = half_trace ? Json(to_text(*half_trace)) : Json(nullptr);
    json["determinant_is_one"] = map && map->determinant_one.holds && map->determinant_one.proved;
    const auto& stability = findings.stability;
    json["stable"] = stability ? intervals_json(stability->stable) : Json(nullptr);
    json["poles"] = stability ? places_json(stability->poles) : Json(nullptr);
    json["touching"] = stability ? touching_json(stability->touching) : Json(nullptr);
    json["at_infinity"] = stability ? limit_json(stability->at_infinity) : Json(nullptr);
    json["until"] = stability_limit;
    if (!map) { json["not_looked_at"] = why_no_oscillator(findings); }
    return json;
}

namespace {

Json coupled_json(const std::vector<std::vector<StageNode>>& groups) {
    Json json = Json::array();
    for (const auto& group : groups) {
        Json names = Json::array();
        for (const StageNode& node : group) { names.push_back(stage_name(node)); }
        json.push_back(names);
    }
    return json;
}

}  // namespace

Json certificate_json(const Certificate& certificate) {
    const OrderConditions& general = certificate.orders.general;
    Json json;
    json["schema"] = "hvi-check/1";
    json["name"] = certificate.name;
    json["stages"] = certificate.stages;
    json["parameters"] = certificate.parameters;
    json["consistent"] = certificate.is_consistent();
    json["symplectic"] = certificate.symplectic.holds;
    json["symmetric"] = certificate.symmetric.holds;
    json["runge_kutta"] = certificate.runge_kutta.holds;
    json["order"] = general.order;
    json["order_separable"] = certificate.orders.separable.order;
    json["order_nystrom"] = certificate.orders.nystrom.order;
    if (!certificate.splitting.empty()) json["orders_of_splitting"] = certificate.splitting;
    json["order_is_at_least"] = general.is_at_least;
    json["proved"] = certificate.is_proved();
    json["conditions"] = general.conditions;
    json["failures"] = failures_json(general);
    json["error_constant"] = error_constant_json(general);
    json["exceptions"] = exceptions_json(certificate.exceptions);
    json["known_as"] = certificate.known_as;
    json["adjoint"] = certificate.adjoint;
    json["explicit"] = {{"separable", certificate.coupled_separable.empty()},
                        {"general", certificate.coupled_general.empty()}};
    json["coupled"] = {{"separable", coupled_json(certificate.coupled_separable)},
                       {"general", coupled_json(certificate.coupled_general)}};
    json["negative_weights"] = certificate.negative_weights;
    json["nodes_outside"] = certificate.nodes_outside;
    json["conserves"] = {{"linear", certificate.common_weights.holds},
                         {"qCp", certificate.conserves_qCp()},
                         {"quadratic", certificate.conserves_quadratic()}};
    json["linear_stability"] = stability_json(certificate);
    return json;
}

std::string render_json(const Certificate& certificate,
                        const std::optional<SceneStatements>& scene) {
    Json json = certificate_json(certificate);
    add_statements(json, scene);
    return json.dump(2) + "\n";
}

}  // namespace hvi::gen

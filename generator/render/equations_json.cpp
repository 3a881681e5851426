// The equations of a step as JSON.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <utility>

#include "generator/render/equations.hpp"
#include "generator/render/json_entry.hpp"
#include "generator/render/loop_equations.hpp"

namespace hvi::gen {

namespace {

Json texts(const std::vector<Expression>& expressions) {
    Json json = Json::array();
    for (const Expression& expression : expressions) json.push_back(to_text(expression));
    return json;
}

Json matrix_json(const MapEquations& map) {
    Json json = Json::array();
    for (const std::vector<Expression>& row : map.matrix) json.push_back(texts(row));
    return json;
}

/// Appends equations; `mark` stands behind the names on the left.
void append(Json& json, const std::vector<Equation>& equations, std::string_view mark = "") {
    for (const Equation& equation : equations)
        json.push_back(equation.left + std::string(mark) + " = " + to_text(equation.right));
}

void append(Json& json, const std::vector<ImplicitEquation>& equations) {
    for (const ImplicitEquation& equation : equations)
        json.push_back(to_text(equation.left) + " = " + to_text(equation.right));
}

Json stages_json(const GalerkinEquations& equations) {
    Json json = Json::array();
    append(json, equations.positions);
    append(json, equations.conditions);
    append(json, equations.update, "'");
    return json;
}

Json stages_json(const StageEquations& equations) {
    Json json = Json::array();
    append(json, equations.stages);
    append(json, equations.update, "'");
    return json;
}

Json generating_json(const GeneratingEquations& found) {
    return {{"discrete", to_text(found.discrete)},
            {"exact", found.exact ? Json(to_text(*found.exact)) : Json(nullptr)},
            {"gives_map", found.gives_map},
            {"symmetric", found.is_symmetric},
            {"type_one", found.has_type_one},
            {"order_of_difference", found.order_of_difference},
            {"is_at_least", found.is_at_least}};
}

Json text_or_null(const DiscreteSeries::Coefficient& coefficient) {
    return coefficient ? Json(to_text(*coefficient)) : Json(nullptr);
}

Json texts(const std::vector<DiscreteSeries::Coefficient>& coefficients) {
    Json json = Json::array();
    for (const auto& coefficient : coefficients) json.push_back(text_or_null(coefficient));
    return json;
}

/// NOTE: the series has a schema of its own, so that it can be kept apart from the step.
Json series_json(const DiscreteSeries& series) {
    const auto power = [](const std::optional<int>& k) { return k ? Json(*k) : Json(nullptr); };
    return {{"schema", "hvi-series/1"},
            {"terms_exact", texts(series.exact)},
            {"terms_method", texts(series.method)},
            {"first_difference", power(series.first_difference)},
            {"difference", text_or_null(series.difference)},
            {"undecided", power(series.undecided)}};
}

Json values_json(const StepTitle& step) {
    Json values = Json::object();
    for (const Parameter& known : step.values) values[known.name] = to_text(known.value);
    return values;
}

/// Returns the terms, and their ranges: everywhere, or where each of these ranges has its index.
Json slope_json(const ElementSlope& slope) {
    Json terms = Json::array();
    for (const LoopTermOfSlope& term : slope) {
        Json where = Json::array();
        for (const Loop& range : term.where) where.push_back(to_text(range));
        terms.push_back({{"value", to_text(term.value)}, {"where", std::move(where)}});
    }
    return terms;
}

}  // namespace

std::string render_json(const LoopEquations& step) {
    Json derivatives = Json::object();
    for (const auto& [family, slope] : named_slopes(step))
        derivatives[slope_name(family, step.gradient.indices)] = slope_json(slope);
    Json json;
    json["schema"] = "hvi-scheme-loops/1";
    json["name"] = step.name;
    json["hamiltonian"] = to_text(step.hamiltonian);
    json["coordinates"] = texts(step.coordinates);
    json["momenta"] = texts(step.momenta);
    json["indices"] = step.gradient.indices;
    json["parameters"] = step.parameters;
    json["values"] = values_json(step);
    json["stages"] = stages_json(step.stages);
    json["explicit"] = step.stages.is_explicit;
    json["exact"] = step.stages.is_exact;
    json["derivatives"] = std::move(derivatives);
    return json.dump(2) + "\n";
}

std::string render_json(const LagrangianEquations& step) {
    Json legendre = Json::array(), stages = Json::array(), update = Json::array();
    append(legendre, step.legendre);
    append(stages, step.positions);
    append(stages, step.conditions);
    append(update, step.update, "'");
    Json json;
    json["schema"] = "hvi-scheme-lagrangian/1";
    json["name"] = step.name;
    json["lagrangian"] = to_text(step.lagrangian);
    json["coordinates"] = step.coordinates;
    json["velocities"] = step.velocities;
    json["momenta"] = step.momenta;
    json["parameters"] = step.parameters;
    json["values"] = values_json(step);
    if (!step.basis.empty()) json["basis"] = texts(step.basis);
    json["legendre"] = std::move(legendre);
    json["stages"] = std::move(stages);
    json["update"] = std::move(update);
    json["exact"] = step.is_exact;
    return json.dump(2) + "\n";
}

std::string render_json(const StepEquations& step) {
    Json json;
    json["schema"] = "hvi-scheme/1";
    json["name"] = step.name;
    json["hamiltonian"] = to_text(step.hamiltonian);
    json["variables"] = variables(step);
    json["parameters"] = step.parameters;
    json["values"] = values_json(step);
    if (!step.basis.empty()) json["basis"] = texts(step.basis);
    json["map"] = step.map ? matrix_json(*step.map) : Json(nullptr);
    json["offset"] = step.map ? texts(step.map->offset) : Json(nullptr);
    json["stages"] = nullptr;
    json["explicit"] = nullptr;
    json["exact"] = true;
    if (step.stages) {
        json["stages"] = stages_json(*step.stages);
        json["explicit"] = step.stages->is_explicit;
        json["exact"] = step.stages->is_exact;
    }
    if (step.at_nodes) {
        json["stages"] = stages_json(*step.at_nodes);
        json["explicit"] = false;
        json["exact"] = step.at_nodes->is_exact;
    }
    if (step.generating) json["generating"] = generating_json(*step.generating);
    if (step.series) json["series"] = series_json(*step.series);
    return json.dump(2) + "\n";
}

}  // namespace hvi::gen

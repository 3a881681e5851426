// A method as JSON: schema hvi-tableau/1 for tableaux, hvi-galerkin/1 for the general form.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <utility>

#include "generator/render/entry.hpp"
#include "generator/render/json_entry.hpp"
#include "generator/render/render.hpp"

namespace hvi::gen {

namespace {

Json text_or_null(const std::optional<std::string>& text) {
    return text ? Json(*text) : Json(nullptr);
}

Json part_json(const Part& part, int digits) {
    Json json = Json::array();
    for (const NumberVector& row : part.rows) {
        Json entries = Json::array();
        for (const Number& number : row) entries.push_back(entry_json(number, digits));
        json.push_back(part.is_vector ? std::move(entries.front()) : std::move(entries));
    }
    return json;
}

Json basis_json(const Provenance& provenance) {
    Json json = Json::array();
    for (const Expression& function : provenance.basis) json.push_back(to_text(function));
    return json;
}

void add(Json& json, const std::vector<Part>& parts, int digits) {
    for (const Part& part : parts) json[std::string(part.name)] = part_json(part, digits);
}

}  // namespace

Json entry_json(const Number& number, int digits) {
    const Entry entry = make_entry(number, digits);
    Json json;
    json["exact"] = text_or_null(entry.exact_text());
    json["decimal"] = text_or_null(entry.decimal);
    json["double"] = text_or_null(entry.hex);
    return json;
}

std::string render_json(const Tableau& tableau, int digits) {
    Json json;
    json["schema"] = "hvi-tableau/1";
    json["name"] = tableau.provenance.name;
    json["stages"] = tableau.stages();
    json["parameters"] = tableau.parameters;
    json["basis"] = basis_json(tableau.provenance);
    add(json, parts(tableau), digits);
    return json.dump(2) + "\n";
}

std::string render_json(const GalerkinRule& rule, int digits) {
    Json json;
    json["schema"] = "hvi-galerkin/1";
    json["name"] = rule.provenance.name;
    json["functions"] = rule.functions();
    json["nodes"] = rule.nodes();
    json["parameters"] = rule.parameters;
    json["basis"] = basis_json(rule.provenance);
    add(json, parts(rule), digits);
    add(json["nystroem"], nystrom_parts(rule), digits);
    return json.dump(2) + "\n";
}

}  // namespace hvi::gen

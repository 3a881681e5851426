// A tableau as JSON, schema hvi-tableau/1.
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
    json["basis"] = Json::array();
    for (const Expression& function : tableau.provenance.basis)
        json["basis"].push_back(to_text(function));
    for (const Part& part : parts(tableau)) json[std::string(part.name)] = part_json(part, digits);
    return json.dump(2) + "\n";
}

}  // namespace hvi::gen

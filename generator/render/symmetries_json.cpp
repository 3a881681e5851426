// Symmetries as JSON, schema hvi-symmetries/1.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/render/json_entry.hpp"
#include "generator/render/symmetries.hpp"

namespace hvi::gen {

namespace {

Json generator_json(const SceneSymmetries& found, const AffineSymmetry& symmetry) {
    Json json = Json::object();
    for (std::size_t i = 0; i < found.coordinates.size(); ++i) {
        const std::string text = to_text(symmetry.generator[i]);
        if (text != "0") json[found.coordinates[i]] = text;
    }
    return json;
}

/// NOTE: brackets count from 1, as J1 does.
Json algebra_json(const std::optional<SymmetryAlgebra>& algebra) {
    if (!algebra) return nullptr;
    Json constants = algebra->constants ? Json::array() : Json(nullptr);
    for (const StructureConstant& constant :
         algebra->constants.value_or(std::vector<StructureConstant>{}))
        constants.push_back({{"i", constant.i + 1},
                             {"j", constant.j + 1},
                             {"k", constant.k + 1},
                             {"value", to_text(constant.value)}});
    return {{"name", algebra->name.empty() ? Json(nullptr) : Json(algebra->name)},
            {"structure_constants", constants}};
}

Json conserved_json(Vanishing conserved) {
    return conserved == Vanishing::unknown ? Json(nullptr) : Json(conserved == Vanishing::proved);
}

}  // namespace

std::string render_json(const SceneSymmetries& found) {
    Json json;
    json["schema"] = "hvi-symmetries/1";
    json["name"] = found.name;
    json["side"] = found.side == Side::hamiltonian ? "hamiltonian" : "lagrangian";
    json["regular"] = found.rank ? Json(found.is_regular()) : Json(nullptr);
    json["rank"] = found.rank ? Json(*found.rank) : Json(nullptr);
    json["degrees_of_freedom"] = found.degrees_of_freedom;
    json["complete"] = found.affine.doubt.empty();
    json["doubt"] = found.affine.doubt.empty() ? Json(nullptr) : Json(found.affine.doubt);
    json["symmetries"] = Json::array();
    for (const AffineSymmetry& symmetry : found.affine.basis)
        json["symmetries"].push_back({{"generator", generator_json(found, symmetry)},
                                      {"momentum_map", to_text(symmetry.momentum_map)}});
    json["algebra"] = algebra_json(found.affine.algebra);
    json["invariants"] = Json::array();
    for (const ConservedQuantity& invariant : found.invariants) {
        json["invariants"].push_back({{"name", invariant.name},
                                      {"conserved", conserved_json(invariant.finding.conserved)},
                                      {"bracket", to_text(invariant.finding.bracket)}});
        if (invariant.is_approximate) json["invariants"].back()["approximate"] = true;
    }
    json["fields"] = Json::array();
    for (const ConservedQuantity& field : found.fields)
        json["fields"].push_back({{"name", field.name},
                                  {"momentum_map", to_text(field.expression)},
                                  {"affine", field.finding.is_momentum_map},
                                  {"conserved", conserved_json(field.finding.conserved)},
                                  {"bracket", to_text(field.finding.bracket)}});
    return json.dump(2) + "\n";
}

}  // namespace hvi::gen

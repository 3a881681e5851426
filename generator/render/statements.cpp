// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/render/statements.hpp"

#include "generator/render/certificate_json.hpp"
#include "generator/render/named_lines.hpp"

namespace hvi::gen {

namespace {

/// Returns what is said of a quantity that is kept without exception.
std::string exception_to(const Statement& statement, const SceneStatements& scene) {
    return statement.keeping == Keeping::kept ? scene.exception : "";
}

/// Returns null where the motion is not known to conserve the quantity, or where only runs tell.
Json kept_json(const Statement& statement, const SceneStatements& scene) {
    const Keeping keeping = statement.keeping;
    const bool is_said = keeping != Keeping::unknown && keeping != Keeping::measured;
    const bool is_kept = keeping == Keeping::kept && scene.exception.empty();
    return is_said ? Json(is_kept) : Json(nullptr);
}

/// Adds the verdict to what names a quantity.
Json statement_json(Json json, const Statement& statement, const SceneStatements& scene) {
    json["kept"] = kept_json(statement, scene);
    json["reason"] = statement.reason + exception_to(statement, scene);
    return json;
}

}  // namespace

std::string_view keeping_text(Keeping keeping) {
    switch (keeping) {
    case Keeping::kept: return "conserved";
    case Keeping::not_in_general: return "not conserved exactly by this method";
    case Keeping::measured: return "measured, not claimed";
    case Keeping::not_conserved: return "its bracket with H is not zero as a function of q and p";
    case Keeping::unknown: break;
    }
    return "not known";
}

void write_statements(NamedLines& lines, const std::optional<SceneStatements>& scene) {
    if (!scene) return;
    lines.blank();
    lines.title("Of " + scene->name);
    lines.blank();
    if (!scene->found) {
        lines.line("symmetries", "not looked for: " + scene->left_out);
        lines.line("", "`hvi-gen symmetries` looks for them for as long as it takes");
        return;
    }
    const std::size_t maps = scene->found->momentum_maps.size();
    for (std::size_t i = 0; i < scene->statements.size(); ++i) {
        const Statement& statement = scene->statements[i];
        const std::string name = i < maps ? to_text(statement.expression) : statement.name;
        const bool is_first = i == 0 || i == maps;
        lines.line(!is_first  ? ""
                   : i < maps ? "momentum maps"
                              : "invariants",
                   name + ": " + std::string(keeping_text(statement.keeping)) +
                       exception_to(statement, *scene));
        lines.line("", "(" + statement.reason + ")");
    }
    if (scene->statements.empty()) lines.line("keeps", "nothing is known to be conserved");
}

void add_statements(Json& json, const std::optional<SceneStatements>& scene) {
    if (!scene) return;
    json["scene"] = scene->name;
    json["left_out"] = scene->found ? Json(nullptr) : Json(scene->left_out);
    if (!scene->found) {
        for (const char* name : {"momentum_maps", "invariants", "fields", "energy"})
            json[name] = nullptr;
        return;
    }
    json["momentum_maps"] = Json::array();
    json["invariants"] = Json::array();
    json["fields"] = Json::array();
    json["energy"] = nullptr;
    const std::size_t maps = scene->found->momentum_maps.size();
    const std::size_t invariants = maps + scene->found->invariants.size();
    const std::size_t fields = invariants + scene->found->fields.size();
    for (std::size_t i = 0; i < scene->statements.size(); ++i) {
        const Statement& statement = scene->statements[i];
        if (i < maps)
            json["momentum_maps"].push_back(statement_json(
                {{"momentum_map", to_text(statement.expression)}}, statement, *scene));
        else if (i < invariants)
            json["invariants"].push_back(
                statement_json({{"name", statement.name}}, statement, *scene));
        else if (i < fields)
            json["fields"].push_back(statement_json({{"name", statement.name}}, statement, *scene));
        else
            json["energy"] = statement_json({}, statement, *scene);
    }
}

}  // namespace hvi::gen

// An audit as JSON, schema hvi-check/1 with an object `audit`.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/render/certificate.hpp"
#include "generator/render/certificate_json.hpp"

namespace hvi::gen {

namespace {

constexpr int digits_of_audit = 50;

Json is_json(const std::optional<Rebuilt>& rebuilt) {
    const bool is = rebuilt && rebuilt->is_method() && rebuilt->is_right();
    return is ? Json(rebuilt->tableau->provenance.title()) : Json(nullptr);
}

Json meant_json(const std::optional<Rebuilt>& rebuilt) {
    if (!rebuilt) { return nullptr; }
    const auto matrix = [](Matrix which) { return which == Matrix::A ? "A" : "A_tilde"; };
    const auto& tableau = rebuilt->tableau;
    Json json;
    json["method"] = tableau ? Json(tableau->provenance.title()) : Json(nullptr);
    json["A"] = tableau ? Json(matrix(rebuilt->A)) : Json(nullptr);
    json["A_tilde"] = tableau ? Json(matrix(rebuilt->A_tilde)) : Json("partner of A");
    json["compared"] = rebuilt->compared;
    return json;
}

Json wrong_json(const std::optional<Rebuilt>& rebuilt) {
    if (!rebuilt) { return nullptr; }
    Json json = Json::array();
    for (const WrongEntry& entry : rebuilt->wrong) {
        json.push_back({{"entry", entry.place},
                        {"given", entry.given},
                        {"right", entry_json(entry.right, digits_of_audit)}});
    }
    return json;
}

Json as_written_json(const std::optional<Properties>& properties) {
    if (!properties) { return nullptr; }
    return {{"symplectic", properties->symplectic.holds},
            {"symmetric", properties->symmetric.holds},
            {"runge_kutta", properties->runge_kutta.holds},
            {"order", properties->orders.general.order},
            {"order_separable", properties->orders.separable.order},
            {"order_nystrom", properties->orders.nystrom.order}};
}

Json defect_json(const std::optional<SymplecticDefect>& defect) {
    if (!defect) { return nullptr; }
    return {{"i", defect->i + 1},
            {"j", defect->j ? Json(*defect->j + 1) : Json(nullptr)},
            {"residual", entry_json(defect->residual, digits_of_audit)}};
}

Json audit_json(const Audit& audit) {
    const auto& rebuilt = audit.rebuilt;
    Json json;
    json["is"] = is_json(rebuilt);
    json["meant"] = meant_json(rebuilt);
    json["wrong"] = wrong_json(rebuilt);
    json["trusted_digits"] = rebuilt && rebuilt->places ? Json(*rebuilt->places) : Json(nullptr);
    json["within_digits"] = audit.certificate.within_digits;
    json["rounded"] = audit.rounded;
    json["digits"] = audit.rounded > 0 ? Json(audit.digits) : Json(nullptr);
    json["as_written"] = as_written_json(audit.as_written);
    json["symplectic_defect"] = defect_json(audit.defect);
    json["row_sums"] = {{"A", audit.c_is_sum_of_A.holds},
                        {"A_tilde", audit.c_is_sum_of_A_tilde.holds}};
    return json;
}

}  // namespace

std::string render_json(const Audit& audit, const std::optional<SceneStatements>& scene) {
    Json json = certificate_json(audit.certificate);
    json["audit"] = audit_json(audit);
    add_statements(json, scene);
    return json.dump(2) + "\n";
}

}  // namespace hvi::gen

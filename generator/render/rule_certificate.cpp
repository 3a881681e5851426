// A certificate of the general Galerkin form.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "generator/render/certificate.hpp"
#include "generator/render/certificate_json.hpp"
#include "generator/render/named_lines.hpp"

namespace hvi::gen {

std::string render_text(const RuleCertificate& certificate,
                        const std::optional<SceneStatements>& scene) {
    NamedLines lines;
    lines.title(certificate.name.empty() ? certificate.origin : certificate.name);
    lines.blank();
    lines.line("form", fmt::format("general Galerkin (4.6): {} function{}, {} nodes; for "
                                   "H = p^T K p/2 + U(q)",
                                   certificate.functions, certificate.functions == 1 ? "" : "s",
                                   certificate.stages));
    lines.line("order", order_text(certificate.nystrom, certificate));
    write_exceptions(lines, certificate.exceptions);
    write_failures(lines, certificate.nystrom);
    lines.blank();
    lines.line("symplectic", yes_or_no(certificate.symplectic, certificate));
    lines.line("self-adjoint", yes_or_no(certificate.symmetric, certificate));
    lines.line("conserves", "linear invariants and q^T C p");
    lines.line("explicit", certificate.is_explicit ? "yes" : "no");
    write_signs(lines, certificate);
    lines.blank();
    write_oscillator(lines, certificate);
    lines.blank();
    lines.title(certificate.is_proved() ? "All of it is proved."
                                        : "Some of it rests on enclosures of 50 digits.");
    write_statements(lines, scene);
    return lines.text();
}

std::string render_json(const RuleCertificate& certificate,
                        const std::optional<SceneStatements>& scene) {
    const OrderConditions& nystrom = certificate.nystrom;
    Json json;
    json["schema"] = "hvi-check/1";
    json["name"] = certificate.name;
    json["stages"] = certificate.stages;
    json["functions"] = certificate.functions;
    json["parameters"] = certificate.parameters;
    json["consistent"] = nystrom.order >= 1;
    json["symplectic"] = certificate.symplectic.holds;
    json["symmetric"] = certificate.symmetric.holds;
    json["runge_kutta"] = nullptr;
    json["order"] = nullptr;
    json["order_separable"] = nullptr;
    json["order_nystrom"] = nystrom.order;
    json["order_is_at_least"] = nystrom.is_at_least;
    json["proved"] = certificate.is_proved();
    json["conditions"] = nystrom.conditions;
    json["failures"] = failures_json(nystrom);
    json["error_constant"] = error_constant_json(nystrom);
    json["exceptions"] = exceptions_json(certificate.exceptions);
    json["explicit"] = {
        {"nystrom", certificate.is_explicit}, {"separable", nullptr}, {"general", false}};
    json["negative_weights"] = certificate.negative_weights;
    json["nodes_outside"] = certificate.nodes_outside;
    json["conserves"] = {
        {"linear", true}, {"qCp", certificate.symplectic.holds}, {"quadratic", false}};
    json["linear_stability"] = stability_json(certificate);
    add_statements(json, scene);
    return json.dump(2) + "\n";
}

}  // namespace hvi::gen

// A certificate of counted sweeps.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "generator/render/certificate.hpp"
#include "generator/render/certificate_json.hpp"
#include "generator/render/named_lines.hpp"

namespace hvi::gen {

namespace {

/// The families in the order in which they are written, with their names there.
struct NamedFamily {
    const char* name;
    const char* key;
    const std::optional<SweptFamily>* family;
    int from_extrapolated;  ///< the power of h up to which steps from extrapolated slopes agree
};
std::vector<NamedFamily> families_of(const SweptCertificate& certificate) {
    const int any = power_for_any(certificate);
    return {{"", "general", &certificate.in_turn, any},
            {"  at once", "at_once", &certificate.at_once, any},
            {"  separable", "separable", &certificate.separable, power_for_separable(certificate)},
            {"  Nystrom", "nystrom", &certificate.nystrom, power_for_nystrom(certificate)}};
}

std::string power_text(const PowerOfStep& found) {
    return fmt::format("up to h^{}{}", found.power, found.is_at_least ? " at least" : "");
}

constexpr const char* why_not = "not looked at: not all stages are iterated";

/// Writes a line for each family. `text` is that of a family that is looked at.
void write_families(NamedLines& lines, std::string_view what, const SweptCertificate& certificate,
                    const auto& text) {
    for (const NamedFamily& each : families_of(certificate)) {
        lines.line(*each.name == 0 ? what : each.name, *each.family ? text(each) : why_not);
    }
}

void write_start(NamedLines& lines, const SweptCertificate& certificate) {
    if (!certificate.extrapolated) { return; }
    const auto& [steps, degree] = *certificate.extrapolated;
    lines.line("extrapolated",
               fmt::format("slopes of the {} before, by a polynomial of degree {}, have errors of "
                           "h^{}; sweeps from them agree, and are symplectic, at least",
                           steps == 1 ? "step" : "two steps", degree, certificate.starting_order));
    for (const NamedFamily& each : families_of(certificate)) {
        if (!*each.family || each.family == &certificate.at_once) { continue; }
        lines.line(*each.name == 0 ? "  any H" : each.name,
                   fmt::format("up to h^{}", each.from_extrapolated));
    }
    lines.blank();
}

/// Returns ` - 0.25*z^4`.
std::string term_text(const Term& term) {
    const std::string coefficient = short_decimal(term.coefficient);
    const std::string signed_one = term.coefficient.has_parameters() ? " + (" + coefficient + ")"
                                   : coefficient.front() == '-'      ? " - " + coefficient.substr(1)
                                                                     : " + " + coefficient;
    return fmt::format("{}*z^{}", signed_one, term.power);
}

void write_map(NamedLines& lines, const SweptCertificate& certificate) {
    if (!certificate.nystrom) {
        lines.line("oscillator", why_not);
        return;
    }
    if (certificate.growth) {
        lines.line("energy", fmt::format("of the oscillator, times 1{} + ... in a step",
                                         term_text(*certificate.growth)));
    }
    write_oscillator(lines, certificate);
}

Json power_json(const std::optional<SweptFamily>& family, PowerOfStep SweptFamily::*power) {
    if (!family) { return nullptr; }
    const PowerOfStep& found = (*family).*power;
    return {{"power", found.power}, {"is_at_least", found.is_at_least}};
}

Json order_json(const std::optional<SweptFamily>& family) {
    return family ? Json(family->order.order) : Json(nullptr);
}

/// Returns the order for all H that are looked at.
int order_of_any(const SweptCertificate& certificate) {
    const auto& family = certificate.in_turn ? certificate.in_turn : certificate.separable;
    return family->order.order;
}

Json sweeps_json(const SweptCertificate& certificate) {
    Json json;
    json["start"] = "slopes at the start of the step";
    json["order_at_once"] = order_json(certificate.at_once);
    for (const NamedFamily& each : families_of(certificate)) {
        json["symplectic_up_to"][each.key] = power_json(*each.family, &SweptFamily::symplectic);
        json["agrees_up_to"][each.key] = power_json(*each.family, &SweptFamily::agrees);
    }
    json["growth"] = nullptr;
    if (const auto& growth = certificate.growth) {
        json["growth"] = {{"power", growth->power},
                          {"coefficient", entry_json(growth->coefficient, 50)}};
    }
    json["extrapolated"] = nullptr;
    if (const auto& extrapolated = certificate.extrapolated) {
        Json powers;
        for (const NamedFamily& each : families_of(certificate)) {
            powers[each.key] = *each.family ? Json(each.from_extrapolated) : Json(nullptr);
        }
        json["extrapolated"] = {{"steps", extrapolated->steps},
                                {"degree", extrapolated->degree},
                                {"error", certificate.starting_order},
                                {"symplectic_at_least_up_to", powers}};
    }
    return json;
}

}  // namespace

std::string render_text(const SweptCertificate& certificate,
                        const std::optional<SceneStatements>& scene) {
    NamedLines lines;
    lines.title(certificate.name.empty() ? certificate.origin : certificate.name);
    lines.blank();
    lines.line("sweeps",
               fmt::format("{} in each step, from the slopes at its start", certificate.sweeps));
    write_families(lines, "order", certificate, [&](const NamedFamily& each) {
        return order_text((*each.family)->order, certificate);
    });
    if (certificate.in_turn) { write_failures(lines, certificate.in_turn->order); }
    lines.blank();
    write_families(lines, "symplectic", certificate,
                   [](const NamedFamily& each) { return power_text((*each.family)->symplectic); });
    write_families(lines, "agrees", certificate, [](const NamedFamily& each) {
        return power_text((*each.family)->agrees) +
               (*each.name == 0 ? " with steps to round-off" : "");
    });
    lines.line("conserves", "linear invariants of q alone and of p alone");
    lines.line("explicit", "for every H");
    lines.blank();
    write_start(lines, certificate);
    write_map(lines, certificate);
    lines.blank();
    lines.title(certificate.is_proved() ? "All of it is proved."
                                        : "Some of it rests on enclosures of 50 digits.");
    write_statements(lines, scene);
    return lines.text();
}

std::string render_json(const SweptCertificate& certificate,
                        const std::optional<SceneStatements>& scene) {
    const OrderConditions* const general =
        certificate.in_turn ? &certificate.in_turn->order : nullptr;
    Json json;
    json["schema"] = "hvi-check/1";
    json["name"] = certificate.name;
    json["sweeps"] = certificate.sweeps;
    json["stages"] = certificate.stages;
    json["parameters"] = certificate.parameters;
    json["consistent"] = order_of_any(certificate) >= 1;
    json["symplectic"] = false;
    json["symmetric"] = false;
    json["runge_kutta"] = false;
    json["order"] = order_json(certificate.in_turn);
    json["order_separable"] = order_json(certificate.separable);
    json["order_nystrom"] = order_json(certificate.nystrom);
    json["order_is_at_least"] = general != nullptr ? Json(general->is_at_least) : Json(nullptr);
    json["proved"] = certificate.is_proved();
    json["conditions"] = general != nullptr ? Json(general->conditions) : Json(nullptr);
    json["failures"] = general != nullptr ? failures_json(*general) : Json(nullptr);
    json["error_constant"] = general != nullptr ? error_constant_json(*general) : Json(nullptr);
    json["explicit"] = {{"separable", true}, {"general", true}};
    json["conserves"] = {{"linear", false}, {"qCp", false}, {"quadratic", false}};
    json["counted_sweeps"] = sweeps_json(certificate);
    json["linear_stability"] = stability_json(certificate);
    add_statements(json, scene);
    return json.dump(2) + "\n";
}

}  // namespace hvi::gen

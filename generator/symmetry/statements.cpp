// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symmetry/statements.hpp"

#include <algorithm>
#include <variant>

#include "generator/exact/methods/properties.hpp"
#include "generator/exact/methods/rule_properties.hpp"

namespace hvi::gen {

namespace {

/// Returns why a method in natural charts of rotating bodies keeps a quantity; empty where it need
/// not.
std::string reason_of_bodies(const QuantityFinding& finding, const KeepingFacts& method) {
    if (!finding.is_momentum_map || !method.symplectic.holds) return "";
    return "the action commutes with natural charts, and the method is symplectic";
}

/// Returns why a method keeps a quantity; empty where it need not.
std::string reason_to_keep(const QuantityFinding& finding, const KeepingFacts& method) {
    const auto& quadratic = finding.quadratic;
    if (finding.is_momentum_map && method.symplectic.holds)
        return "the action is affine, and the method interpolates in a vector space";
    if (method.is_general_form || !quadratic) return "";
    if (quadratic->is_linear && method.common_weights.holds) return "linear, and b = b~";
    if (!method.symplectic.holds) return "";
    if (!quadratic->has_squares) return "q^T C p and linear terms, and the method is symplectic";
    if (method.runge_kutta.holds) return "quadratic, and A = A~ of a symplectic method";
    if (quadratic->squares_stay) return "what is quadratic in q alone or in p alone stays as it is";
    return "";
}

/// Returns why a method need not keep a quantity.
std::string reason_not_to(const QuantityFinding& finding, const KeepingFacts& method) {
    if (!finding.quadratic) return "not quadratic in q and p";
    if (method.is_general_form) return "no momentum map of an affine action";
    if (!method.symplectic.holds) return "the method is not symplectic";
    return "quadratic in q alone or in p alone, and A differs from A~";
}

constexpr const char* not_known = "it is not known whether the motion conserves it";

Statement statement(const ConservedQuantity& quantity, const KeepingFacts& method,
                    bool has_rotations) {
    Statement result{quantity.name, quantity.expression, Keeping::unknown, ""};
    switch (quantity.finding.conserved) {
    case Vanishing::unknown: result.reason = not_known; return result;
    case Vanishing::refuted:
        result.keeping = Keeping::not_conserved;
        result.reason = not_zero(quantity);
        return result;
    case Vanishing::proved: break;
    }
    result.reason = has_rotations ? reason_of_bodies(quantity.finding, method)
                                  : reason_to_keep(quantity.finding, method);
    result.keeping = result.reason.empty() ? Keeping::not_in_general : Keeping::kept;
    if (result.reason.empty() && quantity.kind == ConservedQuantity::Kind::field) {
        result.keeping = Keeping::measured;
        result.reason = "the symmetry is not affine, and nothing is claimed of the method";
    }
    if (result.reason.empty())
        result.reason = has_rotations ? "no momentum map of a symmetry that is found"
                                      : reason_not_to(quantity.finding, method);
    return result;
}

/// Marks a quantity as kept where all its parts are kept.
void look_at_parts(std::vector<Statement>& all, std::size_t number,
                   const std::vector<std::size_t>& parts) {
    Statement& whole = all[number];
    const bool kept = std::all_of(parts.begin(), parts.end(), [&](std::size_t part) {
        return all[part].keeping == Keeping::kept;
    });
    if ((whole.keeping != Keeping::not_in_general && whole.keeping != Keeping::measured) ||
        parts.empty() || !kept)
        return;
    whole.keeping = Keeping::kept;
    whole.reason = "made of";
    for (const std::size_t part : parts)
        whole.reason += (part == parts.front() ? " " : ", ") + all[part].name;
}

/// Returns the energy as a quantity, which the motion conserves.
ConservedQuantity energy_of_parts(const SceneSymmetries& found) {
    if (found.energy) return *found.energy;
    ConservedQuantity energy{
        ConservedQuantity::Kind::energy, "energy", Expression::symbol("energy"), {}, {}};
    energy.finding.conserved = Vanishing::proved;
    return energy;
}

/// Returns what splittings keep.
Statement statement_on_flows(const ConservedQuantity& quantity, const KeptByParts& parts,
                             const BracketsWithParts& brackets) {
    Statement result{quantity.name, quantity.expression, Keeping::unknown, not_known};
    const Vanishing conserved = quantity.finding.conserved;
    const std::string refuted = names_of_parts(parts, brackets, Vanishing::refuted);
    if (is_kept_by_all(brackets)) {
        result.keeping = Keeping::kept;
        result.reason = "the flow of each part of H keeps it";
    } else if (conserved == Vanishing::refuted) {
        result.keeping = Keeping::not_conserved;
        result.reason = not_zero(quantity);
    } else if (conserved == Vanishing::proved && !refuted.empty()) {
        result.keeping = Keeping::not_in_general;
        result.reason = "its bracket is not zero with " + refuted;
    } else if (conserved == Vanishing::proved) {
        result.keeping = Keeping::measured;
        result.reason = "it is not seen whether its bracket is zero with " +
                        names_of_parts(parts, brackets, Vanishing::unknown);
    }
    return result;
}

std::vector<Statement> of_flows(const SceneSymmetries& found, const KeptByParts& parts) {
    std::vector<Statement> result;
    const std::vector<const ConservedQuantity*> all = quantities_of(found);
    for (std::size_t i = 0; i < all.size(); ++i)
        result.push_back(statement_on_flows(*all[i], parts, parts.brackets[i]));
    if (!found.depends_on_time)
        result.push_back(statement_on_flows(energy_of_parts(found), parts, parts.brackets.back()));
    return result;
}

/// Returns why the method makes no steps of such an H; empty where it does.
std::string obstacle_to_steps(const SceneSymmetries& found, const KeepingFacts& method) {
    const bool is_stepped = !method.is_general_form || found.side == Side::lagrangian ||
                            !found.rank || found.is_regular();
    return is_stepped ? method.obstacle
                      : "d2H/dp2 is singular, and the general form makes no steps of such an H";
}

}  // namespace

KeepingFacts keeping_facts(const DerivedMethod& method) {
    if (const auto* tableau = std::get_if<Tableau>(&method))
        return {is_symplectic(*tableau), has_common_weights(*tableau), is_runge_kutta(*tableau),
                false};
    return {is_symplectic(std::get<GalerkinRule>(method)), {}, {false, true}, true};
}

std::vector<Statement> statements(const SceneSymmetries& found, const KeepingFacts& method) {
    if (method.parts) return of_flows(found, *method.parts);
    std::vector<const ConservedQuantity*> all = quantities_of(found);
    if (found.energy) all.push_back(&*found.energy);
    std::vector<Statement> result;
    for (const ConservedQuantity* quantity : all)
        result.push_back(statement(*quantity, method, found.rotations > 0));
    if (const std::string obstacle = obstacle_to_steps(found, method); !obstacle.empty()) {
        for (Statement& each : result) {
            each.keeping = Keeping::unknown;
            each.reason = obstacle;
        }
        return result;
    }
    for (std::size_t i = 0; i < all.size(); ++i) look_at_parts(result, i, all[i]->finding.made_of);
    if (!found.energy && !found.depends_on_time)
        result.push_back({"energy", Expression::symbol("energy"), Keeping::not_in_general,
                          found.rotations > 0 ? "it is no momentum map"
                                              : "not seen to be quadratic in q and p"});
    return result;
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/certify/rule_certificate.hpp"

#include <algorithm>

#include "generator/exact/methods/galerkin_form.hpp"
#include "generator/exact/methods/projected_stages.hpp"
#include "generator/exact/methods/splitting_orders.hpp"
#include "generator/exact/numbers/budget.hpp"

namespace hvi::gen {
namespace {

/// Whether, of n_ij and n_ji, one is always zero.
bool is_explicit(const GalerkinRule& rule) {
    for (std::size_t i = 0; i < rule.nodes(); ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            if (!rule.n[i][j].is_zero() && !rule.n[j][i].is_zero()) { return false; }
        }
    }
    return true;
}

}  // namespace

bool RuleCertificate::is_proved() const {
    return Findings::is_proved() && symplectic.proved && symmetric.proved && nystrom.proved;
}

RuleCertificate certify(const GalerkinRule& rule, int max_order) {
    RuleCertificate result;
    result.name = rule.provenance.name;
    result.origin = rule.provenance.origin;
    result.parameters = rule.parameters;
    result.stages = rule.nodes();
    result.functions = rule.functions();
    result.symplectic = is_symplectic(rule);
    result.symmetric = is_symmetric(rule);
    result.is_explicit = is_explicit(rule);
    result.nystrom = nystrom_order(rule, max_order);
    set_signs(result, rule.c, rule.b);
    if (!takes_long(rule)) { set_oscillator(result, rule); }
    return result;
}

AnyCertificate certify(const Method& method, int max_order) {
    try {
        AnyCertificate result = std::visit(
            [&](const auto& derived) -> AnyCertificate { return certify(derived, max_order); },
            derive_any(method));
        const auto look = [&](auto& certificate, const OrderConditions& generic) {
            if (certificate.parameters.empty()) { return; }
            certificate.exceptions = exceptions(method, generic, max_order);
        };
        if (auto* of_tableau = std::get_if<Certificate>(&result)) {
            look(*of_tableau, of_tableau->orders.general);
            if (!method.splitting.empty()) {
                of_tableau->splitting = on_new_ground([&](const Ground& ground) {
                    return splitting_orders(splitting(ground, method.splitting));
                });
            }
        } else {
            auto& of_rule = std::get<RuleCertificate>(result);
            look(of_rule, of_rule.nystrom);
        }
        return result;
    } catch (const TooLarge& error) {
        throw MathError(error.what(), whole(method.basis.source), error.help());
    }
}

}  // namespace hvi::gen

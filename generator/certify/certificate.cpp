// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/certify/certificate.hpp"

#include <utility>

#include "generator/certify/known.hpp"
#include "generator/exact/numbers/budget.hpp"
#include "generator/exact/numbers/rounded.hpp"
#include "generator/stages/stage_graph.hpp"

namespace hvi::gen {
namespace {

bool is_negative(const Number& number) { return !number.has_parameters() && number.sign() < 0; }

std::vector<std::size_t> negative(const NumberVector& b, const NumberVector& b_tilde) {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < b.size(); ++i) {
        if (is_negative(b[i]) || is_negative(b_tilde[i])) { result.push_back(i + 1); }
    }
    return result;
}

std::vector<std::size_t> outside(const NumberVector& nodes) {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i].has_parameters()) { continue; }
        const bool is_outside = nodes[i].sign() < 0 || (Number(1) - nodes[i]).sign() < 0;
        if (is_outside) { result.push_back(i + 1); }
    }
    return result;
}

/// `Method` is Tableau, PartitionedMethod or RoundedMethod.
template <class Method>
Properties properties_of(const Method& method, int max_order) {
    return {is_symplectic(method), is_symmetric(method), is_runge_kutta(method),
            has_common_weights(method), orders(method, max_order)};
}

/// Returns the method with enclosures of numbers that are made of decimals.
RoundedMethod rounded_method(const Tableau& tableau) {
    constexpr int lost = 4;  // in products and sums
    const DecimalDigits digits{tableau.digits, -tableau.digits};
    const PartitionedMethod written = partitioned_method(tableau);
    PartitionedMethod enclosed = written;
    const auto widen = [&](NumberVector& row) {
        for (Number& number : row) { number = unrounded(number, digits, {}); }
    };
    widen(enclosed.b);
    widen(enclosed.b_tilde);
    for (NumberMatrix* rows : {&enclosed.A, &enclosed.A_tilde}) {
        for (NumberVector& row : *rows) { widen(row); }
    }
    return {written, enclosed, bits_for(tableau.digits - lost)};
}

void set_map(Findings& findings, const auto& method) {
    try {
        findings.oscillator = oscillator_map(method);
    } catch (const TooLarge&) { return; }
    if (findings.parameters.empty()) {
        findings.stability = linear_stability(*findings.oscillator, stability_limit);
    }
}

}  // namespace

bool Properties::is_proved() const {
    const bool orders_proved =
        orders.general.proved && orders.separable.proved && orders.nystrom.proved;
    return symplectic.proved && symmetric.proved && runge_kutta.proved && common_weights.proved &&
           orders_proved;
}

bool Findings::is_proved() const {
    return !within_digits && (!oscillator || oscillator->proved) &&
           (!stability || stability->proved);
}

bool Certificate::is_proved() const { return Properties::is_proved() && Findings::is_proved(); }

void set_signs(Findings& findings, const NumberVector& c, const NumberVector& b) {
    findings.negative_weights = negative(b, b);
    findings.nodes_outside = outside(c);
}

void set_oscillator(Findings& findings, const GalerkinRule& rule) { set_map(findings, rule); }

void set_signs(Certificate& certificate, const NodesAndMethod& given) {
    certificate.stages = given.c.size();
    certificate.coupled_separable = coupled_stages(given.method, true);
    certificate.coupled_general = coupled_stages(given.method, false);
    certificate.negative_weights = negative(given.method.b, given.method.b_tilde);
    certificate.nodes_outside = outside(given.c);
}

Properties properties(const PartitionedMethod& method, int max_order) {
    return properties_of(method, max_order);
}

Certificate certify(const Tableau& tableau, int max_order) {
    Certificate result;
    if (tableau.digits > 0) {
        static_cast<Properties&>(result) = properties_of(rounded_method(tableau), max_order);
        result.within_digits = true;
    } else {
        static_cast<Properties&>(result) = properties_of(tableau, max_order);
    }
    result.name = tableau.provenance.name;
    result.origin = tableau.provenance.origin;
    result.parameters = tableau.parameters;
    set_signs(result, {tableau.c, partitioned_method(tableau)});
    if (!takes_long(tableau)) { set_map(result, tableau); }
    result.known_as = known_names(tableau);
    result.adjoint = known_adjoints(tableau);
    return result;
}

Certificate certify(const NodesAndMethod& given, const std::vector<std::string>& parameters,
                    int max_order) {
    Certificate result;
    static_cast<Properties&>(result) = properties_of(given.method, max_order);
    result.parameters = parameters;
    set_signs(result, given);
    if (!takes_long(given.method)) { set_map(result, given.method); }
    return result;
}

Certificate certify_within_digits(const GivenTableau& given, int max_order) {
    Certificate result;
    static_cast<Properties&>(result) = properties_of(given.rounded_method(), max_order);
    result.within_digits = true;
    set_signs(result, given.written);
    return result;
}

}  // namespace hvi::gen

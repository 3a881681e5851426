// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/certify/certificate.hpp"

#include "generator/plan/plan.hpp"

namespace hvi::gen {
namespace {

std::vector<std::size_t> negative(const NumberVector& numbers) {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (!numbers[i].has_parameters() && numbers[i].sign() < 0) { result.push_back(i + 1); }
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

}  // namespace

bool Certificate::is_proved() const {
    const bool orders_proved =
        orders.general.proved && orders.separable.proved && orders.nystrom.proved;
    return symplectic.proved && symmetric.proved && runge_kutta.proved && orders_proved &&
           oscillator.proved && (!stability || stability->proved);
}

Certificate certify(const Tableau& tableau, int max_order) {
    Certificate result;
    result.name = tableau.name;
    result.origin = tableau.origin;
    result.parameters = tableau.parameters;
    result.stages = tableau.stages();
    result.symplectic = is_symplectic(tableau);
    result.symmetric = is_symmetric(tableau);
    result.runge_kutta = is_runge_kutta(tableau);
    result.orders = orders(tableau, max_order);
    result.explicit_separable = plan(tableau, {.separable = true}).is_explicit();
    result.explicit_general = plan(tableau, {.separable = false}).is_explicit();
    result.negative_weights = negative(tableau.b);
    result.nodes_outside = outside(tableau.c);
    result.oscillator = oscillator_map(tableau);
    if (tableau.parameters.empty()) {
        result.stability = linear_stability(result.oscillator, stability_limit);
    }
    return result;
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "generator/ir/system.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

/// A node needs nodes of smaller numbers only, and depends on what these depend on.
void verify(const Graph& graph, Node node) {
    const Computation& computation = graph.at(node);
    if (computation.operation == Operation::input) { return; }
    Roles roles = 0;
    for (const Scaled& term : computation.terms) {
        HVI_CHECK(term.node < node && !term.is_zero());
        roles |= graph.at(term.node).roles;
    }
    for (const Node argument : computation.arguments) {
        HVI_CHECK(argument < node);
        roles |= graph.at(argument).roles;
    }
    HVI_CHECK(roles == computation.roles);
    const bool is_sum = computation.operation == Operation::sum;
    HVI_CHECK(is_sum == !computation.terms.empty());
    HVI_CHECK(!is_sum || computation.terms.size() > 1 || !computation.terms[0].factor.is_one());
}

void verify(const Graph& graph, const std::vector<Scaled>& values, std::size_t count) {
    HVI_CHECK(values.size() == count);
    HVI_CHECK(std::all_of(values.begin(), values.end(),
                          [&](const Scaled& value) { return value.node < graph.size(); }));
}

void verify(const Graph& graph, const HessianBlock& block, std::size_t n, bool is_symmetric) {
    HVI_CHECK(block.size() == n);
    for (const std::vector<Scaled>& row : block) { verify(graph, row, n); }
    for (std::size_t i = 0; i < n && is_symmetric; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            HVI_CHECK(block[i][j].is_zero() == block[j][i].is_zero());
        }
    }
}

void verify(const Graph& graph, const std::vector<SystemValue>& values) {
    for (const SystemValue& each : values) { HVI_CHECK(each.value.node < graph.size()); }
}

void verify_constant(const System& system, const Scaled& value) {
    HVI_CHECK(value.node < system.graph.size() && !varies(system.graph.at(value.node).roles));
}

void verify_constant(const System& system, const HessianBlock& block, bool is_symmetric) {
    verify(system.graph, block, system.degrees_of_freedom(), is_symmetric);
    for (const std::vector<Scaled>& row : block) {
        for (const Scaled& entry : row) { verify_constant(system, entry); }
    }
}

void verify_constant(const System& system) {
    const ConstantTerms& constant = system.structure.constant;
    if (const auto* stiff = std::get_if<std::vector<LinearStiffness>>(&constant)) {
        HVI_CHECK(!stiff->empty() && system.structure.kinetic_is_quadratic);
        for (const LinearStiffness& each : *stiff) {
            HVI_CHECK(each.component < system.degrees_of_freedom());
            verify_constant(system, each.value);
        }
    }
    if (const auto* all = std::get_if<Hessian>(&constant)) {
        verify_constant(system, all->qq, true);
        verify_constant(system, all->mixed, false);
        verify_constant(system, all->conjugates, true);
    }
}

void verify_variables(const System& system) {
    const std::size_t n = system.degrees_of_freedom();
    HVI_CHECK(system.q.size() == n + 6 * system.rotations.size());
    HVI_CHECK(system.rotations.empty() || system.side == Side::hamiltonian);
    HVI_CHECK(system.coordinates.size() == system.q.size() && system.momenta.size() == n);
    HVI_CHECK(system.conjugate_names().size() == n && system.energy.node < system.graph.size());
    HVI_CHECK(system.initial.empty() || system.initial.size() == system.q.size() + n);
    for (const SystemParameter& parameter : system.parameters) {
        HVI_CHECK(system.graph.at(parameter.node).operation == Operation::input);
    }
}

}  // namespace

void verify(const System& system) {
    const Structure& found = system.structure;
    const Graph& graph = system.graph;
    const std::size_t n = system.degrees_of_freedom();
    for (Node node = 0; node < graph.size(); ++node) { verify(graph, node); }
    verify_variables(system);
    verify(graph, system.by_q, n);
    verify(graph, system.by_conjugates, n);
    verify(graph, system.hessian.qq, n, system.rotations.empty());
    verify(graph, system.hessian.mixed, n, false);
    verify(graph, system.hessian.conjugates, n, true);
    verify(graph, system.initial);
    verify(graph, system.invariants);
    HVI_CHECK(!found.kinetic_is_quadratic || found.is_separable);
    HVI_CHECK(!found.has_diagonal_mass || found.kinetic_is_quadratic);
    HVI_CHECK(found.kinetic_is_quadratic == (found.inverse_mass.size() == n));
    verify_constant(system);
    HVI_CHECK(!found.has_linear_map || (found.by_q.size() == n && found.by_p.size() == n));
}

}  // namespace hvi::gen

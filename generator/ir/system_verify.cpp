// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <tuple>

#include "generator/ir/system.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

/// Checks that a node needs only nodes of smaller numbers, and has their roles.
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

void verify(const System& system, const Access& access) {
    if (access.kind == FamilyKind::turn) { return; }
    HVI_CHECK(system.graph.at(access.node).operation == Operation::input);
    const SystemFamily& family = system.family(access);
    HVI_CHECK(access.indices.size() == family.ranges.size());
    HVI_CHECK(access.component < family.space.point);
}

void verify(const System& system, const std::vector<std::size_t>& accesses) {
    HVI_CHECK(std::is_sorted(accesses.begin(), accesses.end()));
    HVI_CHECK(accesses.empty() || accesses.back() < system.accesses.size());
}

/// Checks derivatives of a sum. NOTE: a rotation is differentiated by its turns, which do not
/// occur.
void verify(const System& system, const SystemSum& sum, const std::vector<AccessSlope>& slopes,
            FamilyKind kind) {
    for (const AccessSlope& slope : slopes) {
        HVI_CHECK(!slope.value.is_zero() && slope.value.node < system.graph.size());
        const Access& access = system.accesses.at(slope.access);
        const bool occurs =
            std::binary_search(sum.accesses.begin(), sum.accesses.end(), slope.access);
        const bool is_turn = access.kind == FamilyKind::turn && kind == FamilyKind::coordinate;
        HVI_CHECK(is_turn || (occurs && access.kind == kind));
    }
}

void verify(const System& system, const std::vector<SystemSum>& sums) {
    for (const SystemSum& sum : sums) {
        HVI_CHECK(sum.value.node < system.graph.size());
        verify(system, sum.accesses);
        verify(system, sum, sum.by_q, FamilyKind::coordinate);
        verify(system, sum, sum.by_conjugates, FamilyKind::conjugate);
    }
}

/// Checks the sums of a value: without loops there is one.
void verify_value(const System& system, const std::vector<SystemSum>& sums) {
    verify(system, sums);
    HVI_CHECK(!system.is_written_out() || sums.size() == 1);
    HVI_CHECK(!system.is_written_out() || sums.front().loops.empty());
}

/// Checks that each total is an input, with the roles of its sums.
void verify_totals(const System& system) {
    for (const SystemTotal& total : system.totals) {
        const Computation& input = system.graph.at(total.node);
        HVI_CHECK(input.operation == Operation::input);
        for (const SystemSum& sum : total.sums) {
            const Roles roles = system.graph.at(sum.value.node).roles & of_state;
            HVI_CHECK((roles & ~input.roles) == 0);
        }
        verify(system, total.sums);
    }
}

void verify(const System& system, const HessianOfSums& second) {
    const auto is_coordinate = [&](std::size_t access) {
        return system.accesses.at(access).kind == FamilyKind::coordinate;
    };
    for (const SumEntries& entries : second.entries) {
        verify(system, entries.accesses);
        for (const SumEntry& entry : entries.entries) {
            HVI_CHECK(is_coordinate(entry.row) && is_coordinate(entry.column));
            HVI_CHECK(!entry.value.is_zero() && entry.value.node < system.graph.size());
        }
    }
    verify(system, second.products);
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

/// Checks that a coordinate and its conjugate have the same indices, and spaces that belong
/// together.
void verify_families(const System& system) {
    const auto& [q, y] = std::tie(system.coordinates, system.conjugates);
    HVI_CHECK(q.size() == y.size());
    for (std::size_t k = 0; k < q.size(); ++k) { HVI_CHECK(are_of_one_body(q[k], y[k])); }
    const bool has_L = system.side == Side::lagrangian;
    HVI_CHECK(system.momenta.size() == (has_L ? q.size() : 0));
    HVI_CHECK(system.initial.empty() || system.initial.size() == 2 * q.size());
    for (const SystemParameter& parameter : system.parameters) {
        HVI_CHECK(system.graph.at(parameter.node).operation == Operation::input);
    }
}

/// Checks that every variable is an access, in the order of the families, and that derivatives are
/// by all of them.
void verify_written_out(const System& system) {
    const Structure& found = system.structure;
    const std::size_t n = system.degrees_of_freedom();
    std::size_t points = 0, access = 0;
    for (const auto* families : {&system.coordinates, &system.conjugates}) {
        for (const SystemFamily& family : *families) {
            for (std::size_t k = 0; k < family.space.point; ++k, ++access) {
                HVI_CHECK(&system.family(system.accesses.at(access)) == &family);
                HVI_CHECK(system.accesses[access].component == k);
            }
            points += family.space.point;
        }
    }
    HVI_CHECK(conjugate_nodes(system).size() == n && !system.sites);
    HVI_CHECK(system.initial.empty() || start_of(system).size() == points);
    const Hessian& second = hessian_of(system);
    verify(system.graph, second.qq, n, rotations_of(system) == 0);
    verify(system.graph, second.mixed, n, false);
    verify(system.graph, second.conjugates, n, true);
    HVI_CHECK(found.kinetic_is_quadratic == (found.inverse_mass.size() == n));
    verify_constant(system);
    HVI_CHECK(!found.has_linear_map || (found.by_q.size() == n && found.by_p.size() == n));
}

}  // namespace

void verify(const System& system) {
    const Structure& found = system.structure;
    for (Node node = 0; node < system.graph.size(); ++node) { verify(system.graph, node); }
    verify_families(system);
    for (const Access& access : system.accesses) { verify(system, access); }
    verify_totals(system);
    verify_value(system, system.sums);
    verify_value(system, system.energy);
    for (const SystemValue& each : system.invariants) { verify_value(system, each.sums); }
    if (const auto* second = std::get_if<HessianOfSums>(&system.second)) {
        verify(system, *second);
    }
    HVI_CHECK(!found.kinetic_is_quadratic || found.is_separable);
    HVI_CHECK(!found.has_diagonal_mass || found.kinetic_is_quadratic);
    if (system.is_written_out()) { verify_written_out(system); }
}

}  // namespace hvi::gen

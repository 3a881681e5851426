// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/slopes.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <variant>

#include "generator/graph/replaced.hpp"
#include "generator/lower/accesses.hpp"
#include "generator/lower/collected.hpp"
#include "generator/lower/turns.hpp"

namespace hvi::gen {

namespace {

std::vector<std::size_t> variables_of(const System& system, const SystemSum& sum) {
    std::vector<std::size_t> result;
    for (const std::size_t access : sum.accesses) {
        const FamilyKind kind = system.accesses[access].kind;
        const bool is_variable = kind == FamilyKind::coordinate || kind == FamilyKind::conjugate;
        if (is_variable) { result.push_back(access); }
    }
    return result;
}

/// Returns slopes by degrees of freedom, from slopes by coordinates.
std::vector<AccessSlope> with_turns(System& system, const std::vector<AccessSlope>& by_q) {
    std::vector<Scaled> by_entries(coordinate_nodes(system).size(), Graph::number(0));
    for (const AccessSlope& slope : by_q) { by_entries[slope.access] = slope.value; }
    const std::vector<Scaled> values = by_turns(system, by_entries);
    std::vector<AccessSlope> result;
    std::size_t degree = 0;
    for (std::size_t k = 0; k < system.accesses.size(); ++k) {
        const Access& access = system.accesses[k];
        const bool is_number =
            access.kind == FamilyKind::coordinate && system.family(access).space == real_line;
        if (!is_number && access.kind != FamilyKind::turn) { continue; }
        if (!values[degree].is_zero()) { result.push_back({k, values[degree]}); }
        ++degree;
    }
    return result;
}

}  // namespace

std::vector<AccessSlope> slopes(System& system, const Scaled& value,
                                const std::vector<std::size_t>& accesses) {
    std::vector<Node> inputs;
    for (const std::size_t access : accesses) { inputs.push_back(system.accesses[access].node); }
    const std::vector<Scaled> values = short_gradient(system.graph, value, inputs);
    std::vector<AccessSlope> result;
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (!values[k].is_zero()) { result.push_back({accesses[k], values[k]}); }
    }
    return result;
}

std::vector<std::size_t> accesses_of(const std::vector<AccessSlope>& slopes) {
    std::vector<std::size_t> result;
    for (const AccessSlope& slope : slopes) { result.push_back(slope.access); }
    return result;
}

std::optional<std::vector<AccessSlope>> linear_form(System& system, const Scaled& value,
                                                    const std::vector<std::size_t>& variables) {
    // NOTE: the derivatives of a function with a kink may be constant on both sides of it, with two
    // values.
    if (has_kinks(system.graph, {value})) { return std::nullopt; }
    std::vector<AccessSlope> coefficients = slopes(system, value, variables);
    const bool are_constant =
        std::none_of(coefficients.begin(), coefficients.end(), [&](const AccessSlope& each) {
            return (system.graph.at(each.value.node).roles & of_motion) != 0;
        });
    if (!are_constant) { return std::nullopt; }
    std::map<Node, Scaled> at_rest;
    for (const std::size_t k : variables) { at_rest[system.accesses[k].node] = Graph::number(0); }
    if (!replaced(system.graph, value, at_rest).is_zero()) { return std::nullopt; }
    return coefficients;
}

SystemSum differentiated(System& system, SystemSum sum) {
    sum.accesses = accesses_in(system, {sum.value});
    sum.by_q.clear();
    sum.by_conjugates.clear();
    for (const AccessSlope& slope : slopes(system, sum.value, variables_of(system, sum))) {
        const bool is_q = system.accesses[slope.access].kind == FamilyKind::coordinate;
        (is_q ? sum.by_q : sum.by_conjugates).push_back(slope);
    }
    // NOTE: with loops a step computes derivatives by turns from those by entries, body by body.
    if (system.is_written_out() && rotations_of(system) != 0) {
        sum.by_q = with_turns(system, sum.by_q);
    }
    return sum;
}

System differentiated(System system) {
    for (SystemTotal& total : system.totals) {
        for (SystemSum& sum : total.sums) { sum = differentiated(system, std::move(sum)); }
    }
    for (SystemSum& sum : system.sums) { sum = differentiated(system, std::move(sum)); }
    for (SystemValue& invariant : system.invariants) {
        for (SystemSum& sum : invariant.sums) {
            sum = {std::move(sum.loops), sum.value, accesses_in(system, {sum.value}), {}, {}};
        }
    }
    for (SystemStart& start : system.initial) {
        if (auto* rule = std::get_if<SystemStart::Rule>(&start.values)) {
            rule->accesses = accesses_in(system, {rule->value});
        } else if (auto* list = std::get_if<SystemStart::List>(&start.values)) {
            list->accesses = accesses_in(system, list->values);
        } else if (auto* points = std::get_if<SystemStart::Points>(&start.values)) {
            points->accesses = accesses_in(system, points->values);
        }
    }
    return system;
}

}  // namespace hvi::gen

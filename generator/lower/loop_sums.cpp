// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/loop_sums.hpp"

#include <algorithm>
#include <utility>

#include "generator/exact/expressions/evaluate.hpp"
#include "generator/lower/loop_elements.hpp"
#include "generator/lower/loop_terms.hpp"
#include "generator/lower/slopes.hpp"
#include "generator/lower/totals.hpp"
#include "generator/read/hamiltonian.hpp"

namespace hvi::gen {

namespace {

Roles roles_of(const Declarations& names, const std::string& name) {
    const auto found = names.families.find(name);
    if (found == names.families.end()) { return 0; }
    switch (found->second.kind) {
    case FamilyKind::coordinate: return static_cast<Roles>(Role::coordinate);
    case FamilyKind::conjugate: return static_cast<Roles>(Role::conjugate);
    case FamilyKind::table:
    case FamilyKind::direction:
    case FamilyKind::direction_of_conjugate:
    case FamilyKind::turn: break;
    }
    return 0;
}

/// Summands of one sum.
struct Group {
    std::vector<Loop> loops;
    Roles roles;
    std::vector<Scaled> values;
};

/// Returns the input for a sum that other sums depend on.
Scaled total(System& system, const Declarations& names, const std::string& name,
             const IndexedExpression& sum, const Symbols& known) {
    for (const SystemTotal& before : system.totals) {
        if (system.graph.at(before.node).name == name) { return {{1, 1}, before.node}; }
    }
    std::vector<SystemSum> of = sums_of(system, names, sum, known);
    const Scaled input = system.graph.input(name, roles_of_total(system.graph, of));
    system.totals.push_back({input.node, std::move(of)});
    return input;
}

}  // namespace

std::vector<SystemSum> sums_of(System& system, const Declarations& names,
                               const IndexedExpression& whole, Symbols known) {
    check_numbers(whole.written, whole.source);
    std::vector<Group> groups;
    const LoopTerms split = loop_terms(
        whole, {names.taken, [&](const std::string& name) { return roles_of(names, name); }});
    for (const auto& [name, sum] : split.totals) {
        known[name] = total(system, names, name, {sum, whole.source}, known);
    }
    for (const LoopTerm& term : split.terms) {
        const Scaled summand = value_of_term(system, names, term, whole.source, known);
        if (summand.is_zero()) { continue; }
        // NOTE: summands that depend on other kinds of variables form another sum.
        const Roles found = system.graph.at(summand.node).roles & of_state;
        const auto same = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
            return group.loops == term.loops && group.roles == found;
        });
        if (same == groups.end()) {
            groups.push_back({term.loops, found, {summand}});
        } else {
            same->values.push_back(summand);
        }
    }
    std::vector<SystemSum> result;
    for (Group& group : groups) {
        const Scaled value = system.graph.sum(std::move(group.values));
        result.push_back(differentiated(system, {std::move(group.loops), value, {}, {}, {}}));
    }
    return result;
}

std::vector<SystemSum> sums_in_time(System& system, const Declarations& names,
                                    const IndexedExpression& function) {
    Symbols known = names.symbols;
    if (depends_on_time(function.written)) {
        const Scaled time = system.graph.input("t", Role::time);
        system.time = time.node;
        known["t"] = time;
    }
    return sums_of(system, names, function, std::move(known));
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/tangent.hpp"

#include <set>
#include <string>
#include <utility>

#include "generator/lower/accesses.hpp"
#include "generator/lower/slopes.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

using Families = std::vector<SystemFamily>;
using Starts = std::vector<SystemStart>;

/// Families of a direction, `d_x` for x.
Families direction_of(const Families& families, std::set<std::string>& taken) {
    Families result;
    for (const SystemFamily& family : families) {
        std::string name = "d_" + family.name;
        while (!taken.insert(name).second) { name += "_"; }
        result.push_back({name, {}});
    }
    return result;
}

void append(Families& to, const Families& more) { to.insert(to.end(), more.begin(), more.end()); }

/// Accesses to families without indices.
std::vector<Node> add_accesses(System& system, FamilyKind kind, const Families& families,
                               std::size_t first, Role role) {
    std::vector<Node> nodes;
    for (std::size_t k = 0; k < families.size(); ++k) {
        const Node node = system.graph.input(families[k].name, role).node;
        system.accesses.push_back({kind, first + k, {}, node, 0});
        nodes.push_back(node);
    }
    return nodes;
}

void set_starts(System& system, std::size_t n) {
    if (system.initial.empty()) { return; }
    const auto half = system.initial.begin() + static_cast<std::ptrdiff_t>(n);
    Starts result(system.initial.begin(), half);
    result.insert(result.end(), 2 * n, {SystemStart::Rule{{}, Graph::number(0)}});
    result.insert(result.end(), half, system.initial.end());
    system.initial = std::move(result);
}

}  // namespace

System with_tangent(System system) {
    HVI_CHECK(system.is_written_out() && system.side == Side::hamiltonian);
    HVI_CHECK(rotations_of(system) == 0 && !system.scaled);
    const Scaled H = function_of(system);
    const std::vector<Scaled> H_q = by_coordinates(system), H_p = by_conjugates(system);
    const Families q = system.coordinates, p = system.conjugates;
    const std::size_t n = q.size();
    std::set<std::string> taken;
    for (Node node = 0; node < system.graph.size(); ++node) {
        taken.insert(system.graph.at(node).name);
    }
    const Families dq = direction_of(q, taken), dp = direction_of(p, taken);

    append(system.coordinates, dq);
    system.conjugates = dp;
    append(system.conjugates, p);
    system.accesses.clear();
    add_accesses(system, FamilyKind::coordinate, q, 0, Role::coordinate);
    const auto dq_nodes = add_accesses(system, FamilyKind::coordinate, dq, n, Role::coordinate);
    const auto dp_nodes = add_accesses(system, FamilyKind::conjugate, dp, 0, Role::conjugate);
    add_accesses(system, FamilyKind::conjugate, p, n, Role::conjugate);
    set_starts(system, n);
    system.invariants.clear();

    std::vector<Scaled> terms;
    for (std::size_t k = 0; k < n; ++k) {
        terms.push_back(system.graph.product(H_q[k], {{1, 1}, dq_nodes[k]}));
        terms.push_back(system.graph.product(H_p[k], {{1, 1}, dp_nodes[k]}));
    }
    system.sums = {{{}, system.graph.sum(std::move(terms)), {}, {}, {}}};
    system.description = "K = dH/dq dq + dH/dp dp: the motion of H, and a direction along it";
    system.energy = {{{}, H, accesses_in(system, {H}), {}, {}}};
    return differentiated(std::move(system));
}

}  // namespace hvi::gen

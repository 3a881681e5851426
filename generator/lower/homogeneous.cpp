// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/homogeneous.hpp"

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "generator/graph/replaced.hpp"
#include "generator/lower/accesses.hpp"
#include "generator/lower/derivative.hpp"
#include "generator/lower/slopes.hpp"
#include "generator/lower/taken_names.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

/// Parts of H = T(p) + U(q, p).
struct TwoParts {
    Scaled T, U;
};

/// Terms of H, also terms of sums with constant factors before them.
class TermsByVariables {
public:
    explicit TermsByVariables(Graph& graph) : graph_(graph) {}

    void add(const Scaled& value, const Scaled& factor = Graph::number(1)) {
        // NOTE: a copy, since the graph grows.
        const Computation computation = graph_.at(value.node);
        const Scaled all = graph_.times(value.factor, factor);
        if (computation.operation == Operation::sum) {
            for (const Scaled& term : computation.terms) { add(term, all); }
            return;
        }
        if (computation.operation == Operation::product) {
            const Node a = computation.arguments[0], b = computation.arguments[1];
            if (!varies(graph_.at(a).roles)) {
                return add({{1, 1}, b}, graph_.product(all, at(a)));
            }
            if (!varies(graph_.at(b).roles)) {
                return add({{1, 1}, a}, graph_.product(all, at(b)));
            }
        }
        const bool is_of_p =
            has(computation.roles, Role::conjugate) && !has(computation.roles, Role::coordinate);
        (is_of_p ? T_ : U_).push_back(graph_.product(all, at(value.node)));
    }

    [[nodiscard]] TwoParts found() { return {graph_.sum(T_), graph_.sum(U_)}; }

private:
    [[nodiscard]] static Scaled at(Node node) { return {{1, 1}, node}; }

    Graph& graph_;
    std::vector<Scaled> T_, U_;
};

/// Returns whether 2 T = p T_p, as far as the graph shows.
bool is_homogeneous(System& system, const Scaled& T) {
    std::vector<std::size_t> momenta;
    for (std::size_t k = 0; k < system.accesses.size(); ++k) {
        if (system.accesses[k].kind == FamilyKind::conjugate) { momenta.push_back(k); }
    }
    const std::vector<Node> p = conjugate_nodes(system);
    // NOTE: as they are derived, slopes keep the products of T.
    const std::vector<Scaled> by_p = gradient(system.graph, T, p);
    std::vector<Scaled> terms{system.graph.times({2, 1}, T)};
    for (std::size_t k = 0; k < p.size(); ++k) {
        terms.push_back(system.graph.times({-1, 1}, system.graph.product({{1, 1}, p[k]}, by_p[k])));
    }
    const auto form = linear_form(system, system.graph.sum(std::move(terms)), momenta);
    return form && form->empty();
}

/// Returns scale^2 f(variables/scale).
Scaled made_homogeneous(Graph& graph, const Scaled& f, const std::vector<Node>& variables,
                        const Scaled& scale) {
    const Scaled inverse = graph.inverse(scale);
    std::map<Node, Scaled> scaled;
    for (const Node node : variables) { scaled[node] = graph.product({{1, 1}, node}, inverse); }
    return graph.product(graph.half_power(scale, 4), replaced(graph, f, scaled));
}

/// Coordinates with their momenta, behind all others.
class NewPairs {
public:
    explicit NewPairs(System& system) : system_(system), taken_(taken_names(system)) {}

    /// Adds a pair with these initial values. Returns the inputs.
    std::pair<Scaled, Scaled> add(std::string q, long q_start, std::string p, long p_start) {
        const std::size_t number = system_.coordinates.size();
        system_.coordinates.push_back({new_name(std::move(q), taken_), {}});
        system_.conjugates.push_back({new_name(std::move(p), taken_), {}});
        const Scaled node_q =
            system_.graph.input(system_.coordinates.back().name, Role::coordinate);
        const Scaled node_p = system_.graph.input(system_.conjugates.back().name, Role::conjugate);
        insert_access({FamilyKind::coordinate, number, {}, node_q.node, 0}, number);
        system_.accesses.push_back({FamilyKind::conjugate, number, {}, node_p.node, 0});
        if (!system_.initial.empty()) {
            const auto end_of_q = system_.initial.begin() + static_cast<std::ptrdiff_t>(number);
            system_.initial.insert(end_of_q, start(q_start));
            system_.initial.push_back(start(p_start));
        }
        return {node_q, node_p};
    }

private:
    [[nodiscard]] static SystemStart start(long value) {
        return {SystemStart::Rule{{}, Graph::number(value)}};
    }

    void insert_access(Access access, std::size_t place) {
        system_.accesses.insert(system_.accesses.begin() + static_cast<std::ptrdiff_t>(place),
                                std::move(access));
    }

    System& system_;
    std::set<std::string> taken_;
};

}  // namespace

System with_homogeneous_extension(System system) {
    HVI_CHECK(system.is_written_out() && system.side == Side::hamiltonian && !system.time);
    HVI_CHECK(rotations_of(system) == 0 && !system.scaled);
    const Scaled H = function_of(system);
    std::vector<Node> p = conjugate_nodes(system), all = coordinate_nodes(system);
    all.insert(all.end(), p.begin(), p.end());
    TermsByVariables terms(system.graph);
    terms.add(H);
    auto [T, U] = terms.found();
    const bool is_quadratic = is_homogeneous(system, T);
    NewPairs pairs(system);
    const Scaled a = pairs.add("scale_q", 1, "rate_q", 0).first;
    U = made_homogeneous(system.graph, U, all, a);
    if (!is_quadratic) {
        const Scaled c = pairs.add("rate_p", 0, "scale_p", 1).second;
        T = made_homogeneous(system.graph, T, p, c);
    }
    system.invariants.clear();
    system.sums = {{{}, system.graph.sum({T, U}), {}, {}, {}}};
    system.energy = {{{}, H, {}, {}, {}}};
    system = differentiated(std::move(system));
    system.energy.front().accesses = accesses_in(system, {H});
    return system;
}

}  // namespace hvi::gen

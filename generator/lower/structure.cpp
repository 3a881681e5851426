// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/structure.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

#include "generator/lower/collected.hpp"
#include "generator/lower/constancy.hpp"
#include "generator/lower/derivative.hpp"
#include "generator/lower/loop_structure.hpp"
#include "generator/lower/turns.hpp"

namespace hvi::gen {

namespace {

using Matrix = HessianBlock;

bool holds_for_all(const Matrix& matrix, const std::function<bool(const Scaled&)>& property) {
    return std::all_of(matrix.begin(), matrix.end(), [&](const std::vector<Scaled>& row) {
        return std::all_of(row.begin(), row.end(), property);
    });
}

bool is_zero(const Matrix& matrix) {
    return holds_for_all(matrix, [](const Scaled& entry) { return entry.is_zero(); });
}

bool is_constant(const Graph& graph, const Matrix& matrix) {
    return holds_for_all(matrix,
                         [&](const Scaled& entry) { return !varies(graph.at(entry.node).roles); });
}

/// Returns whether all entries are constant; then they become nodes that do not vary.
bool settle(Graph& graph, Matrix& matrix) {
    Matrix settled = matrix;
    for (std::vector<Scaled>& row : settled) {
        for (Scaled& entry : row) {
            const auto value = constant_value(graph, entry);
            if (!value) { return false; }
            entry = *value;
        }
    }
    matrix = std::move(settled);
    return true;
}

/// Replaces the entries above the diagonal of a symmetric matrix by those below it.
void mirror(Matrix& matrix) {
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) { matrix[j][i] = matrix[i][j]; }
    }
}

/// Sets an entry to zero where its mirror entry is seen to be zero. A second derivative may be seen
/// to be zero in one order of its variables alone: q1 q2/q2 by q2 and then by q1.
void share_zeros(Matrix& matrix) {
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            Scaled &one = matrix[i][j], &other = matrix[j][i];
            if (one.is_zero() || other.is_zero()) { one = other = Graph::number(0); }
        }
    }
}

bool depends_on(const Graph& graph, const std::vector<Scaled>& values, Role role) {
    return std::any_of(values.begin(), values.end(),
                       [&](const Scaled& value) { return has(graph.at(value.node).roles, role); });
}

/// Returns K p.
std::vector<Scaled> product(System& system, const Matrix& K) {
    const std::vector<Node> momenta = conjugate_nodes(system);
    std::vector<Scaled> result;
    for (const std::vector<Scaled>& row : K) {
        std::vector<Scaled> terms;
        for (std::size_t j = 0; j < row.size(); ++j) {
            terms.push_back(system.graph.product(row[j], {{1, 1}, momenta[j]}));
        }
        result.push_back(system.graph.sum(std::move(terms)));
    }
    return result;
}

/// Adds the constant terms of a sum, and of sums in it. NOTE: the derivative of q (a + b q^2) has
/// a + b q^2 for a term.
void add_constant_terms(Graph& graph, const Scaled& entry, std::vector<Scaled>& constant) {
    const Computation& computation = graph.at(entry.node);
    if (!varies(computation.roles)) {
        constant.push_back(entry);
    } else if (computation.operation == Operation::sum) {
        // NOTE: a copy, since the graph grows.
        const std::vector<Scaled> terms = computation.terms;
        for (const Scaled& term : terms) {
            add_constant_terms(graph, graph.times(entry.factor, term), constant);
        }
    }
}

Scaled constant_terms(Graph& graph, const Scaled& entry) {
    std::vector<Scaled> constant;
    add_constant_terms(graph, entry, constant);
    return graph.sum(std::move(constant));
}

bool is_diagonal(const Matrix& matrix) {
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        for (std::size_t j = 0; j < matrix.size(); ++j) {
            if (i != j && !matrix[i][j].is_zero()) { return false; }
        }
    }
    return true;
}

Hessian constant_terms(System& system) {
    Hessian constant = hessian_of(system);
    for (Matrix* block : {&constant.qq, &constant.mixed, &constant.conjugates}) {
        for (std::vector<Scaled>& row : *block) {
            for (Scaled& entry : row) { entry = constant_terms(system.graph, entry); }
        }
    }
    // NOTE: one order of derivatives may hide a constant in a product that the other shows.
    mirror(constant.qq);
    mirror(constant.conjugates);
    return constant;
}

ConstantTerms stiffness(System& system, const Matrix& qq) {
    std::vector<LinearStiffness> result;
    for (std::size_t k = 0; k < qq.size(); ++k) {
        const Scaled value = system.graph.product(hessian_of(system).conjugates[k][k], qq[k][k]);
        if (!value.is_zero()) { result.push_back({k, value}); }
    }
    return result.empty() ? ConstantTerms{} : result;
}

/// NOTE: (Hpq Hpp; -Hqq -Hqp) with nothing but Hqq, or Hpp, has a square of 0, and nothing is
/// stiff.
ConstantTerms constant_part(System& system, const Structure& found) {
    Hessian constant = constant_terms(system);
    const bool is_by_components =
        found.kinetic_is_quadratic && is_diagonal(constant.qq) && is_diagonal(constant.conjugates);
    if (is_by_components) { return stiffness(system, constant.qq); }
    const bool moves =
        !is_zero(constant.mixed) || (!is_zero(constant.qq) && !is_zero(constant.conjugates));
    return moves ? constant : ConstantTerms{};
}

/// NOTE: where a slope, as it is written, has no value at the origin there is no linear map.
void set_linear_part(Structure& found, System& system) {
    const auto add = [&](std::vector<Scaled>& values, const Scaled& slope) {
        const auto value = at_origin(system.graph, slope);
        found.has_linear_map = found.has_linear_map && value;
        values.push_back(value.value_or(Graph::number(0)));
    };
    for (const Scaled& slope : by_coordinates(system)) { add(found.by_q, slope); }
    for (const Scaled& slope : by_conjugates(system)) { add(found.by_p, slope); }
}

/// NOTE: not the sums of qq_ij v_j: as the gradient of v dH/dq it costs as much as a few dH/dq,
/// however many degrees of freedom there are.
void set_direction(Structure& found, System& system) {
    const std::vector<Scaled> slopes = by_coordinates(system);
    std::vector<Scaled> terms;
    for (std::size_t k = 0; k < slopes.size(); ++k) {
        const Scaled v = system.graph.input("direction " + std::to_string(k), Role::direction);
        found.direction.push_back(v.node);
        terms.push_back(system.graph.product(v, slopes[k]));
    }
    const Scaled along = system.graph.sum(std::move(terms));
    found.qq_along = gradient(system.graph, along, coordinate_nodes(system));
}

/// Collects all entries together.
void collect(Graph& graph, Hessian& second) {
    std::vector<Scaled*> entries;
    for (Matrix* block : {&second.qq, &second.mixed, &second.conjugates}) {
        for (std::vector<Scaled>& row : *block) {
            for (Scaled& entry : row) { entries.push_back(&entry); }
        }
    }
    std::vector<Scaled> values;
    for (const Scaled* entry : entries) { values.push_back(*entry); }
    values = collected(graph, values);
    for (std::size_t k = 0; k < entries.size(); ++k) { *entries[k] = values[k]; }
}

/// Returns the second derivatives, added to the graph. Entries that are proved to be constant do
/// not vary in it.
Hessian hessian(System& system) {
    Hessian second;
    Graph& graph = system.graph;
    const std::vector<Node> q = coordinate_nodes(system), y = conjugate_nodes(system);
    const std::vector<Scaled> by_q = by_coordinates(system), by_y = by_conjugates(system);
    for (std::size_t i = 0; i < by_q.size(); ++i) {
        second.qq.push_back(by_turns(system, gradient(graph, by_q[i], q)));
        second.mixed.push_back(gradient(graph, by_q[i], y));
        second.conjugates.push_back(gradient(graph, by_y[i], y));
    }
    collect(graph, second);
    if (rotations_of(system) == 0) { share_zeros(second.qq); }
    share_zeros(second.conjugates);
    // NOTE: the derivatives of a function with a kink may be constant on both sides of it, with two
    // values. Where one block is not constant, constants in the others are of no use.
    static_cast<void>(!has_kinks(graph, by_y) && settle(graph, second.conjugates) &&
                      !has_kinks(graph, by_q) && settle(graph, second.mixed) &&
                      settle(graph, second.qq));
    return second;
}

Structure structure(System& system) {
    Structure found;
    const Graph& graph = system.graph;
    const auto& [qq, mixed, pp] = hessian_of(system);
    const std::vector<Scaled> by_q = by_coordinates(system), by_p = by_conjugates(system);
    found.is_separable = !depends_on(graph, by_q, Role::conjugate) &&
                         !depends_on(graph, by_p, Role::coordinate) &&
                         !depends_on(graph, by_p, Role::time);
    const bool is_smooth_in_p = !has_kinks(graph, by_p);
    const bool is_smooth_in_q = !has_kinks(graph, by_q);
    found.kinetic_is_quadratic = found.is_separable && is_smooth_in_p && is_constant(graph, pp);
    if (found.kinetic_is_quadratic) {
        found.has_diagonal_mass = is_diagonal(pp);
        found.inverse_mass = product(system, pp);
        set_direction(found, system);
    }
    found.constant = constant_part(system, found);
    found.is_quadratic = is_smooth_in_p && is_smooth_in_q && is_constant(graph, pp) &&
                         is_constant(graph, mixed) && is_constant(graph, qq);
    found.has_linear_map = found.is_quadratic && !system.time;
    if (found.has_linear_map) { set_linear_part(found, system); }
    found.is_linear_in_p = is_smooth_in_p && is_zero(pp);
    found.is_linear_in_q = is_smooth_in_q && is_zero(qq);
    return found;
}

/// NOTE: no step for an L, or of rotations, uses the structure.
System with_structure_of_term(System system) {
    system.second = hessian(system);
    if (system.side == Side::hamiltonian && rotations_of(system) == 0) {
        system.structure = structure(system);
    }
    return system;
}

}  // namespace

System with_structure(System system) {
    return system.is_written_out() ? with_structure_of_term(std::move(system))
                                   : with_structure_of_sums(std::move(system));
}

}  // namespace hvi::gen

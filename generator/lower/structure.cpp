// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/structure.hpp"

#include <algorithm>
#include <functional>
#include <string>

#include "generator/lower/constancy.hpp"
#include "generator/lower/derivative.hpp"
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

/// Whether all entries are constant; then they are nodes that do not vary.
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

/// The entries below the diagonal of a symmetric matrix in place of those above it.
void mirror(Matrix& matrix) {
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) { matrix[j][i] = matrix[i][j]; }
    }
}

/// A derivative that is seen to be zero in one order of its two variables is so in the other:
/// q1 q2/q2 by q2 and then by q1.
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

/// K p.
std::vector<Scaled> product(System& system, const Matrix& K) {
    std::vector<Scaled> result;
    for (const std::vector<Scaled>& row : K) {
        std::vector<Scaled> terms;
        for (std::size_t j = 0; j < row.size(); ++j) {
            terms.push_back(system.graph.product(row[j], {{1, 1}, system.conjugates[j]}));
        }
        result.push_back(system.graph.sum(std::move(terms)));
    }
    return result;
}

/// What does not vary in a sum.
Scaled constant_terms(Graph& graph, const Scaled& entry) {
    const Computation& sum = graph.at(entry.node);
    if (!varies(sum.roles)) { return entry; }
    std::vector<Scaled> constant;
    if (sum.operation == Operation::sum) {
        for (const Scaled& term : sum.terms) {
            if (!varies(graph.at(term.node).roles)) { constant.push_back(term); }
        }
    }
    return graph.times(entry.factor, graph.sum(std::move(constant)));
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
    Hessian constant = system.hessian;
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
        const Scaled value = system.graph.product(system.hessian.conjugates[k][k], qq[k][k]);
        if (!value.is_zero()) { result.push_back({k, value}); }
    }
    return result.empty() ? ConstantTerms{} : result;
}

/// NOTE: (Hpq Hpp; -Hqq -Hqp) with nothing but Hqq, or Hpp, has no square, and nothing is stiff.
ConstantTerms constant_part(System& system, const Structure& found) {
    if (system.side == Side::lagrangian || !system.rotations.empty()) { return {}; }
    Hessian constant = constant_terms(system);
    const bool is_by_components =
        found.kinetic_is_quadratic && is_diagonal(constant.qq) && is_diagonal(constant.conjugates);
    if (is_by_components) { return stiffness(system, constant.qq); }
    const bool moves =
        !is_zero(constant.mixed) || (!is_zero(constant.qq) && !is_zero(constant.conjugates));
    return moves ? constant : ConstantTerms{};
}

/// NOTE: where a slope has no value at the origin as it is written there is no linear map.
void set_linear_part(Structure& found, System& system) {
    const auto add = [&](std::vector<Scaled>& values, const Scaled& slope) {
        const auto value = at_origin(system.graph, slope);
        found.has_linear_map = found.has_linear_map && value;
        values.push_back(value.value_or(Graph::number(0)));
    };
    for (const Scaled& slope : system.by_q) { add(found.by_q, slope); }
    for (const Scaled& slope : system.by_conjugates) { add(found.by_p, slope); }
}

/// NOTE: not the sums of qq_ij v_j: as the gradient of v dH/dq it costs as much as a few dH/dq,
/// however many degrees of freedom there are.
void set_direction(Structure& found, System& system) {
    std::vector<Scaled> terms;
    for (std::size_t k = 0; k < system.degrees_of_freedom(); ++k) {
        const Scaled v = system.graph.input("direction " + std::to_string(k), Role::direction);
        found.direction.push_back(v.node);
        terms.push_back(system.graph.product(v, system.by_q[k]));
    }
    const Scaled along = system.graph.sum(std::move(terms));
    found.qq_along = gradient(system.graph, along, system.q);
}

}  // namespace

Hessian hessian(System& system) {
    Hessian second;
    Graph& graph = system.graph;
    for (std::size_t i = 0; i < system.degrees_of_freedom(); ++i) {
        second.qq.push_back(by_turns(system, gradient(graph, system.by_q[i], system.q)));
        second.mixed.push_back(gradient(graph, system.by_q[i], system.conjugates));
        second.conjugates.push_back(gradient(graph, system.by_conjugates[i], system.conjugates));
    }
    if (system.rotations.empty()) { share_zeros(second.qq); }
    share_zeros(second.conjugates);
    // NOTE: the derivatives of a function with a kink are constant on both sides of it, and not
    // one. And where one block is not constant, what the others are is of no use.
    static_cast<void>(!has_kinks(graph, system.by_conjugates) && settle(graph, second.conjugates) &&
                      !has_kinks(graph, system.by_q) && settle(graph, second.mixed) &&
                      settle(graph, second.qq));
    return second;
}

Structure structure(System& system) {
    Structure found;
    const Graph& graph = system.graph;
    const auto& [qq, mixed, pp] = system.hessian;
    found.is_separable = !depends_on(graph, system.by_q, Role::conjugate) &&
                         !depends_on(graph, system.by_conjugates, Role::coordinate) &&
                         !depends_on(graph, system.by_conjugates, Role::time);
    const bool is_smooth_in_p = !has_kinks(graph, system.by_conjugates);
    const bool is_smooth_in_q = !has_kinks(graph, system.by_q);
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

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/structure.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include "generator/lower/derivative.hpp"

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

bool depends_on(const Graph& graph, const std::vector<Scaled>& values, Role role) {
    return std::any_of(values.begin(), values.end(),
                       [&](const Scaled& value) { return has(graph.at(value.node).roles, role); });
}

/// Degrees of freedom of which one's slopes depend on the other.
std::vector<std::vector<std::size_t>> components(const Structure& found) {
    const std::size_t n = found.qq.size();
    std::vector<std::size_t> first(n);
    std::iota(first.begin(), first.end(), std::size_t{0});
    const auto join = [&](std::size_t i, std::size_t j) {
        const auto [kept, replaced] = std::minmax({first[i], first[j]});
        std::replace(first.begin(), first.end(), replaced, kept);
    };
    for (const Matrix* matrix : {&found.qq, &found.qp, &found.pp}) {
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                if (!(*matrix)[i][j].is_zero()) { join(i, j); }
            }
        }
    }
    std::vector<std::vector<std::size_t>> result;
    for (std::size_t i = 0; i < n; ++i) {
        std::vector<std::size_t> members;
        for (std::size_t j = 0; j < n; ++j) {
            if (first[j] == i) { members.push_back(j); }
        }
        if (!members.empty()) { result.push_back(std::move(members)); }
    }
    return result;
}

/// K p.
std::vector<Scaled> product(SystemGraph& system, const Matrix& K) {
    std::vector<Scaled> result;
    for (const std::vector<Scaled>& row : K) {
        std::vector<Scaled> terms;
        for (std::size_t j = 0; j < row.size(); ++j) {
            terms.push_back(system.graph.product(row[j], {{1, 1}, system.p[j]}));
        }
        result.push_back(system.graph.sum(std::move(terms)));
    }
    return result;
}

/// What is left of the slopes without the second derivatives times the variables. NOTE: where that
/// is not seen to be constant H does not pass for quadratic.
void set_linear_part(Structure& found, SystemGraph& system) {
    Graph& graph = system.graph;
    const auto rest = [&](const Scaled& slope, const auto& second_by_q, const auto& second_by_p) {
        std::vector<Scaled> terms{slope};
        for (std::size_t j = 0; j < system.q.size(); ++j) {
            const auto subtract = [&](const Scaled& factor, Node variable) {
                terms.push_back(graph.times({-1, 1}, graph.product(factor, {{1, 1}, variable})));
            };
            subtract(second_by_q(j), system.q[j]);
            subtract(second_by_p(j), system.p[j]);
        }
        const Scaled result = graph.sum(std::move(terms));
        found.is_quadratic = found.is_quadratic && !varies(graph.at(result.node).roles);
        return result;
    };
    for (std::size_t i = 0; i < system.q.size(); ++i) {
        found.by_q.push_back(rest(
            system.dHdq[i], [&](std::size_t j) { return found.qq[i][j]; },
            [&](std::size_t j) { return found.qp[i][j]; }));
        found.by_p.push_back(rest(
            system.dHdp[i], [&](std::size_t j) { return found.qp[j][i]; },
            [&](std::size_t j) { return found.pp[i][j]; }));
    }
}

}  // namespace

Structure structure(SystemGraph& system) {
    Structure found;
    for (std::size_t i = 0; i < system.degrees_of_freedom(); ++i) {
        found.qq.push_back(gradient(system.graph, system.dHdq[i], system.q));
        found.qp.push_back(gradient(system.graph, system.dHdq[i], system.p));
        found.pp.push_back(gradient(system.graph, system.dHdp[i], system.p));
        if (system.dHdq[i].is_zero()) { found.cyclic.push_back(i); }
    }
    const Graph& graph = system.graph;
    found.is_separable = !depends_on(graph, system.dHdq, Role::momentum) &&
                         !depends_on(graph, system.dHdp, Role::coordinate) &&
                         !depends_on(graph, system.dHdp, Role::time);
    const bool pp_constant = is_constant(graph, found.pp);
    found.kinetic_is_quadratic = found.is_separable && pp_constant;
    if (found.kinetic_is_quadratic) { found.inverse_mass = product(system, found.pp); }
    found.is_quadratic =
        pp_constant && is_constant(graph, found.qp) && is_constant(graph, found.qq);
    if (found.is_quadratic) { set_linear_part(found, system); }
    found.is_linear_in_p = is_zero(found.pp);
    found.is_linear_in_q = is_zero(found.qq);
    found.components = components(found);
    return found;
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/form_flow.hpp"

#include <utility>

#include "generator/lower/constancy.hpp"
#include "generator/lower/derivative.hpp"

namespace hvi::gen {

namespace {

using FormRows = std::vector<std::vector<Scaled>>;

/// Returns (S l), the second derivatives and the slopes at the origin.
std::optional<FormRows> rows_at_origin(Graph& graph, const std::vector<Scaled>& slopes,
                                       const std::vector<Node>& variables) {
    const std::size_t size = variables.size();
    FormRows rows(size, std::vector<Scaled>(size + 1));
    for (std::size_t i = 0; i < size; ++i) {
        const std::vector<Scaled> second = gradient(graph, slopes[i], variables);
        for (std::size_t j = i; j < size; ++j) {
            const auto value = at_origin(graph, second[j]);
            if (!value) { return {}; }
            rows[i][j] = rows[j][i] = *value;
        }
        const auto slope = at_origin(graph, slopes[i]);
        if (!slope) { return {}; }
        rows[i][size] = *slope;
    }
    return rows;
}

/// Returns whether a slope is row (z, 1), which is proved.
bool is_slope_of(Graph& graph, const Scaled& slope, const std::vector<Scaled>& row,
                 const std::vector<Node>& variables) {
    std::vector<Scaled> terms{slope, graph.times({-1, 1}, row.back())};
    for (std::size_t j = 0; j < variables.size(); ++j) {
        const Scaled term = graph.product(row[j], {{1, 1}, variables[j]});
        terms.push_back(graph.times({-1, 1}, term));
    }
    const auto rest = constant_value(graph, graph.sum(std::move(terms)));
    return rest && rest->is_zero();
}

}  // namespace

std::optional<std::vector<Scaled>> rows_of_form(Graph& graph, const std::vector<Scaled>& slopes,
                                                const std::vector<Node>& variables) {
    const auto rows = rows_at_origin(graph, slopes, variables);
    if (!rows) { return {}; }
    std::vector<Scaled> result;
    for (std::size_t i = 0; i < variables.size(); ++i) {
        const std::vector<Scaled>& row = (*rows)[i];
        if (!is_slope_of(graph, slopes[i], row, variables)) { return {}; }
        result.insert(result.end(), row.begin() + static_cast<std::ptrdiff_t>(i), row.end());
    }
    return result;
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/kinetic_rank.hpp"

#include <string>
#include <utility>

#include "generator/exact/algebra/number_vector.hpp"
#include "generator/exact/expressions/evaluate.hpp"
#include "generator/graph/written.hpp"

namespace hvi::gen {
namespace {

std::optional<NumberMatrix> kinetic_matrix(const System& system, const Ground& ground) {
    NumberMatrix K;
    for (const std::vector<Scaled>& entries : system.structure.pp) {
        NumberVector& row = K.emplace_back();
        for (const Scaled& entry : entries) {
            const auto text = written(system.graph, entry);
            if (!text) { return std::nullopt; }
            row.push_back(evaluate_number(*text, nullptr, ground));
        }
    }
    return K;
}

/// By elimination.
std::size_t rank(NumberMatrix rows) {
    std::size_t rank = 0;
    const std::size_t columns = rows.empty() ? 0 : rows.front().size();
    for (std::size_t column = 0; column < columns && rank < rows.size(); ++column) {
        std::size_t pivot = rank;
        while (pivot < rows.size() && rows[pivot][column].is_zero()) { ++pivot; }
        if (pivot == rows.size()) { continue; }
        std::swap(rows[rank], rows[pivot]);
        for (std::size_t i = rank + 1; i < rows.size(); ++i) {
            if (rows[i][column].is_zero()) { continue; }
            const Number factor = rows[i][column] / rows[rank][column];
            for (std::size_t j = column; j < columns; ++j) {
                rows[i][j] = rows[i][j] - factor * rows[rank][j];
            }
        }
        ++rank;
    }
    return rank;
}

}  // namespace

std::optional<std::size_t> kinetic_rank(const System& system) {
    return on_new_ground([&](const Ground& ground) -> std::optional<std::size_t> {
        const auto K = kinetic_matrix(system, ground);
        return K ? std::optional(rank(*K)) : std::nullopt;
    });
}

void check_kinetic_rank(const System& system, const std::optional<Place>& place) {
    const auto rank = kinetic_rank(system);
    if (!rank || *rank == system.degrees_of_freedom()) { return; }
    throw MathError("with more nodes than functions (4.6e) determines p at the nodes only where "
                    "d2H/dp2 is regular, and its rank is " +
                        std::to_string(*rank) + " of " +
                        std::to_string(system.degrees_of_freedom()),
                    place, "take as many nodes as functions");
}

}  // namespace hvi::gen

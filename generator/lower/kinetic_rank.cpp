// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/kinetic_rank.hpp"

#include <arb_mat.h>

#include <string>
#include <utility>

#include "generator/exact/algebra/number_vector.hpp"
#include "generator/exact/expressions/evaluate.hpp"
#include "generator/graph/written.hpp"
#include "generator/lower/constancy.hpp"
#include "generator/scene/value_at.hpp"

namespace hvi::gen {
namespace {

std::optional<NumberMatrix> kinetic_matrix(const System& system, const Ground& ground) {
    NumberMatrix K;
    for (const std::vector<Scaled>& entries : system.hessian.conjugates) {
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

/// The matrix d2H/dp2 at a point, by enclosures.
struct MatrixOfBalls {
    explicit MatrixOfBalls(std::size_t size) { arb_mat_init(entries, slong(size), slong(size)); }
    MatrixOfBalls(const MatrixOfBalls&) = delete;
    MatrixOfBalls& operator=(const MatrixOfBalls&) = delete;
    ~MatrixOfBalls() { arb_mat_clear(entries); }

    arb_mat_t entries;
};

/// Whether it is proved to be regular at one of some points. Then it is at almost all.
bool is_regular_somewhere(const System& system) {
    constexpr std::size_t points = 3;
    const HessianBlock& pp = system.hessian.conjugates;
    for (std::size_t step = 0; step < points; ++step) {
        try {
            const SymbolValues point = sample_point(system.graph, step);
            MatrixOfBalls K(pp.size());
            for (std::size_t i = 0; i < pp.size(); ++i) {
                for (std::size_t j = 0; j < pp.size(); ++j) {
                    const auto text = written(system.graph, pp[i][j]);
                    if (!text) { return false; }
                    arb_set(arb_mat_entry(K.entries, slong(i), slong(j)),
                            value_at(*text, point, nullptr).get());
                }
            }
            Ball determinant;
            arb_mat_det(determinant.get(), K.entries, first_precision);
            if (arb_is_finite(determinant.get()) != 0 && determinant.sign() != 0) { return true; }
        } catch (const MathError&) { continue; }  // H is not defined there
    }
    return false;
}

std::optional<std::size_t> rank_with_free_symbols(const System& system) {
    return on_new_ground([&](const Ground& ground) -> std::optional<std::size_t> {
        const auto K = kinetic_matrix(system, ground);
        return K ? std::optional(rank(*K)) : std::nullopt;
    });
}

}  // namespace

std::optional<std::size_t> kinetic_rank(const System& system) {
    if (is_regular_somewhere(system)) { return system.degrees_of_freedom(); }
    try {
        return rank_with_free_symbols(system);
    } catch (const InputError&) { return std::nullopt; } catch (const MathError&) {
        return std::nullopt;
    }
}

void check_kinetic_rank(const System& system, const std::optional<Place>& place) {
    if (is_degenerate(system.hessian)) { return; }
    const auto rank = kinetic_rank(system);
    if (!rank || *rank == system.degrees_of_freedom()) { return; }
    throw MathError("with more nodes than functions (4.6e) determines p at the nodes only where "
                    "d2H/dp2 is regular, and its rank is " +
                        std::to_string(*rank) + " of " +
                        std::to_string(system.degrees_of_freedom()),
                    place, "take as many nodes as functions");
}

}  // namespace hvi::gen

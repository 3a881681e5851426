// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/linear/stage_gradients.hpp"

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/algebra/resolvent.hpp"
#include "generator/exact/numbers/rational.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

constexpr const char* what_helps = "`stepper` solves for the stages in each step";

/// NOTE: beyond these limits it takes minutes, and nobody would read the map: it is a rational
/// function whose degree is the number of unknowns.
constexpr std::size_t most_unknowns = 128;
constexpr std::size_t most_terms_of_method = 1000;
constexpr std::size_t most_terms = 1000000;

void check_closed_form(const Number& number, const std::string& what) {
    if (is_exact(number)) { return; }
    throw MathError(what + " has no closed form, and so the map of one step has none", {},
                    what_helps);
}

void check_closed_forms(const NumberMatrix& matrix, const std::string& name) {
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        for (std::size_t j = 0; j < matrix[i].size(); ++j) {
            check_closed_form(matrix[i][j], name + "[" + std::to_string(i + 1) + "][" +
                                                std::to_string(j + 1) + "]");
        }
    }
}

}  // namespace

StageFunctions exact_stage_functions(const Tableau& tableau, const QuadraticForm& H) {
    for (const NumberVector& row : bordered(H)) {
        for (const Number& entry : row) {
            check_closed_form(entry, "a coefficient of the Hamiltonian");
        }
    }
    StageFunctions stages = stage_functions(tableau);
    check_closed_forms(stages.A, "A");
    check_closed_forms(stages.A_tilde, "A_tilde");
    check_closed_forms({stages.b}, "b");
    if (term_count(stages) > most_terms_of_method) {
        throw MathError("the coefficients of the method are too long for its map in closed form",
                        {}, what_helps);
    }
    return stages;
}

NumberMatrix lower_half_up(std::size_t n) {
    return stacked(beside(zeros(n, n), identity(n)), zeros(n, 2 * n));
}

NumberMatrix upper_half_down(std::size_t n) { return transpose(lower_half_up(n)); }

NumberMatrix StageGradients::weighted(const NumberMatrix& weights, const Number& h) const {
    std::vector<NumberMatrix> sums;
    for (const NumberMatrix& coefficient : numerator) { sums.push_back(weights * coefficient); }
    return polynomial(sums, h);
}

StageGradients stage_gradients(const NumberMatrix& S, const StageFunctions& stages,
                               const NumberMatrix& C) {
    const std::size_t unknowns = S.size() * stages.count();
    if (unknowns > most_unknowns) {
        throw MathError("the map of one step is too long: its stages couple " +
                            std::to_string(unknowns) + " unknowns, more than " +
                            std::to_string(most_unknowns),
                        {}, what_helps);
    }
    const NumberMatrix up = lower_half_up(S.size() / 2);
    const NumberMatrix down = transpose(up);
    const NumberMatrix SL = kronecker(S * up, stages.A) + kronecker(S * down, C);
    const NumberMatrix ones = kronecker(identity(S.size()), transpose({stages.one}));
    Resolvent K = resolvent(SL * Number(-1), ones, most_terms);
    return {kronecker(up, stages.A) + kronecker(down, C), std::move(K.numerator),
            std::move(K.determinant)};
}

}  // namespace hvi::gen

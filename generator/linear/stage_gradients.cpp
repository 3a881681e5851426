// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/linear/stage_gradients.hpp"

#include <utility>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/algebra/resolvent.hpp"
#include "generator/exact/numbers/budget.hpp"
#include "generator/exact/numbers/rational.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

constexpr const char* what_helps = "`stepper` solves for the stages in each step";

/// NOTE: beyond these limits it takes minutes, and nobody would read the map: it is a rational
/// function whose degree is the number of unknowns.
constexpr std::size_t most_unknowns = 128;
constexpr std::size_t most_unknowns_of_rule = 72;
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

StageFunctions checked(StageFunctions stages, const QuadraticForm& H) {
    for (const NumberVector& row : bordered(H)) {
        for (const Number& entry : row) {
            check_closed_form(entry, "a coefficient of the Hamiltonian");
        }
    }
    check_closed_forms(stages.A, "A");
    check_closed_forms(stages.A_tilde, "A_tilde");
    check_closed_forms({stages.b}, "b");
    if (term_count(stages) > most_terms_of_method) {
        throw MathError("the coefficients of the method are too long for its map in closed form",
                        {}, what_helps);
    }
    return stages;
}

/// Returns the rows of S for p, split into the columns for q and for p.
std::pair<NumberMatrix, NumberMatrix> pq_and_pp(const NumberMatrix& S) {
    const std::size_t n = S.size() / 2;
    const NumberMatrix columns = transpose(rows(S, n, 2 * n));
    return {transpose(rows(columns, 0, n)), transpose(rows(columns, n, 2 * n))};
}

/// Returns -pp^-1 pq.
NumberMatrix momenta_by_positions(const NumberMatrix& S) {
    const auto [pq, pp] = pq_and_pp(S);
    const auto known = inverse(pp);
    if (!known) {
        throw MathError(
            "with more nodes than functions (4.6e) determines p at the nodes only where "
            "d2H/dp2 is regular",
            {}, "take as many nodes as functions");
    }
    return known->adjugate * pq * (Number(-1) / known->determinant);
}

/// Returns the lower right block of L.
NumberMatrix momenta_by_velocities(const NumberMatrix& S, const StageFunctions& stages) {
    const std::size_t half = S.size() / 2 * stages.count();
    return stages.outside.empty() ? zeros(half, half)
                                  : kronecker(momenta_by_positions(S), stages.outside);
}

NumberMatrix stages_by_gradients(const NumberMatrix& S, const StageFunctions& stages,
                                 const NumberMatrix& C) {
    const NumberMatrix I = identity(S.size() / 2);
    const NumberMatrix by_W = kronecker(I, C);
    return stacked(beside(zeros(by_W.size(), by_W.size()), kronecker(I, stages.A)),
                   beside(by_W, momenta_by_velocities(S, stages)));
}

void check_size(std::size_t unknowns, const StageFunctions& stages) {
    if (!stages.outside.empty() && unknowns > most_unknowns_of_rule) { throw TooLarge(); }
    if (unknowns <= most_unknowns) { return; }
    throw MathError("the map of one step is too long: its stages couple " +
                        std::to_string(unknowns) + " unknowns, more than " +
                        std::to_string(most_unknowns),
                    {}, what_helps);
}

}  // namespace

StageFunctions exact_stage_functions(const Tableau& tableau, const QuadraticForm& H) {
    return checked(stage_functions(tableau), H);
}

StageFunctions exact_stage_functions(const GalerkinRule& rule, const QuadraticForm& H) {
    return checked(stage_functions(rule), H);
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
    check_size(S.size() * stages.count(), stages);
    NumberMatrix L = stages_by_gradients(S, stages, C);
    const NumberMatrix ones = kronecker(identity(S.size()), transpose({stages.one}));
    Resolvent K =
        resolvent(kronecker(S, identity(stages.count())) * L * Number(-1), ones, most_terms);
    return {std::move(L), std::move(K.numerator), std::move(K.determinant)};
}

}  // namespace hvi::gen

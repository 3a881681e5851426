// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/stage_functions.hpp"

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/algebra/polynomial_arithmetic.hpp"
#include "generator/exact/methods/polynomial_stages.hpp"

namespace hvi::gen {

namespace {

StageFunctions by_values(const ButcherPair& pair) {
    const std::size_t s = pair.stages();
    NumberMatrix gram(s, NumberVector(s));
    for (std::size_t i = 0; i < s; ++i) { gram[i][i] = pair.b[i]; }
    return {pair.A, pair.A_tilde, NumberVector(s, Number(1)), pair.b, std::move(gram)};
}

StageFunctions by_powers(const PolynomialStages& stages) {
    const auto s = static_cast<std::size_t>(stages.count());
    const auto coordinates = [&](const RationalPolynomial& g) {
        NumberVector result = numbers(g);
        result.resize(s);
        return result;
    };
    NumberMatrix A_columns, A_tilde_columns, gram;
    for (long k = 0; k < stages.count(); ++k) {
        A_columns.push_back(coordinates(stages.apply(Colour::f, stages.power(k), 1)));
        A_tilde_columns.push_back(coordinates(stages.apply(Colour::g, stages.power(k), 1)));
        NumberVector& row = gram.emplace_back();
        for (long m = 0; m < stages.count(); ++m) {
            row.push_back(coordinates(stages.moment(k + m)).front());
        }
    }
    return {transpose(A_columns), transpose(A_tilde_columns), coordinates(stages.one()),
            gram.front(), gram};
}

}  // namespace

StageFunctions stage_functions(const Tableau& tableau) {
    const RationalPolynomial* const P = tableau.node_polynomial();
    return P != nullptr ? by_powers(PolynomialStages(*P)) : by_values(tableau);
}

std::size_t term_count(const StageFunctions& stages) {
    return term_count(stages.A) + term_count(stages.A_tilde);
}

}  // namespace hvi::gen

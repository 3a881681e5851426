// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/stage_functions.hpp"

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/algebra/polynomial_arithmetic.hpp"
#include "generator/exact/methods/number_stages.hpp"
#include "generator/exact/methods/polynomial_stages.hpp"
#include "generator/exact/methods/projected_stages.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

NumberMatrix diagonal(const NumberVector& entries) {
    NumberMatrix result(entries.size(), NumberVector(entries.size()));
    for (std::size_t i = 0; i < entries.size(); ++i) { result[i][i] = entries[i]; }
    return result;
}

/// Returns the matrix whose columns are the images of x^k for k < size.
template <class Image>
NumberMatrix matrix_of(Image image, std::size_t size) {
    NumberMatrix columns;
    RationalPolynomial power(1);
    for (std::size_t k = 0; k < size; ++k) {
        columns.push_back(numbers(image(power)));
        columns.back().resize(size);
        power = power * RationalPolynomial::variable();
    }
    return transpose(columns);
}

/// Returns the functions in the basis 1, x, ..., x^(s-1) modulo P, the nodes' polynomial.
template <class Stages>
StageFunctions by_powers(const Stages& stages, const RationalPolynomial& P) {
    const auto s = static_cast<std::size_t>(stages.count());
    const auto with = [&](Colour colour) {
        return matrix_of([&](const auto& g) { return stages.apply(colour, g, 1); }, s);
    };
    const RationalMatrix H = moments(P, s);
    StageFunctions result;
    result.A = with(Colour::f);
    result.A_tilde = with(Colour::g);
    result.one = NumberVector(s);
    result.one.front() = Number(1);
    result.gram =
        matrix_of([&](const auto& g) { return polynomial(coefficient_rows({g}, s) * H); }, s);
    result.b = result.gram.front();
    return result;
}

StageFunctions by_values(const NumberMatrix& A, const NumberMatrix& A_tilde,
                         const NumberVector& b) {
    return {A, A_tilde, NumberVector(b.size(), Number(1)), b, diagonal(b), {}};
}

StageFunctions by_powers(const RationalRule& rule) {
    const ProjectedStages stages(rule);
    StageFunctions result = by_powers(stages, rule.P);
    result.outside = matrix_of(
        [&](const RationalPolynomial& g) {
            const RationalPolynomial integral = stages.apply(Colour::f, g, 1);
            return integral - stages.projected(integral);
        },
        result.count());
    return result;
}

StageFunctions by_values(const GalerkinRule& rule) {
    const PartitionedMethod method = partitioned_method(rule);
    StageFunctions result = by_values(method.A, method.A_tilde, method.b);
    const auto known = inverse(rule.gram);
    HVI_CHECK(known);
    const NumberMatrix projection = transpose(rule.Psi) * known->adjugate * rule.Psi *
                                    diagonal(rule.b) * (Number(-1) / known->determinant);
    result.outside = result.A + projection * result.A;
    return result;
}

}  // namespace

StageFunctions stage_functions(const Tableau& tableau) {
    const RationalPolynomial* const P = tableau.node_polynomial();
    return P != nullptr ? by_powers(PolynomialStages(*P), *P)
                        : by_values(tableau.A, tableau.A_tilde, tableau.b);
}

StageFunctions stage_functions(const GalerkinRule& rule) {
    return rule.over_rationals ? by_powers(*rule.over_rationals) : by_values(rule);
}

std::size_t term_count(const StageFunctions& stages) {
    return term_count(stages.A) + term_count(stages.A_tilde) + term_count(stages.outside);
}

}  // namespace hvi::gen

// Any coefficients: over Q by determinants, else by the resolvent of the stages.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <limits>
#include <utility>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/algebra/rational_matrix.hpp"
#include "generator/exact/algebra/resolvent.hpp"
#include "generator/exact/methods/even_map.hpp"

namespace hvi::gen {

namespace {

// ---- by the resolvent ----

Number dot(const NumberVector& left, const NumberVector& right) {
    return (NumberMatrix{left} * right).front();
}

/// Returns whether exact arithmetic with products of the coefficients would take minutes.
bool are_too_long(const PartitionedMethod& method) {
    constexpr std::size_t most_terms = 2000;
    for (const NumberMatrix* matrix : {&method.A, &method.A_tilde}) {
        for (const NumberVector& row : *matrix) {
            const bool parameters = std::any_of(row.begin(), row.end(),
                                                [](const Number& a) { return a.has_parameters(); });
            if (parameters) { return false; }
        }
    }
    return term_count(method.A) + term_count(method.A_tilde) > most_terms;
}

/// Returns the map by the stages P = (I + t A~ A)^-1 (p 1 - z omega q c~) and omega Q = omega q 1 +
/// z A P. The step is omega q1 = omega q + z b P, p1 = p - z b~ omega Q.
EvenMap by_stages(const PartitionedMethod& method, PolynomialArithmetic& arithmetic) {
    const bool too_long = are_too_long(method);
    const NumberMatrix A = too_long ? without_closed_form(method.A) : method.A;
    const NumberMatrix A_tilde = too_long ? without_closed_form(method.A_tilde) : method.A_tilde;
    const NumberVector& b = method.b;
    const NumberVector& b_tilde = method.b_tilde;
    const NumberVector ones(method.stages(), Number(1));
    const NumberVector bA = transpose(A) * b_tilde;
    const NumberVector c_tilde = A_tilde * ones;
    const Resolvent P =
        resolvent(A_tilde * A, transpose({c_tilde, ones}), std::numeric_limits<std::size_t>::max());
    const NumberPolynomial& D = P.determinant;
    const auto form = [&](const NumberVector& u, std::size_t column) {
        NumberPolynomial result;
        for (const NumberMatrix& numerator : P.numerator) {
            result.push_back(dot(u, transpose(numerator)[column]));
        }
        return result;
    };
    const Number minus(-1);
    return {arithmetic.sum(D, minus, shifted(form(b, 0))), arithmetic.trimmed(form(b, 1)),
            arithmetic.sum(shifted(form(bA, 0)), -dot(b_tilde, ones), D),
            arithmetic.sum(D, minus, shifted(form(bA, 1))), arithmetic.trimmed(D)};
}

// ---- by determinants ----

/// Returns t P(t).
RationalPolynomial shifted(const RationalPolynomial& polynomial) {
    return polynomial * RationalPolynomial::variable();
}

/// Returns the map by the equations of by_stages, with u (I + t B)^-1 v det(I + t B) = det(I + t B
/// + v u^T) - det(I + t B). Empty where a coefficient is not rational.
std::optional<EvenMap> by_determinants(const PartitionedMethod& method) {
    const auto A = rational_matrix(method.A);
    const auto A_tilde = rational_matrix(method.A_tilde);
    const auto b = rational_matrix({method.b});
    const auto b_tilde = rational_matrix({method.b_tilde});
    if (!A || !A_tilde || !b || !b_tilde) { return std::nullopt; }
    const std::size_t s = method.stages();
    RationalMatrix one(s, s), ones(s, 1);
    fmpq_mat_one(one.get());
    for (std::size_t i = 0; i < s; ++i) { fmpq_one(ones.entry(i, 0)); }
    const RationalMatrix B = *A_tilde * *A;
    const RationalMatrix c_tilde = *A_tilde * ones;
    const RationalMatrix bA = *b_tilde * *A;
    const RationalPolynomial D = determinant_of_pencil(one, B);
    const auto form = [&](const RationalMatrix& u, const RationalMatrix& v) {
        RationalMatrix X = v * u;
        fmpq_mat_add(X.get(), X.get(), one.get());
        return determinant_of_pencil(X, B) - D;
    };
    RationalPolynomial sum;
    RationalMatrix weights = *b_tilde * ones;
    fmpq_poly_scalar_mul_fmpq(sum.get(), D.get(), weights.entry(0, 0));
    return EvenMap{numbers(D - shifted(form(*b, c_tilde))), numbers(form(*b, ones)),
                   numbers(shifted(form(bA, c_tilde)) - sum), numbers(D - shifted(form(bA, ones))),
                   numbers(D)};
}

}  // namespace

EvenMap even_map(const PartitionedMethod& method, PolynomialArithmetic& arithmetic) {
    if (auto map = by_determinants(method)) { return *std::move(map); }
    return by_stages(method, arithmetic);
}

}  // namespace hvi::gen

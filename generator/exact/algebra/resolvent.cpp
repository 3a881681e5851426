// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/algebra/resolvent.hpp"

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/algebra/polynomial_arithmetic.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

Number trace(const NumberMatrix& matrix) {
    Number sum;
    for (std::size_t i = 0; i < matrix.size(); ++i) { sum = sum + matrix[i][i]; }
    return sum;
}

/// Returns scalar * I - matrix.
NumberMatrix scalar_minus(const Number& scalar, NumberMatrix matrix) {
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        for (Number& entry : matrix[i]) { entry = -entry; }
        matrix[i][i] = matrix[i][i] + scalar;
    }
    return matrix;
}

void check_length(const NumberMatrix& matrix, std::size_t most_terms) {
    if (term_count(matrix) <= most_terms) { return; }
    throw MathError("the equations of the stages have a solution of more than " +
                        std::to_string(most_terms) + " terms",
                    {}, "give some of the parameters a value with --param");
}

}  // namespace

Resolvent resolvent(const NumberMatrix& B, const NumberMatrix& V, std::size_t most_terms) {
    Resolvent result{{Number(1)}, {}};
    NumberMatrix N = identity(B.size());
    for (std::size_t k = 1; k <= B.size(); ++k) {
        result.numerator.push_back(N * V);
        N = B * N;
        const Number e = trace(N) / Number(static_cast<long>(k));
        result.determinant.push_back(e);
        N = scalar_minus(e, std::move(N));
        check_length(N, most_terms);
    }
    return result;
}

}  // namespace hvi::gen

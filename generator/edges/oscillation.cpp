// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/edges/oscillation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hvi::gen {

namespace {

/// Exactly.
Number number(double value) {
    int exponent = 0;
    Number result(static_cast<long>(std::ldexp(std::frexp(value, &exponent), 53)));
    for (exponent -= 53; exponent < 0; ++exponent) result = result / Number(2);
    for (; exponent > 0; --exponent) result = result * Number(2);
    return result;
}

Number at(const NumberVector& polynomial, const Number& z) {
    Number value(0);
    for (auto k = polynomial.rbegin(); k != polynomial.rend(); ++k) value = value * z + *k;
    return value;
}

bool in_intervals(const LinearStability& stability, const Number& z) {
    return std::any_of(stability.stable.begin(), stability.stable.end(), [&](const auto& interval) {
        return (z - interval.low).sign() > 0 && (interval.high - z).sign() > 0;
    });
}

/// Of Frobenius.
double norm(const OscillatorMap& map, const Number& z) {
    const Number D = at(map.D, z);
    double sum = 0;
    for (const NumberVector* entry : {&map.m11, &map.m12, &map.m21, &map.m22}) {
        const double value = (at(*entry, z) / D).nearest_double();
        sum += value * value;
    }
    return std::sqrt(sum);
}

using Matrix = std::vector<std::vector<double>>;

Matrix product(const Matrix& A, const Matrix& B) {
    Matrix C(A.size(), std::vector<double>(A.size(), 0.0));
    for (std::size_t i = 0; i < A.size(); ++i)
        for (std::size_t k = 0; k < A.size(); ++k)
            for (std::size_t j = 0; j < A.size(); ++j) C[i][j] += A[i][k] * B[k][j];
    return C;
}

Matrix rounded(const NumberMatrix& A) {
    Matrix result;
    for (const NumberVector& row : A) {
        result.emplace_back();
        for (const Number& entry : row) result.back().push_back(entry.nearest_double());
    }
    return result;
}

double largest(const Matrix& A) {
    double result = 0;
    for (const auto& row : A)
        for (const double entry : row) result = std::max(result, std::abs(entry));
    return result;
}

}  // namespace

// With determinant 1, R^n = U_(n-1)(t) R - U_(n-2)(t) where t is half the trace and U are the
// polynomials of Chebyshev of the second kind: |U| <= 1/sqrt(1 - t^2) where |t| < 1. Where |t| > 1
// the larger eigenvalue is |t| + sqrt(t^2 - 1).
Oscillation oscillation(const Certificate& certificate, double z) {
    const Number argument = number(z);
    const OscillatorMap& map = *certificate.oscillator;
    const Number t =
        at(map.half_trace.numerator, argument) / at(map.half_trace.denominator, argument);
    const Number rest = Number(1) - t * t;
    const bool is_near = z < static_cast<double>(certificate.stability->until);
    Oscillation result;
    result.is_stable = is_near ? in_intervals(*certificate.stability, argument) : rest.sign() > 0;
    const double root = std::sqrt(std::abs(rest.nearest_double()));
    result.bound = result.is_stable ? (norm(map, argument) + 1) / root
                                    : std::numeric_limits<double>::infinity();
    if (!result.is_stable) result.growth = std::log10(std::abs(t.nearest_double()) + root);
    return result;
}

// Gelfand: |M^n|^(1/n), for n = 2^12.
double contraction(const Tableau& tableau) {
    Matrix M = product(rounded(tableau.A), rounded(tableau.A_tilde));
    double logarithm = 0, weight = 1;
    for (int k = 0; k <= 12; ++k) {
        const double size = largest(M);
        if (size == 0) return 0;
        logarithm += weight * std::log(size);
        weight /= 2;
        for (auto& row : M)
            for (double& entry : row) entry /= size;
        M = product(M, M);
    }
    return std::exp(logarithm);
}

}  // namespace hvi::gen

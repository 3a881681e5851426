// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/edges/oscillation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "generator/certify/certificate.hpp"
#include "generator/exact/methods/rule_properties.hpp"
#include "generator/exact/numbers/exact_number.hpp"

namespace hvi::gen {

namespace {

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

/// Returns the Frobenius norm.
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

/// Solves M^T y = w by Gauss' elimination.
std::vector<double> solved_transposed(const Matrix& M, std::vector<double> w) {
    const std::size_t n = w.size();
    Matrix rows(n, std::vector<double>(n));
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) rows[i][j] = M[j][i];
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < n; ++i)
            if (std::abs(rows[i][k]) > std::abs(rows[pivot][k])) pivot = i;
        std::swap(rows[k], rows[pivot]);
        std::swap(w[k], w[pivot]);
        for (std::size_t i = k + 1; i < n; ++i) {
            const double factor = rows[i][k] / rows[k][k];
            for (std::size_t j = k; j < n; ++j) rows[i][j] -= factor * rows[k][j];
            w[i] -= factor * w[k];
        }
    }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t j = k + 1; j < n; ++j) w[k] -= rows[k][j] * w[j];
        w[k] /= rows[k][k];
    }
    return w;
}

double sum_of_sizes(const std::vector<double>& row) {
    return std::accumulate(row.begin(), row.end(), 0.0,
                           [](double sum, double entry) { return sum + std::abs(entry); });
}

/// Returns the spectral radius of A A~.
double contraction(const PartitionedMethod& method) {
    Matrix M = product(rounded(method.A), rounded(method.A_tilde));
    // By Gelfand's formula: |M^n|^(1/n), for n = 2^12.
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

/// Returns the largest |gamma|.
double largest_part(const std::optional<Composition>& composition) {
    if (!composition) return 1;
    double result = 0;
    for (const Number& gamma : composition->steps)
        result = std::max(result, std::abs(gamma.nearest_double()));
    return result;
}

KnownOscillator known_of(const Tableau& tableau) {
    const PartitionedMethod own = partitioned_method(tableau);
    return {{}, oscillator_map(tableau), {}, own, contraction(own)};
}

KnownOscillator known_of(const GalerkinRule& rule) {
    const PartitionedMethod own = partitioned_method(rule);
    return {{}, oscillator_map(rule), {}, own, contraction(own)};
}

}  // namespace

// NOTE: A A~ of the adjoint is similar to the transpose of the method's A A~.
KnownOscillator known_oscillator(const ExactMethod& method) {
    KnownOscillator known =
        std::visit([](const auto& derived) { return known_of(derived); }, method.base);
    known.method = method.name();
    if (const auto& composition = method.composition) {
        known.map = composed(known.map, *composition);
        known.stages = partitioned_method(
            composed(weighted_stages(std::get<Tableau>(method.base)), *composition));
        known.contraction *= std::pow(largest_part(composition), 2);
    }
    known.stability = linear_stability(known.map, stability_limit);
    return known;
}

// For determinant 1, R^n = U_(n-1)(t) R - U_(n-2)(t), where t is half the trace and U are the
// Chebyshev polynomials of the second kind: |U| <= 1/sqrt(1 - t^2) where |t| < 1. Where |t| > 1 the
// larger eigenvalue is |t| + sqrt(t^2 - 1).
Oscillation oscillation(const KnownOscillator& known, double z) {
    const Number argument = exact_number(z);
    const OscillatorMap& map = known.map;
    const Number t =
        at(map.half_trace.numerator, argument) / at(map.half_trace.denominator, argument);
    const Number rest = Number(1) - t * t;
    const bool is_near = z < static_cast<double>(known.stability.until);
    Oscillation result;
    result.is_stable = is_near ? in_intervals(known.stability, argument) : rest.sign() > 0;
    const double root = std::sqrt(std::abs(rest.nearest_double()));
    result.bound = result.is_stable ? (norm(map, argument) + 1) / root
                                    : std::numeric_limits<double>::infinity();
    if (!result.is_stable) result.growth = std::log10(std::abs(t.nearest_double()) + root);
    return result;
}

// Stages are Y = 1 omega q + z A P and P = 1 p - z A~ Y + h A~ g. Forces g then add z b^T A~ K h g
// to omega q and b~^T K h g to p, where K is the inverse of 1 + z^2 A A~.
double response(const PartitionedMethod& method, double z) {
    const Matrix A_tilde = rounded(method.A_tilde);
    Matrix M = product(rounded(method.A), A_tilde);
    for (std::size_t i = 0; i < M.size(); ++i)
        for (std::size_t j = 0; j < M.size(); ++j) M[i][j] = z * z * M[i][j] + (i == j ? 1 : 0);
    const std::vector<double> b = rounded({method.b}).front();
    std::vector<double> zbA(b.size(), 0.0);
    for (std::size_t i = 0; i < b.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) zbA[j] += z * b[i] * A_tilde[i][j];
    return std::hypot(sum_of_sizes(solved_transposed(M, zbA)),
                      sum_of_sizes(solved_transposed(M, rounded({method.b_tilde}).front())));
}

}  // namespace hvi::gen

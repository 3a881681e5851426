// Rotations in long double, by the series of their exponentials.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace flow_test {

using Wide = long double;
using WideVector = std::array<Wide, 3>;
using WideMatrix = std::array<WideVector, 3>;

inline Wide widened(double number) { return static_cast<Wide>(number); }

inline WideMatrix times(const WideMatrix& a, const WideMatrix& b) {
    WideMatrix c{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            for (std::size_t k = 0; k < 3; ++k) { c[i][j] += a[i][k] * b[k][j]; }
        }
    }
    return c;
}

/// Returns exp(hat(v)) by its series, through that of v/1024.
inline WideMatrix exponential(const WideVector& v) {
    const auto [x, y, z] = v;
    const Wide part = 1 / 1024.0L;
    const WideMatrix hat{
        {{0, -z * part, y * part}, {z * part, 0, -x * part}, {-y * part, x * part, 0}}};
    const WideMatrix one{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    WideMatrix sum = one, term = one;
    for (int n = 1; n < 30; ++n) {
        term = times(term, hat);
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                term[i][j] /= n;
                sum[i][j] += term[i][j];
            }
        }
    }
    for (int k = 0; k < 10; ++k) { sum = times(sum, sum); }
    return sum;
}

template <class Numbers>
WideMatrix matrix_of(const Numbers& R) {
    WideMatrix result;
    for (std::size_t e = 0; e < 9; ++e) { result[e / 3][e % 3] = widened(R[e]); }
    return result;
}

/// Returns the largest entry of R R^T - 1.
template <class Numbers>
double defect_of(const Numbers& R) {
    double defect = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            Wide sum = i == j ? -1 : 0;
            for (std::size_t k = 0; k < 3; ++k) {
                sum += widened(R[3 * i + k]) * widened(R[3 * j + k]);
            }
            defect = std::max(defect, static_cast<double>(std::abs(sum)));
        }
    }
    return defect;
}

}  // namespace flow_test

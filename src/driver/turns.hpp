// Derivatives of rotations in dual numbers, as turns of the body.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

namespace hvi::driver {

/// Sets part i of the nine entries of R, row by row, to that of the turn R exp(hat theta):
///
///     dR = R hat(theta).
template <class Number>
void set_turn(Number* R, std::size_t i, const std::array<double, 3>& theta) {
    for (std::size_t row = 0; row < 9; row += 3) {
        for (std::size_t a = 0; a < 3; ++a) {
            const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
            R[row + a].by[i] = R[row + b].value * theta[c] - R[row + c].value * theta[b];
        }
    }
}

/// Returns theta of the turn in part i of R: entries c, b of R^T dR.
template <class Number>
[[nodiscard]] std::array<double, 3> turn_of(const Number* R, std::size_t i) {
    std::array<double, 3> theta{};
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
        for (std::size_t row = 0; row < 9; row += 3) {
            theta[a] += R[row + c].value * R[row + b].by[i];
        }
    }
    return theta;
}

}  // namespace hvi::driver

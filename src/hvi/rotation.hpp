// Rotations as quaternions, and as matrices.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace hvi {

/// Returns the rotation matrix, row by row, of a quaternion w, x, y, z of any length but 0.
/// # Use
/// The members R of states of scenes with rotations take body to space. rotation_of() makes such a
/// matrix from a quaternion; quaternion_of() gives the quaternion of length 1 with w >= 0 that is
/// nearest to a matrix. A rotation of `angle` radians about an axis of length 1 is (cos(angle/2),
/// sin(angle/2) axis). Both functions are right to a few units in the last place of 1. A quaternion
/// of zeros, or one with a NaN, gives NaN.
/// ```cpp
/// #include <array>
/// #include <cmath>
/// #include <cstddef>
///
/// #include <hvi/rotation.hpp>
///
/// int main() {
///     const std::array<double, 4> turn{std::cos(0.5), 0, 0, std::sin(0.5)};  // by 1 about z
///     const std::array<double, 9> R = hvi::rotation_of(turn);
///     double error = std::abs(R[0] - std::cos(1)) + std::abs(R[3] - std::sin(1));
///     const std::array<double, 4> back = hvi::quaternion_of(R);
///     for (std::size_t k = 0; k < 4; ++k) { error += std::abs(back[k] - turn[k]); }
///     return error < 1e-15 ? 0 : 1;
/// }
/// ```
template <class Scalar>
[[nodiscard]] std::array<Scalar, 9> rotation_of(const std::array<Scalar, 4>& quaternion) {
    const auto& [w, x, y, z] = quaternion;
    const Scalar s = Scalar(2) / (w * w + x * x + y * y + z * z);
    return {1 - s * (y * y + z * z), s * (x * y - w * z),     s * (x * z + w * y),
            s * (x * y + w * z),     1 - s * (x * x + z * z), s * (y * z - w * x),
            s * (x * z - w * y),     s * (y * z + w * x),     1 - s * (x * x + y * y)};
}

/// Returns the quaternion w, x, y, z of a rotation; see rotation_of().
///
/// NOTE: computed from the row with the largest of 4 w^2, 4 x^2, 4 y^2 and 4 z^2, as the others may
/// be small differences (Shepperd, Journal of Guidance and Control 1, 1978).
template <class Scalar>
[[nodiscard]] std::array<Scalar, 4> quaternion_of(const std::array<Scalar, 9>& R) {
    using std::sqrt;
    const Scalar trace = R[0] + R[4] + R[8];
    std::array<Scalar, 4> q{};
    if (trace >= R[0] && trace >= R[4] && trace >= R[8]) {
        q = {1 + trace, R[7] - R[5], R[2] - R[6], R[3] - R[1]};
    } else if (R[0] >= R[4] && R[0] >= R[8]) {
        q = {R[7] - R[5], 1 + 2 * R[0] - trace, R[1] + R[3], R[2] + R[6]};
    } else if (R[4] >= R[8]) {
        q = {R[2] - R[6], R[1] + R[3], 1 + 2 * R[4] - trace, R[5] + R[7]};
    } else {
        q = {R[3] - R[1], R[2] + R[6], R[5] + R[7], 1 + 2 * R[8] - trace};
    }
    Scalar length = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (q[0] < 0) { length = -length; }
    for (Scalar& part : q) { part /= length; }
    return q;
}

}  // namespace hvi

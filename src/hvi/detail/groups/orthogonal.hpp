// Distance of a matrix from rotations, and its correction.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <hvi/detail/groups/space.hpp>
#include <hvi/detail/numbers/arithmetic.hpp>

namespace hvi::detail {

/// Returns R^T R - 1, which is symmetric.
template <class Scalar>
[[nodiscard]] constexpr Matrix3<Scalar> orthogonality_defect(const Matrix3<Scalar>& R) {
    Matrix3<Scalar> E{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            E[3 * i + j] =
                R[i] * R[j] + R[3 + i] * R[3 + j] + R[6 + i] * R[6 + j] - Scalar(i == j ? 1 : 0);
            E[3 * j + i] = E[3 * i + j];
        }
    }
    return E;
}

/// Returns -R E/2, for E = R^T R - 1: R plus this is orthogonal but for E^2. The correction
/// commutes with rotations from the left, as an equivariant step must. As E is symmetric, it turns
/// R by no more than E^2.
template <class Scalar>
[[nodiscard]] constexpr Matrix3<Scalar> way_to_rotation(const Matrix3<Scalar>& R) {
    Matrix3<Scalar> way = product(R, orthogonality_defect(R));
    for (Scalar& entry : way) { entry = Scalar(-0.5) * entry; }
    return way;
}

/// Returns whether R is a rotation to half of the digits, relative to its largest entry: the
/// derivatives in dual numbers may be large.
template <class Scalar>
[[nodiscard]] bool is_rotation(const Matrix3<Scalar>& R) {
    Scalar most = 1;
    for (const Scalar& entry : R) { most = larger(most, abs(entry)); }
    most *= power_of_two<Scalar>(-bits<Scalar> / 2);
    bool is_near = determinant(R) > 0;
    for (const Scalar& entry : orthogonality_defect(R)) { is_near = is_near && abs(entry) <= most; }
    return is_near;
}

}  // namespace hvi::detail

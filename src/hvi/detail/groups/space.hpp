// Vectors and matrices of space.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

/// Attribute of functions on vectors of space that sweeps call, so that vectors stay in registers.
/// NOTE: measured on free-rigid-body and heavy-top with two to six stages: g++ 12 by itself does
/// not inline all calls, and a sweep then takes twice as long.
#if defined(__GNUC__)
#define HVI_INLINE_IN_SPACE [[gnu::always_inline]]
#else
#define HVI_INLINE_IN_SPACE
#endif

namespace hvi::detail {

template <class Scalar>
using Vector3 = std::array<Scalar, 3>;

/// A matrix, row by row.
template <class Scalar>
using Matrix3 = std::array<Scalar, 9>;

template <class Scalar>
HVI_INLINE_IN_SPACE [[nodiscard]] constexpr Vector3<Scalar> operator+(const Vector3<Scalar>& a,
                                                                      const Vector3<Scalar>& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

template <class Scalar>
HVI_INLINE_IN_SPACE [[nodiscard]] constexpr Vector3<Scalar> operator-(const Vector3<Scalar>& a,
                                                                      const Vector3<Scalar>& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class Scalar>
HVI_INLINE_IN_SPACE [[nodiscard]] constexpr Vector3<Scalar> operator*(const Scalar& factor,
                                                                      const Vector3<Scalar>& a) {
    return {factor * a[0], factor * a[1], factor * a[2]};
}

template <class Scalar>
HVI_INLINE_IN_SPACE [[nodiscard]] constexpr Scalar dot(const Vector3<Scalar>& a,
                                                       const Vector3<Scalar>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Scalar>
HVI_INLINE_IN_SPACE [[nodiscard]] constexpr Vector3<Scalar> cross(const Vector3<Scalar>& a,
                                                                  const Vector3<Scalar>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Returns R a.
template <class Scalar>
HVI_INLINE_IN_SPACE [[nodiscard]] constexpr Vector3<Scalar> times(const Matrix3<Scalar>& R,
                                                                  const Vector3<Scalar>& a) {
    return {R[0] * a[0] + R[1] * a[1] + R[2] * a[2], R[3] * a[0] + R[4] * a[1] + R[5] * a[2],
            R[6] * a[0] + R[7] * a[1] + R[8] * a[2]};
}

/// Returns R^T a.
template <class Scalar>
HVI_INLINE_IN_SPACE [[nodiscard]] constexpr Vector3<Scalar>
transposed_times(const Matrix3<Scalar>& R, const Vector3<Scalar>& a) {
    return {R[0] * a[0] + R[3] * a[1] + R[6] * a[2], R[1] * a[0] + R[4] * a[1] + R[7] * a[2],
            R[2] * a[0] + R[5] * a[1] + R[8] * a[2]};
}

/// Returns A B.
template <class Scalar>
HVI_INLINE_IN_SPACE [[nodiscard]] constexpr Matrix3<Scalar> product(const Matrix3<Scalar>& A,
                                                                    const Matrix3<Scalar>& B) {
    const auto entry = [&](std::size_t i, std::size_t j) {
        return A[3 * i] * B[j] + A[3 * i + 1] * B[3 + j] + A[3 * i + 2] * B[6 + j];
    };
    return {entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 0), entry(1, 1),
            entry(1, 2), entry(2, 0), entry(2, 1), entry(2, 2)};
}

template <class Scalar>
[[nodiscard]] constexpr Scalar determinant(const Matrix3<Scalar>& A) {
    return A[0] * (A[4] * A[8] - A[5] * A[7]) - A[1] * (A[3] * A[8] - A[5] * A[6]) +
           A[2] * (A[3] * A[7] - A[4] * A[6]);
}

}  // namespace hvi::detail

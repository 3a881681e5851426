// The natural chart of SO(3) at a rotation R_0.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/groups/entire_functions.hpp>
#include <hvi/detail/groups/space.hpp>

namespace hvi::detail {

/// A point xi of the natural chart of SO(3) (Leok & Zhang, 5.4): R = R_0 exp(hat xi), where hat xi
/// is the matrix of v -> xi x v. With x = |xi| and c_k of x^2, see AngleFunctions,
///
///     exp(hat xi) = 1 + c_1 hat xi + c_2 hat xi^2,
///     T = dexp_{-xi} = 1 - c_2 hat xi + c_3 hat xi^2,
///
/// and a velocity xi' of the chart is the angular velocity T xi' of the body. The momentum of the
/// chart is pi = T^T L, L being the angular momentum in the body. T is regular for x < 2 pi.
///
/// Vectors Omega = dH/dL and D, the derivative of H by rotations R exp(hat eta) of the body, give
///
///     w = dH/dpi = T^-1 Omega,       g = dH/dxi = T^T D - df/dxi for f = L . T(xi) w,
///
/// since L = T^-T pi moves with xi when pi stays: L . dT w is what H gains from dL.
template <class Scalar>
class ChartPoint {
public:
    using Vector = Vector3<Scalar>;

    /// Makes the centre R_0.
    ChartPoint() : ChartPoint(Vector{}) {}
    HVI_INLINE_IN_SPACE explicit ChartPoint(const Vector& xi)
        : xi_(xi),
          y_(dot(xi, xi)),
          c_(angle_functions(y_)),
          inverse_((c_.c3 - Scalar(2) * c_.c4) / (Scalar(2) * c_.c2)) {}

    [[nodiscard]] const Vector& xi() const { return xi_; }
    /// Returns the square of the angle of the turn.
    [[nodiscard]] Scalar square_of_angle() const { return y_; }

    /// Returns exp(hat xi) v - v.
    HVI_INLINE_IN_SPACE [[nodiscard]] Vector turned_by(const Vector& v) const {
        const Vector u = cross(xi_, v);
        return c_.c1 * u + c_.c2 * cross(xi_, u);
    }
    /// Returns exp(hat xi) v.
    HVI_INLINE_IN_SPACE [[nodiscard]] Vector turned(const Vector& v) const {
        return v + turned_by(v);
    }
    /// Returns exp(-hat xi) v.
    HVI_INLINE_IN_SPACE [[nodiscard]] Vector turned_back(const Vector& v) const {
        const Vector u = cross(xi_, v);
        return v - c_.c1 * u + c_.c2 * cross(xi_, u);
    }
    /// Returns exp(hat xi) - 1.
    HVI_INLINE_IN_SPACE [[nodiscard]] Matrix3<Scalar> turn() const {
        const Vector u = c_.c1 * xi_, v = c_.c2 * xi_;
        const Scalar xx = v[0] * xi_[0], yy = v[1] * xi_[1], zz = v[2] * xi_[2];
        const Scalar yz = v[1] * xi_[2], zx = v[2] * xi_[0], xy = v[0] * xi_[1];
        return {-yy - zz,  xy - u[2], zx + u[1],  //
                xy + u[2], -zz - xx,  yz - u[0],  //
                zx - u[1], yz + u[0], -xx - yy};
    }

    HVI_INLINE_IN_SPACE [[nodiscard]] Vector T(const Vector& v) const {
        const Vector u = cross(xi_, v);
        return v - c_.c2 * u + c_.c3 * cross(xi_, u);
    }
    HVI_INLINE_IN_SPACE [[nodiscard]] Vector T_transposed(const Vector& v) const {
        const Vector u = cross(xi_, v);
        return v + c_.c2 * u + c_.c3 * cross(xi_, u);
    }
    /// Returns T^-1 v. NOTE: c_2 is 0 at an angle of 2 pi.
    HVI_INLINE_IN_SPACE [[nodiscard]] Vector T_inverse(const Vector& v) const {
        const Vector u = cross(xi_, v);
        return v + half() * u + inverse_ * cross(xi_, u);
    }
    /// Returns T^-T v.
    HVI_INLINE_IN_SPACE [[nodiscard]] Vector T_inverse_transposed(const Vector& v) const {
        const Vector u = cross(xi_, v);
        return v - half() * u + inverse_ * cross(xi_, u);
    }

    /// Returns the gradient of L . T(xi) w by xi.
    HVI_INLINE_IN_SPACE [[nodiscard]] Vector gradient(const Vector& L, const Vector& w) const {
        const Vector k = cross(w, L);
        const Scalar u = dot(xi_, k), a = dot(L, xi_), b = dot(w, xi_), c = dot(L, w);
        const Scalar along =
            slope_of_c3() * (a * b - y_ * c) - slope_of_c2() * u - Scalar(2) * c_.c3 * c;
        return (c_.c3 * b) * L + (c_.c3 * a) * w - c_.c2 * k + along * xi_;
    }

    // ---- for Newton's method ----

    /// Returns the matrix of d(T w) by xi.
    [[nodiscard]] Matrix3<Scalar> derivative_of_T(const Vector& w) const {
        return derivative_of_T(w, Scalar(1));
    }
    /// Returns the matrix of d(T^T L) by xi. NOTE: T^T is T at -xi.
    [[nodiscard]] Matrix3<Scalar> derivative_of_T_transposed(const Vector& L) const {
        return derivative_of_T(L, Scalar(-1));
    }
    /// Returns the second derivatives of L . T(xi) w by xi.
    [[nodiscard]] Matrix3<Scalar> hessian(const Vector& L, const Vector& w) const {
        const Vector k = cross(w, L);
        const Scalar u = dot(xi_, k), a = dot(L, xi_), b = dot(w, xi_), c = dot(L, w);
        const Scalar v = a * b - y_ * c;
        const Vector by_v = b * L + a * w - (Scalar(2) * c) * xi_;
        // The second derivatives of c_2 and c_3 are slope + xi xi^T second.
        const Scalar second_of_c2 = Scalar(8) * c_.c6 - Scalar(5) * c_.c5 + c_.c4;
        const Scalar second_of_c3 = Scalar(15) * c_.c7 - Scalar(7) * c_.c6 + c_.c5;
        const Scalar twice = v * second_of_c3 - u * second_of_c2;
        const Scalar diagonal = v * slope_of_c3() - u * slope_of_c2() - Scalar(2) * c_.c3 * c;
        Matrix3<Scalar> result{};
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                result[3 * i + j] = twice * xi_[i] * xi_[j] + c_.c3 * (L[i] * w[j] + w[i] * L[j]) +
                                    slope_of_c3() * (xi_[i] * by_v[j] + by_v[i] * xi_[j]) -
                                    slope_of_c2() * (xi_[i] * k[j] + k[i] * xi_[j]) +
                                    (i == j ? diagonal : Scalar(0));
            }
        }
        return result;
    }

private:
    /// Returns 1/2. NOTE: lanes of long doubles take no double without a warning.
    [[nodiscard]] static Scalar half() { return Scalar(1) / Scalar(2); }
    /// Return dc_k by xi without its factor xi.
    [[nodiscard]] Scalar slope_of_c2() const { return Scalar(2) * c_.c4 - c_.c3; }
    [[nodiscard]] Scalar slope_of_c3() const { return Scalar(3) * c_.c5 - c_.c4; }

    [[nodiscard]] Matrix3<Scalar> derivative_of_T(const Vector& w, const Scalar& sign) const {
        const Vector u = cross(xi_, w), uu = cross(xi_, u);
        const Scalar b = dot(w, xi_);
        const Vector along = slope_of_c3() * uu - (sign * slope_of_c2()) * u;
        Matrix3<Scalar> result{};
        for (std::size_t j = 0; j < 3; ++j) {
            Vector unit{};
            unit[j] = Scalar(1);
            const Vector turn = cross(unit, w);
            for (std::size_t i = 0; i < 3; ++i) {
                result[3 * i + j] =
                    along[i] * xi_[j] - sign * c_.c2 * turn[i] +
                    c_.c3 * (xi_[i] * w[j] - Scalar(2) * xi_[j] * w[i] + (i == j ? b : Scalar(0)));
            }
        }
        return result;
    }

    Vector xi_;
    Scalar y_;
    AngleFunctions<Scalar> c_;
    Scalar inverse_;  ///< factor of hat xi^2 in T^-1 = 1 + hat xi/2 + ...: (1 - (x/2) cot(x/2))/x^2
};

/// Returns T^-1 v but for terms of |xi|^8, for starting values.
template <class Scalar>
HVI_INLINE_IN_SPACE [[nodiscard]] inline Vector3<Scalar>
nearly_T_inverse(const Vector3<Scalar>& xi, const Vector3<Scalar>& v) {
    const Vector3<Scalar> u = cross(xi, v);
    const Scalar y = dot(xi, xi);
    const Scalar next = Scalar(1) / Scalar(60) + y * (Scalar(1) / Scalar(2520));
    const Scalar inverse = (Scalar(1) + y * next) * (Scalar(1) / Scalar(12));
    return v + Scalar(1) / Scalar(2) * u + inverse * cross(xi, u);
}

/// Returns how often starting values solve xi' = T^-1 Omega for the Omega that are extrapolated,
/// beginning with xi' = Omega. Each time adds a power of h to the error of xi.
///
/// NOTE: measured on heavy-top and free-rigid-body with 2, 4 and 8 stages, h = 0.03 to 0.5: more of
/// them leave the number of sweeps as it is. Without them it does not fall with the number of
/// stages: gauss:8 takes 14.4 in place of 9.1 on the top at h = 0.1, and 15.5 in place of 9.0 on
/// the free body at h = 0.3.
[[nodiscard]] constexpr int sweeps_of_angles(std::size_t stages) {
    return stages < 8 ? static_cast<int>(stages) / 2 : 4;
}

}  // namespace hvi::detail

// The scalars, and systems that take any of them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/state.hpp>

namespace scalars {

#ifdef __SIZEOF_FLOAT128__
__extension__ typedef __float128 Quad;
#define HVI_SCALARS float, double, long double, scalars::Quad
#else
#define HVI_SCALARS float, double, long double
#endif

template <class T>
inline constexpr T eps = hvi::detail::epsilon<T>;

/// A quotient of integers. NOTE: 0.1 is a double.
template <class T>
constexpr T ratio(int numerator, int denominator) {
    return T(numerator) / T(denominator);
}

/// For CHECK: Catch prints no __float128.
template <class T>
bool at_most(T value, T bound) {
    return value <= bound;
}

/// Example 6.1: H = q p.
template <class T>
struct Dilation {
    using Vector = std::array<T, 1>;
    void dHdq(const Vector&, const Vector& p, Vector& out) const { out = p; }
    void dHdp(const Vector& q, const Vector&, Vector& out) const { out = q; }
};

/// Example 6.2: H = (p^2 + w^2 q^2)/2, for steppers of general and of separable systems.
template <class T, class AnyVector = std::array<T, 1>>
struct Oscillator {
    using Vector = AnyVector;
    T w = 1;
    void dHdq(const Vector& q, Vector& out) const { out[0] = w * w * q[0]; }
    void dHdp(const Vector& p, Vector& out) const { out[0] = p[0]; }
    void dHdq(const Vector& q, const Vector&, Vector& out) const { dHdq(q, out); }
    void dHdp(const Vector&, const Vector& p, Vector& out) const { dHdp(p, out); }
    template <class Matrix>
    void d2Hdq2(const Vector&, const Vector&, Matrix& out) const {
        out(0, 0) = w * w;
    }
    template <class Matrix>
    void d2Hdqdp(const Vector&, const Vector&, Matrix&) const {}
    template <class Matrix>
    void d2Hdp2(const Vector&, const Vector&, Matrix& out) const {
        out(0, 0) = 1;
    }
    template <class Matrix>
    void d2Hdq2(const Vector&, Matrix& out) const {
        out(0, 0) = w * w;
    }
    template <class Matrix>
    void d2Hdp2(const Vector&, Matrix& out) const {
        out(0, 0) = 1;
    }
};

/// H = (p^2 + q^2)/2 + q^4/4.
template <class T>
struct Duffing {
    using Vector = std::array<T, 1>;
    void dHdq(const Vector& q, Vector& out) const { out[0] = q[0] + q[0] * q[0] * q[0]; }
    void dHdp(const Vector& p, Vector& out) const { out = p; }
    void dHdq(const Vector& q, const Vector&, Vector& out) const { dHdq(q, out); }
    void dHdp(const Vector&, const Vector& p, Vector& out) const { dHdp(p, out); }
};

}  // namespace scalars

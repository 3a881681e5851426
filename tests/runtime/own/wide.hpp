// Morse's potential as in morse.hpp, also in the widest numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <hvi/detail/numbers/math.hpp>

template <class X>
X U(const X& r) {
    const X s = X(1) - hvi::math::exp((X(1) - r) / X(2));
    return X(10) * s * s;
}

template <class X>
X U_1(const X& r) {
    const X e = hvi::math::exp((X(1) - r) / X(2));
    return X(10) * (X(1) - e) * e;
}

/// NOTE: no second derivative, which fixed points do without.

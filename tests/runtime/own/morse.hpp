// Potentials as a user writes them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cmath>

// Morse's, with a depth of 10 and a width of 1/2.

template <class X>
X V(const X& r) {
    const X s = X(1) - std::exp((X(1) - r) / X(2));
    return X(10) * s * s;
}

template <class X>
X V_1(const X& r) {
    const X e = std::exp((X(1) - r) / X(2));
    return X(10) * (X(1) - e) * e;
}

template <class X>
X V_11(const X& r) {
    const X e = std::exp((X(1) - r) / X(2));
    return X(5) * e * (X(2) * e - X(1));
}

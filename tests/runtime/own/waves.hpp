// Functions of two arguments, one of which is that of another header.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cmath>

#include "morse.hpp"

// W(a, b) = sin(a) cos(b)

template <class X>
X W(const X& a, const X& b) {
    return std::sin(a) * std::cos(b);
}
template <class X>
X W_1(const X& a, const X& b) {
    return std::cos(a) * std::cos(b);
}
template <class X>
X W_2(const X& a, const X& b) {
    return -std::sin(a) * std::sin(b);
}
template <class X>
X W_11(const X& a, const X& b) {
    return -std::sin(a) * std::cos(b);
}
template <class X>
X W_12(const X& a, const X& b) {
    return -std::cos(a) * std::sin(b);
}
template <class X>
X W_22(const X& a, const X& b) {
    return -std::sin(a) * std::cos(b);
}

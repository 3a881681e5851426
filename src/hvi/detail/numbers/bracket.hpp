// Bracket of a place where a function changes its sign.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

namespace hvi::detail {

/// Two places at which a function has opposite signs, and its values there. The later one found is
/// `a`.
template <class Scalar>
struct Bracket {
    Scalar a, b, at_a, at_b;

    /// Returns the place of both where the function is nearer to zero.
    [[nodiscard]] Scalar best() const { return std::abs(at_a) < std::abs(at_b) ? a : b; }
};

/// Narrows a bracket until its ends are no more than twice the tolerance apart, or the function is
/// zero at one of them, and returns it. The steps are inverse quadratic interpolation where that is
/// safe, else halving (T. R. Chandrupatla, Adv. Eng. Software 28, 1997, 145-149). A function that
/// has no value at a place returns NaN, which ends the search: then at_a of the result is NaN.
/// Precondition: numbers between the ends differ by the tolerance, which is positive.
template <class Scalar, class Function>
[[nodiscard]] Bracket<Scalar> narrowed(Bracket<Scalar> bracket, Scalar tolerance, Function f) {
    Scalar& a = bracket.a;
    Scalar& b = bracket.b;
    Scalar& at_a = bracket.at_a;
    Scalar& at_b = bracket.at_b;
    Scalar part = Scalar(1) / 2;
    while (at_a != 0 && at_b != 0) {
        const Scalar least = tolerance / std::abs(b - a);
        if (!(least < Scalar(1) / 2)) { break; }
        const Scalar x = a + std::clamp(part, least, 1 - least) * (b - a);
        const Scalar value = f(x);
        const bool is_beside_a = (value < 0) == (at_a < 0);
        const Scalar c = is_beside_a ? a : b;
        const Scalar at_c = is_beside_a ? at_a : at_b;
        if (!is_beside_a) {
            b = a;
            at_b = at_a;
        }
        a = x;
        at_a = value;
        if (std::isnan(value)) { break; }
        const Scalar xi = (a - b) / (c - b), phi = (at_a - at_b) / (at_c - at_b);
        const bool is_safe = phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi;
        part = is_safe ? at_a / (at_b - at_a) * (at_c / (at_b - at_c)) +
                             (c - a) / (b - a) * (at_a / (at_c - at_a)) * (at_b / (at_c - at_b))
                       : Scalar(1) / 2;
    }
    return bracket;
}

}  // namespace hvi::detail

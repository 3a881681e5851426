// The weights of one step.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_WEIGHTS_HPP
#define HVI_WEIGHTS_HPP

#include <array>
#include <cstddef>

#include <hvi/detail/numbers/arithmetic.hpp>

namespace hvi::detail {

/// NOTE: not abs(), which calls the standard library: steps of kicks and drifts may be constant
/// expressions.
template <class Scalar>
[[nodiscard]] constexpr Scalar magnitude(Scalar x) {
    return x < 0 ? -x : x;
}

/// Whether b_i = b_{n+1-i}.
template <class Scalar>
[[nodiscard]] constexpr bool is_symmetric(const Scalar* b, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
        if (b[i] != b[n - 1 - i]) { return false; }
    }
    return true;
}

/// Whether the sum is 1 as far as rounded weights tell: that of an inconsistent method is not.
template <class Scalar>
[[nodiscard]] constexpr bool sums_to_one(const Scalar* b, std::size_t n) {
    Scalar excess = -1;
    Scalar size = 1;
    for (std::size_t i = 0; i < n; ++i) {
        excess += b[i];
        size += magnitude(b[i]);
    }
    const Scalar most = static_cast<Scalar>(n) * size * epsilon<Scalar>;
    return -most <= excess && excess <= most;
}

template <class Scalar>
[[nodiscard]] constexpr std::size_t largest_of(const Scalar* b, std::size_t end) {
    std::size_t largest = 0;
    for (std::size_t i = 1; i < end; ++i) {
        if (b[i] > b[largest]) { largest = i; }
    }
    return largest;
}

/// Sets n weights to h b_i, rounded to multiples of ulp(h), and so that they add up to h without rounding (where no
/// b_i is negative) and keep the symmetry of b.
///
/// NOTE: products that are rounded one by one add up to h (1 + delta) with the same delta in every
/// step, by which time runs fast or slow: over 10^6 steps of the oscillator the phase of gauss:4 is
/// off by 1e-11 with them and by 1e-14 with these. The low parts of the products, added to the
/// remainders of the sums, mend the time, but then what a step adds is not what its stages were
/// computed with, and the energy drifts. The method is symplectic with any weights.
template <class Scalar>
constexpr void set_weights_of_step(Scalar h, const Scalar* b, std::size_t n, Scalar* weights) {
    const Scalar size = magnitude(h);
    Scalar sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
        // NOTE: the sum of this and `size` is a multiple of ulp(h), and so is what is left.
        const Scalar part = (magnitude(size * b[i]) + size) - size;
        weights[i] = (b[i] < 0) == (h < 0) ? part : -part;
        sum += weights[i];
    }
    if (!sums_to_one(b, n)) { return; }
    const Scalar missing = h - sum;
    if (!is_symmetric(b, n)) {
        weights[largest_of(b, n)] += missing;
    } else if (n % 2 == 1) {
        weights[n / 2] += missing;
    } else {
        const std::size_t i = largest_of(b, n / 2);
        weights[i] += missing / 2;
        weights[n - 1 - i] += missing / 2;
    }
}

template <class Scalar, std::size_t n>
[[nodiscard]] constexpr std::array<Scalar, n> weights_of_step(Scalar h, const Scalar (&b)[n]) {
    std::array<Scalar, n> weights{};
    set_weights_of_step(h, b, n, weights.data());
    return weights;
}

/// The weights of a step of kicks and drifts, kept while its size stays.
///
/// NOTE: those of a palindrome repeat. Were they products in the step, g++ would keep each in a
/// register until it comes again, and on few degrees of freedom the state would have to give way.
template <class Scalar, std::size_t kicks, std::size_t drifts>
struct MoveWeights {
    std::array<Scalar, kicks> p{};
    std::array<Scalar, drifts> q{};

    constexpr void weigh(Scalar h, const Scalar (&b_p)[kicks], const Scalar (&b_q)[drifts]) {
        if (h == weighed) { return; }
        p = weights_of_step(h, b_p);
        q = weights_of_step(h, b_q);
        weighed = h;
    }

    Scalar weighed = 0;  ///< the step size of the weights
};

}  // namespace hvi::detail

#endif  // HVI_WEIGHTS_HPP

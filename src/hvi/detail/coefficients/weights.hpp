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

/// Returns |x|. NOTE: not abs(), which calls the standard library: steps of kicks and drifts may be
/// constant expressions.
template <class Scalar>
[[nodiscard]] constexpr Scalar magnitude(Scalar x) {
    return x < 0 ? -x : x;
}

/// Returns whether b_i = b_{n+1-i}.
template <class Scalar>
[[nodiscard]] constexpr bool is_symmetric(const Scalar* b, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
        if (b[i] != b[n - 1 - i]) { return false; }
    }
    return true;
}

/// Returns whether the sum is 1 up to rounding of the weights, which it is not for an inconsistent
/// method.
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

/// Sets n weights to h b_i, rounded to multiples of ulp(h). The weights add up to h without
/// rounding (where no b_i is negative) and keep the symmetry of b.
///
/// NOTE: products that are rounded one by one add up to h (1 + delta) with the same delta in every
/// step, so that time runs fast or slow: over 10^6 steps of the oscillator the phase of gauss:4 is
/// off by 1e-11 with such products and by 1e-14 with these weights. The low parts of the products,
/// added to the remainders of the sums, would mend the time. But a step would then add other slopes
/// than its stages were computed with, and the energy drifts. The method is symplectic with any
/// weights.
template <class Scalar>
constexpr void set_weights_of_step(Scalar h, const Scalar* b, std::size_t n, Scalar* weights) {
    const Scalar size = magnitude(h);
    Scalar sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
        // NOTE: this sum with `size` is a multiple of ulp(h), and so is the difference.
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

/// Weights of a step of kicks and drifts, kept while its size stays.
///
/// NOTE: the weights of a palindrome repeat. Were they products in the step, g++ would keep each in
/// a register until it recurs, and the state of few degrees of freedom would lose its registers.
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

    Scalar weighed = 0;  ///< step size of the weights
};

}  // namespace hvi::detail

#endif  // HVI_WEIGHTS_HPP

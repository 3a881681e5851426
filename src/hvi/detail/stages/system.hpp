// Requirements of steppers on a user's class and on its vectors.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_SYSTEM_HPP
#define HVI_SYSTEM_HPP

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include <hvi/detail/numbers/scalar.hpp>

namespace hvi::detail {

/// Index type of a vector: std::size_t for std::array, a signed one for Eigen.
template <class Vector>
using IndexOf = std::decay_t<decltype(std::declval<const Vector&>().size())>;

template <class Vector, class = void>
struct HasTupleSize : std::false_type {};
template <class Vector>
struct HasTupleSize<Vector, std::void_t<decltype(std::tuple_size<Vector>::value)>>
    : std::true_type {};

template <class Vector, class = void>
struct HasSizeOfEigen : std::false_type {};
template <class Vector>
struct HasSizeOfEigen<Vector, std::void_t<decltype(Vector::SizeAtCompileTime)>> : std::true_type {};

/// Returns the dimension that is part of the type of a vector, of std::array or of Eigen; else 0.
template <class Vector>
[[nodiscard]] constexpr std::size_t fixed_size() {
    if constexpr (HasTupleSize<Vector>::value) {
        return std::tuple_size<Vector>::value;
    } else if constexpr (HasSizeOfEigen<Vector>::value) {
        constexpr auto size = static_cast<long>(Vector::SizeAtCompileTime);
        return size > 0 ? static_cast<std::size_t>(size) : 0;
    } else {
        return 0;
    }
}

/// Returns whether a vector always holds n numbers of the type Number.
template <class Vector, class Number, std::size_t n>
[[nodiscard]] constexpr bool is_fixed_vector() {
    return std::is_same_v<ScalarOf<Vector>, Number> && fixed_size<Vector>() == n;
}

template <class System, class = void>
struct HasVector : std::false_type {};
template <class System>
struct HasVector<System, std::void_t<typename System::Vector>> : std::true_type {};

template <class Vector, class = void>
struct IsVector : std::false_type {};
template <class Vector>
struct IsVector<Vector, std::void_t<decltype(std::declval<Vector&>()[0]), IndexOf<Vector>>>
    : std::is_lvalue_reference<decltype(std::declval<Vector&>()[0])> {};

template <class Vector, class = void>
struct HasResize : std::false_type {};
template <class Vector>
struct HasResize<Vector, std::void_t<decltype(std::declval<Vector&>().resize(1))>>
    : std::true_type {};

template <class System, class Vector, class = void>
struct HasGradients : std::false_type {};
template <class System, class Vector>
struct HasGradients<System, Vector,
                    std::void_t<decltype(std::declval<const System&>().dHdq(
                                    std::declval<const Vector&>(), std::declval<const Vector&>(),
                                    std::declval<Vector&>())),
                                decltype(std::declval<const System&>().dHdp(
                                    std::declval<const Vector&>(), std::declval<const Vector&>(),
                                    std::declval<Vector&>()))>> : std::true_type {};

template <class System, class Vector, class = void>
struct HasSeparableGradients : std::false_type {};
template <class System, class Vector>
struct HasSeparableGradients<
    System, Vector,
    std::void_t<decltype(std::declval<const System&>().dHdq(std::declval<const Vector&>(),
                                                            std::declval<Vector&>())),
                decltype(std::declval<const System&>().dHdp(
                    std::declval<const Vector&>(), std::declval<Vector&>()))>> : std::true_type {};

/// Fails to compile with a message about what a class lacks to be a Hamiltonian system.
template <class System, bool separable>
constexpr bool check_system() {
    static_assert(HasVector<System>::value,
                  "hvi: the system must name its vectors: using Vector = std::array<double, n>;");
    using Vector = typename System::Vector;
    static_assert(IsVector<Vector>::value,
                  "hvi: Vector must hold numbers, with operator[] and size(): "
                  "std::array<double, n> or a vector of Eigen");
    static_assert(is_supported<ScalarOf<Vector>>(),
                  "hvi: Vector must hold float, double, long double or __float128, with a mantissa "
                  "of 24, 53, 64 or 113 bits: there are no coefficients for other numbers");
    if constexpr (separable) {
        static_assert(HasSeparableGradients<System, Vector>::value,
                      "hvi: for H = T(p) + U(q) the system must offer const members "
                      "dHdq(const Vector& q, Vector& out) and dHdp(const Vector& p, Vector& out)");
    } else {
        static_assert(HasGradients<System, Vector>::value,
                      "hvi: the system must offer const members dHdq and dHdp, each "
                      "(const Vector& q, const Vector& p, Vector& out)");
    }
    return true;
}

/// Returns component k of a vector with any index type.
template <class Vector>
[[nodiscard]] constexpr decltype(auto) at(Vector& v, std::size_t k) {
    return v[static_cast<IndexOf<std::decay_t<Vector>>>(k)];
}

/// Gives v the dimension n, and fills it with zeros where that is new. Allocates only then, and
/// only where the dimension is dynamic.
template <class Vector>
constexpr void fit(Vector& v, IndexOf<Vector> n) {
    if constexpr (HasResize<Vector>::value) {
        if (v.size() == n) { return; }
        v.resize(n);
        for (IndexOf<Vector> k = 0; k < n; ++k) { v[k] = 0; }
    }
}

/// Returns a vector to compute in: a new one, which lives in registers, where the dimension is part
/// of the type; otherwise the caller's `own`, so that nothing is allocated.
template <class Vector>
[[nodiscard]] constexpr std::conditional_t<HasResize<Vector>::value, Vector&, Vector>
scratch(Vector& own) {
    if constexpr (HasResize<Vector>::value) {
        return own;
    } else {
        return {};
    }
}

/// Returns whether the compiler evaluates this; false where it does not tell.
[[nodiscard]] constexpr bool is_constant_evaluated() {
#ifdef __has_builtin
#if __has_builtin(__builtin_is_constant_evaluated)
    return __builtin_is_constant_evaluated();
#endif
#endif
    return false;
}

/// Returns same_bits() of two numbers in a constant expression, where bits cannot be compared.
template <class Scalar>
[[nodiscard]] constexpr bool same_constant(Scalar x, Scalar y) {
#ifdef __has_builtin
#if __has_builtin(__builtin_copysign)
    // NOTE: only the sign of 0, as other numbers may be beyond the range of double.
    if constexpr (!std::is_class_v<Scalar>) {
        return x == y && (x != 0 || __builtin_copysign(1.0, static_cast<double>(x)) ==
                                        __builtin_copysign(1.0, static_cast<double>(y)));
    }
#endif
#endif
    return x == y;
}

/// Returns whether a and b agree bit for bit, -0.0 and 0.0 being different.
template <class Vector>
[[nodiscard]] constexpr bool same_bits(const Vector& a, const Vector& b) {
    if (a.size() != b.size()) { return false; }
    using Scalar = ScalarOf<Vector>;
    if (is_constant_evaluated()) {
        bool same = true;
        for (IndexOf<Vector> k = 0; k < a.size(); ++k) {
            same = same && same_constant<Scalar>(a[k], b[k]);
        }
        return same;
    }
    // NOTE: in the 64-bit format ten bytes are the number, the others are padding.
    constexpr std::size_t bytes = bits<Scalar> == 64 ? 10 : sizeof(Scalar);
    constexpr std::size_t words = (bytes + 7) / 8;
    std::uint64_t difference = 0;
    for (IndexOf<Vector> k = 0; k < a.size(); ++k) {
        // NOTE: copies, since g++ keeps the vectors that are copied here in registers of integers,
        // and the next step would wait for them to come back.
        const Scalar x = a[k];
        const Scalar y = b[k];
        std::uint64_t left[words] = {};
        std::uint64_t right[words] = {};
        std::memcpy(left, &x, bytes);
        std::memcpy(right, &y, bytes);
        for (std::size_t i = 0; i < words; ++i) { difference |= left[i] ^ right[i]; }
    }
    return difference == 0;
}

/// Returns 0 where all components are finite, else NaN.
template <class Vector>
[[nodiscard]] constexpr ScalarOf<Vector> zero_if_finite(const Vector& v) {
    // NOTE: x - x is 0, or NaN where x is infinite or NaN. Two sums, since each waits for itself
    // alone.
    ScalarOf<Vector> even = 0;
    ScalarOf<Vector> odd = 0;
    IndexOf<Vector> k = 0;
    for (; k + 1 < v.size(); k += 2) {
        even += v[k] - v[k];
        odd += v[k + 1] - v[k + 1];
    }
    if (k < v.size()) { even += v[k] - v[k]; }
    return even + odd;
}

/// Returns whether all components of both are finite. One test of a sum is cheaper than one of
/// each.
template <class Vector>
[[nodiscard]] constexpr bool finite(const Vector& q, const Vector& p) {
    return zero_if_finite(q) + zero_if_finite(p) >= 0;
}

/// Sets to = from; both have one dimension.
template <class Vector>
constexpr void copy(const Vector& from, Vector& to) {
    // NOTE: four at a time. For an assignment, or a loop over single components, g++ calls memcpy
    // where there are many components. The next step then waits: it loads values that were stored
    // in two parts.
    IndexOf<Vector> k = 0;
    for (; k + 3 < from.size(); k += 4) {
        to[k] = from[k];
        to[k + 1] = from[k + 1];
        to[k + 2] = from[k + 2];
        to[k + 3] = from[k + 3];
    }
    for (; k < from.size(); ++k) { to[k] = from[k]; }
}

}  // namespace hvi::detail

#endif  // HVI_SYSTEM_HPP

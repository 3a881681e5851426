// Functions of several numbers at once, by xsimd where the compiler finds it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <hvi/detail/lanes/registers.hpp>
#include <hvi/detail/numbers/math.hpp>
#include <hvi/detail/numbers/more_math.hpp>

// NOTE: g++ 12 warns of its own AVX-512 functions, whose undefined values it takes for an
// uninitialised variable.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#if HVI_REGISTER_BYTES && defined(__has_include)
#if __has_include(<xsimd/xsimd.hpp>)
#define HVI_HAS_XSIMD 1
#include <xsimd/xsimd.hpp>
#endif
#endif
#ifndef HVI_HAS_XSIMD
#define HVI_HAS_XSIMD 0
#endif

namespace hvi::detail {

/// Returns f(x), where f is made of exp.
template <class Number, class F>
[[nodiscard]] Number exponential(const Number& x, F f) {
    return f(x);
}

#if HVI_REGISTER_BYTES

#if HVI_HAS_XSIMD

/// Returns f(x), where f is a function of a batch of xsimd.
template <class Number, std::size_t width, class F>
[[nodiscard]] PackedNumbers<Number, width> by_library(const PackedNumbers<Number, width>& x, F f) {
    using Batch = typename xsimd::make_sized_batch<Number, width>::type;
    if constexpr (std::is_void_v<Batch>) {
        return each_of(x, f);
    } else {
        using Vector = typename CompilerVector<Number, width>::Type;
        using Known = typename Batch::register_type;
        const Batch result = f(Batch(static_cast<Known>(x.vector)));
        return static_cast<Vector>(static_cast<Known>(result));
    }
}

/// NOTE: xsimd converts the exponent to an integer, which is undefined where the exponent is too
/// large, and for NaN. So x is limited to +-1000, beyond which these functions no longer change.
template <class Number, std::size_t width, class F>
[[nodiscard]] PackedNumbers<Number, width> exponential(const PackedNumbers<Number, width>& x, F f) {
    using Part = PackedNumbers<Number, width>;
    const Part most(static_cast<Number>(1000));
    const auto is_number = x == x;
    const Part number = select(is_number, x, most);
    const Part below = select(number < most, number, most);
    const Part near = select(-most < below, below, -most);
    return select(is_number, f(near), x);
}

#else

template <class Number, std::size_t width, class F>
[[nodiscard]] PackedNumbers<Number, width> by_library(const PackedNumbers<Number, width>& x, F f) {
    return each_of(x, f);
}

#endif

// NOTE: found by the type of the argument; math:: has the functions of one number.
template <class Number, std::size_t width>
[[nodiscard]] PackedNumbers<Number, width> acos(const PackedNumbers<Number, width>& x) {
    using math::acos;
    return by_library(x, [](const auto& a) { return acos(a); });
}
template <class Number, std::size_t width>
[[nodiscard]] PackedNumbers<Number, width> asin(const PackedNumbers<Number, width>& x) {
    using math::asin;
    return by_library(x, [](const auto& a) { return asin(a); });
}
template <class Number, std::size_t width>
[[nodiscard]] PackedNumbers<Number, width> asinh(const PackedNumbers<Number, width>& x) {
    using math::asinh;
    return by_library(x, [](const auto& a) { return asinh(a); });
}
template <class Number, std::size_t width>
[[nodiscard]] PackedNumbers<Number, width> atan(const PackedNumbers<Number, width>& x) {
    using math::atan;
    return by_library(x, [](const auto& a) { return atan(a); });
}
template <class Number, std::size_t width>
[[nodiscard]] PackedNumbers<Number, width> atanh(const PackedNumbers<Number, width>& x) {
    using math::atanh;
    return by_library(x, [](const auto& a) { return atanh(a); });
}
template <class Number, std::size_t width>
[[nodiscard]] PackedNumbers<Number, width> cbrt(const PackedNumbers<Number, width>& x) {
    using math::cbrt;
    return by_library(x, [](const auto& a) { return cbrt(a); });
}
template <class Number, std::size_t width>
[[nodiscard]] PackedNumbers<Number, width> cosh(const PackedNumbers<Number, width>& x) {
    using math::cosh;
    return by_library(x, [](const auto& a) { return cosh(a); });
}
template <class Number, std::size_t width>
[[nodiscard]] PackedNumbers<Number, width> exp(const PackedNumbers<Number, width>& x) {
    using math::exp;
    return by_library(x, [](const auto& a) { return exp(a); });
}
template <class Number, std::size_t width>
[[nodiscard]] PackedNumbers<Number, width> expm1(const PackedNumbers<Number, width>& x) {
    using math::expm1;
    return by_library(x, [](const auto& a) { return expm1(a); });
}
template <class Number, std::size_t width>
[[nodiscard]] PackedNumbers<Number, width> log(const PackedNumbers<Number, width>& x) {
    using math::log;
    return by_library(x, [](const auto& a) { return log(a); });
}
template <class Number, std::size_t width>
[[nodiscard]] PackedNumbers<Number, width> log10(const PackedNumbers<Number, width>& x) {
    using math::log10;
    return by_library(x, [](const auto& a) { return log10(a); });
}
template <class Number, std::size_t width>
[[nodiscard]] PackedNumbers<Number, width> sinh(const PackedNumbers<Number, width>& x) {
    using math::sinh;
    return by_library(x, [](const auto& a) { return sinh(a); });
}
template <class Number, std::size_t width>
[[nodiscard]] PackedNumbers<Number, width> tanh(const PackedNumbers<Number, width>& x) {
    using math::tanh;
    return by_library(x, [](const auto& a) { return tanh(a); });
}

#endif

}  // namespace hvi::detail

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

// What the processor computes at once.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>

#if !defined(HVI_NO_XSIMD) && defined(__has_include)
#if __has_include(<xsimd/xsimd.hpp>)
#define HVI_HAS_XSIMD 1
#include <xsimd/xsimd.hpp>
#endif
#endif
#ifndef HVI_HAS_XSIMD
#define HVI_HAS_XSIMD 0
#endif

/// Of functions of scenes that are called often. Without registers g++ vectorises what is called,
/// and not what is inlined.
#if HVI_HAS_XSIMD
#define HVI_INLINE_IN_LANES [[gnu::always_inline]]
#else
#define HVI_INLINE_IN_LANES
#endif

namespace hvi::detail {

/// `width` numbers in one register; void where the processor has none of that size.
template <class Number, std::size_t width, class = void>
struct RegisterOf {
    using type = void;
};

#if HVI_HAS_XSIMD
template <class Number, std::size_t width>
struct RegisterOf<
    Number, width,
    std::enable_if_t<std::is_same_v<Number, float> || std::is_same_v<Number, double>>> {
    using type = typename xsimd::make_sized_batch<Number, width>::type;
};
#endif

/// What a comparison of registers gives.
template <class Part>
struct MaskOf {
    using type = bool;
};

#if HVI_HAS_XSIMD
template <class Number, class Architecture>
struct MaskOf<xsimd::batch<Number, Architecture>> {
    using type = typename xsimd::batch<Number, Architecture>::batch_bool_type;
};
#endif

/// f(x), for f made of exp.
template <class Number, class F>
[[nodiscard]] Number exponential(const Number& x, F f) {
    return f(x);
}

#if HVI_HAS_XSIMD
/// NOTE: xsimd makes an integer of the exponent, which is undefined where there is none so large,
/// and for NaN. Beyond +-1000 all of these functions are what they are there.
template <class Number, class Architecture, class F>
[[nodiscard]] xsimd::batch<Number, Architecture>
exponential(const xsimd::batch<Number, Architecture>& x, F f) {
    using Part = xsimd::batch<Number, Architecture>;
    const Part most(static_cast<Number>(1000));
    const auto is_number = x == x;
    const Part near = min(max(select(is_number, x, most), -most), most);
    return select(is_number, f(near), x);
}
#endif

[[nodiscard]] inline bool any(bool mask) { return mask; }
[[nodiscard]] inline bool all(bool mask) { return mask; }
template <class Number>
[[nodiscard]] Number select(bool mask, const Number& yes, const Number& no) {
    return mask ? yes : no;
}

template <class Number, std::size_t width>
inline constexpr bool has_register = !std::is_void_v<typename RegisterOf<Number, width>::type>;

/// As many as a register holds.
inline constexpr std::size_t widest = 8;

/// How many numbers go into one register where `places` are to fill registers; 1: there is none.
/// Not more than `most`.
template <class Number, std::size_t places, std::size_t most = widest>
[[nodiscard]] constexpr std::size_t register_width() {
    if (most >= 8 && places % 8 == 0 && has_register<Number, 8>) { return 8; }
    if (most >= 4 && places % 4 == 0 && has_register<Number, 4>) { return 4; }
    if (places % 2 == 0 && has_register<Number, 2>) { return 2; }
    return 1;
}

/// What computes `width` numbers at once.
template <class Number, std::size_t width>
struct Register {
    using Type = typename RegisterOf<Number, width>::type;
    [[nodiscard]] static Type load(const Number* from) { return Type::load_aligned(from); }
    static void store(const Type& x, Number* to) { x.store_aligned(to); }
    [[nodiscard]] static Type load_anywhere(const Number* from) {
        return Type::load_unaligned(from);
    }
    static void store_anywhere(const Type& x, Number* to) { x.store_unaligned(to); }
    [[nodiscard]] static Number sum(const Type& x) {
#if HVI_HAS_XSIMD && XSIMD_VERSION_MAJOR < 9
        return hadd(x);
#else
        return reduce_add(x);
#endif
    }
};

template <class Number>
struct Register<Number, 1> {
    using Type = Number;
    [[nodiscard]] static const Number& load(const Number* from) { return *from; }
    static void store(const Number& x, Number* to) { *to = x; }
    [[nodiscard]] static const Number& load_anywhere(const Number* from) { return *from; }
    static void store_anywhere(const Number& x, Number* to) { *to = x; }
    [[nodiscard]] static const Number& sum(const Number& x) { return x; }
};

}  // namespace hvi::detail

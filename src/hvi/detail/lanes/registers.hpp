// Registers of the processor.
// SPDX-License-Identifier: MIT
//
// NOTE: the vectors are types of the compilers, which g++ and clang++ know without a header.
// Headers of a library such as xsimd take as long to read as all the rest of a stepper takes to be
// compiled. Functions that only a library has, exp and log, are in register_functions.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

#if !defined(HVI_NO_REGISTERS) && defined(__GNUC__)
#if defined(__AVX512F__)
#define HVI_REGISTER_BYTES 64
#elif defined(__AVX__)
#define HVI_REGISTER_BYTES 32
#elif defined(__SSE2__) || defined(__ARM_NEON) || defined(__ALTIVEC__)
#define HVI_REGISTER_BYTES 16
#endif
#endif
#ifndef HVI_REGISTER_BYTES
#define HVI_REGISTER_BYTES 0
#endif

/// Attribute of functions of scenes that are called often. Without registers it is empty: g++
/// vectorises a function that is called, but not one that is inlined.
#if HVI_REGISTER_BYTES
#define HVI_INLINE_IN_LANES [[gnu::always_inline]]
#else
#define HVI_INLINE_IN_LANES
#endif

namespace hvi::detail {

/// Whether there is a register of `width` numbers.
template <class Number, std::size_t width>
inline constexpr bool
    has_register = width > 1 &&
                   (std::is_same_v<Number, float> ||
                    std::is_same_v<Number, double>)&&(width * sizeof(Number) == 16 ||
                                                      width * sizeof(Number) == 32 ||
                                                      width * sizeof(Number) == 64) &&
                   width * sizeof(Number) <= HVI_REGISTER_BYTES;

/// Limit on the numbers in a register: as many as the widest register holds.
inline constexpr std::size_t widest = 8;

/// Returns how many numbers go into one register where `places` places fill registers, and at most
/// `most`; 1: there is no register.
template <class Number, std::size_t places, std::size_t most = widest>
[[nodiscard]] constexpr std::size_t register_width() {
    if (most >= 8 && places % 8 == 0 && has_register<Number, 8>) { return 8; }
    if (most >= 4 && places % 4 == 0 && has_register<Number, 4>) { return 4; }
    if (places % 2 == 0 && has_register<Number, 2>) { return 2; }
    return 1;
}

// ---- one number ----

[[nodiscard]] inline bool any(bool mask) { return mask; }
[[nodiscard]] inline bool all(bool mask) { return mask; }
template <class Number>
[[nodiscard]] Number select(bool mask, const Number& yes, const Number& no) {
    return mask ? yes : no;
}

/// Type of the result of a comparison.
template <class Part>
struct MaskOf {
    using type = bool;
};

#if HVI_REGISTER_BYTES

// ---- several numbers ----

/// Type of integers as large as a number.
template <class Number>
using BitsOf = std::conditional_t<sizeof(Number) == 4, std::int32_t, std::int64_t>;

/// Vector types of the compiler.
template <class Number, std::size_t width>
struct CompilerVector {
    typedef Number Type __attribute__((vector_size(width * sizeof(Number))));
    typedef BitsOf<Number> Bits __attribute__((vector_size(width * sizeof(Number))));
    // types for access to memory that holds numbers
    typedef Number Aligned __attribute__((vector_size(width * sizeof(Number)), may_alias));
    typedef Number Anywhere
        __attribute__((vector_size(width * sizeof(Number)), aligned(alignof(Number)), may_alias));
};

/// Booleans, one for each number: all bits, or none.
template <class Number, std::size_t width>
struct RegisterMask {
    using Bits = typename CompilerVector<Number, width>::Bits;

    Bits bits;

    RegisterMask() = default;
    explicit RegisterMask(const Bits& x) : bits(x) {}
    /// Sets all to x.
    explicit RegisterMask(bool x) : bits(x ? ~Bits{} : Bits{}) {}

    [[nodiscard]] friend RegisterMask operator!(const RegisterMask& x) {
        return RegisterMask(~x.bits);
    }
    [[nodiscard]] friend RegisterMask operator&&(const RegisterMask& x, const RegisterMask& y) {
        return RegisterMask(x.bits & y.bits);
    }
    [[nodiscard]] friend RegisterMask operator||(const RegisterMask& x, const RegisterMask& y) {
        return RegisterMask(x.bits | y.bits);
    }
    [[nodiscard]] friend bool any(const RegisterMask& x) { return some(x.bits); }
    [[nodiscard]] friend bool all(const RegisterMask& x) { return !some(~x.bits); }

private:
    /// Returns whether any bit is set.
    [[nodiscard]] static bool some(const Bits& bits) {
#if defined(__AVX__)
        if constexpr (sizeof(Bits) == 32) {
            typedef long long Words __attribute__((vector_size(32)));
            return __builtin_ia32_ptestz256(Words(bits), Words(bits)) == 0;
        }
#endif
#if defined(__AVX512F__) && defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
        if constexpr (sizeof(Bits) == 64) {
            typedef long long Words __attribute__((vector_size(64)));
            const Words words = Words(bits);
            const auto both = __builtin_shufflevector(words, words, 0, 1, 2, 3) |
                              __builtin_shufflevector(words, words, 4, 5, 6, 7);
            return __builtin_ia32_ptestz256(both, both) == 0;
        }
#endif
#endif
        BitsOf<Number> joined = bits[0];
        for (std::size_t i = 1; i < width; ++i) { joined |= bits[i]; }
        return joined != 0;
    }
};

/// Holds `width` numbers.
template <class Number, std::size_t width>
struct PackedNumbers {
    using value_type = Number;
    using Vector = typename CompilerVector<Number, width>::Type;
    using Bits = typename CompilerVector<Number, width>::Bits;
    using Mask = RegisterMask<Number, width>;

    Vector vector;

    PackedNumbers() = default;
    PackedNumbers(const Vector& x) : vector(x) {}
    /// Sets all places to x. NOTE: x - 0 is x, but x + 0 is not where x is -0.
    PackedNumbers(const Number& x) : vector(x - Vector{}) {}

    [[nodiscard]] friend PackedNumbers operator-(const PackedNumbers& x) { return -x.vector; }
    [[nodiscard]] friend PackedNumbers operator+(const PackedNumbers& x, const PackedNumbers& y) {
        return x.vector + y.vector;
    }
    [[nodiscard]] friend PackedNumbers operator-(const PackedNumbers& x, const PackedNumbers& y) {
        return x.vector - y.vector;
    }
    [[nodiscard]] friend PackedNumbers operator*(const PackedNumbers& x, const PackedNumbers& y) {
        return x.vector * y.vector;
    }
    [[nodiscard]] friend PackedNumbers operator/(const PackedNumbers& x, const PackedNumbers& y) {
        return x.vector / y.vector;
    }
    [[nodiscard]] friend Mask operator<(const PackedNumbers& x, const PackedNumbers& y) {
        return Mask(x.vector < y.vector);
    }
    [[nodiscard]] friend Mask operator<=(const PackedNumbers& x, const PackedNumbers& y) {
        return Mask(x.vector <= y.vector);
    }
    [[nodiscard]] friend Mask operator==(const PackedNumbers& x, const PackedNumbers& y) {
        return Mask(x.vector == y.vector);
    }
    [[nodiscard]] friend PackedNumbers select(const Mask& mask, const PackedNumbers& yes,
                                              const PackedNumbers& no) {
        return Vector(mask.bits ? yes.vector : no.vector);
    }

    /// Returns x without the bit of the sign.
    [[nodiscard]] friend PackedNumbers abs(const PackedNumbers& x) {
        constexpr BitsOf<Number> others = std::numeric_limits<BitsOf<Number>>::max();
        return Vector(Bits(x.vector) & others);
    }
};

template <class Number, std::size_t width>
struct MaskOf<PackedNumbers<Number, width>> {
    using type = RegisterMask<Number, width>;
};

/// Applies f to each number.
template <class Number, std::size_t width, class F>
[[nodiscard]] PackedNumbers<Number, width> each_of(const PackedNumbers<Number, width>& x, F f) {
    PackedNumbers<Number, width> result = x;
    for (std::size_t i = 0; i < width; ++i) { result.vector[i] = f(x.vector[i]); }
    return result;
}

template <class Number, std::size_t width>
[[nodiscard, gnu::always_inline]] inline PackedNumbers<Number, width>
sqrt(const PackedNumbers<Number, width>& x) {
    return each_of(x, [](Number a) { return __builtin_sqrt(a); });
}
template <std::size_t width>
[[nodiscard, gnu::always_inline]] inline PackedNumbers<float, width>
sqrt(const PackedNumbers<float, width>& x) {
    return each_of(x, [](float a) { return __builtin_sqrtf(a); });
}

// NOTE: without a header a compiler does not know that the processor has these functions, and g++
// and clang++ name the one of 64 bytes differently.
#if defined(__SSE2__)
[[nodiscard, gnu::always_inline]] inline PackedNumbers<double, 2>
sqrt(const PackedNumbers<double, 2>& x) {
    return __builtin_ia32_sqrtpd(x.vector);
}
[[nodiscard, gnu::always_inline]] inline PackedNumbers<float, 4>
sqrt(const PackedNumbers<float, 4>& x) {
    return __builtin_ia32_sqrtps(x.vector);
}
#endif
#if defined(__AVX__)
[[nodiscard, gnu::always_inline]] inline PackedNumbers<double, 4>
sqrt(const PackedNumbers<double, 4>& x) {
    return __builtin_ia32_sqrtpd256(x.vector);
}
[[nodiscard, gnu::always_inline]] inline PackedNumbers<float, 8>
sqrt(const PackedNumbers<float, 8>& x) {
    return __builtin_ia32_sqrtps256(x.vector);
}
#endif
#if defined(__AVX512F__)
[[nodiscard, gnu::always_inline]] inline PackedNumbers<double, 8>
sqrt(const PackedNumbers<double, 8>& x) {
    constexpr int rounding = 4;  // the present rounding
#if defined(__clang__)
    return __builtin_ia32_sqrtpd512(x.vector, rounding);
#else
    return __builtin_ia32_sqrtpd512_mask(x.vector, x.vector, static_cast<char>(-1), rounding);
#endif
}
#endif

#endif

/// Loading, storing and adding up of the type that computes `width` numbers at once.
template <class Number, std::size_t width>
struct Register {
#if HVI_REGISTER_BYTES
    using Type = PackedNumbers<Number, width>;

    // NOTE: by these types and not by memcpy, for which g++ copies lanes from memory to memory.
    // They are named here, since an argument of a template loses the alignment of its type.
    [[nodiscard]] static Type load(const Number* from) {
        const Vector vector = *reinterpret_cast<const typename Compiled::Aligned*>(from);
        return vector;
    }
    static void store(const Type& x, Number* to) {
        *reinterpret_cast<typename Compiled::Aligned*>(to) = x.vector;
    }
    [[nodiscard]] static Type load_anywhere(const Number* from) {
        const Vector vector = *reinterpret_cast<const typename Compiled::Anywhere*>(from);
        return vector;
    }
    static void store_anywhere(const Type& x, Number* to) {
        *reinterpret_cast<typename Compiled::Anywhere*>(to) = x.vector;
    }
    [[nodiscard]] static Number sum(const Type& x) {
        if constexpr (width == 2) {
            return x.vector[0] + x.vector[1];
        } else {
            return Register<Number, width / 2>::sum(
                low_and_high(x.vector, std::make_index_sequence<width / 2>()));
        }
    }

    /// Returns two sums at once, which takes as long as one.
    [[nodiscard]] static std::array<Number, 2> sums(const Type& x, const Type& y) {
#if defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
        if constexpr (std::is_same_v<Number, double>) {
            return folded(in_turn(x.vector, y.vector, std::make_index_sequence<width>()));
        }
#endif
#endif
        return {sum(x), sum(y)};
    }

private:
    using Compiled = CompilerVector<Number, width>;
    using Vector = typename Compiled::Type;

    template <class, std::size_t>
    friend struct Register;

#if defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
    /// Returns x_0 + x_1, y_0 + y_1, x_2 + x_3, ...
    template <std::size_t... i>
    [[nodiscard]] static Vector in_turn(const Vector& x, const Vector& y,
                                        std::index_sequence<i...>) {
        const Vector even =
            __builtin_shufflevector(x, y, static_cast<int>(i % 2 * width + i / 2 * 2)...);
        const Vector odd =
            __builtin_shufflevector(x, y, static_cast<int>(i % 2 * width + i / 2 * 2 + 1)...);
        return even + odd;
    }

    /// Returns x_0 + x_2 + ..., and x_1 + x_3 + ...
    [[nodiscard]] static std::array<Number, 2> folded(const Vector& x) {
        if constexpr (width == 2) {
            return {x[0], x[1]};
        } else {
            return Register<Number, width / 2>::folded(
                low_and_high(x, std::make_index_sequence<width / 2>()));
        }
    }
#endif
#endif

    /// Returns x_0 + x_{w/2}, x_1 + x_{w/2+1}, ..., where w is the width.
    template <std::size_t... i>
    [[nodiscard]] static typename CompilerVector<Number, width / 2>::Type
    low_and_high(const Vector& x, std::index_sequence<i...>) {
        using Half = typename CompilerVector<Number, width / 2>::Type;
#if defined(__AVX__) && !defined(__clang__)
        // NOTE: g++ would permute the whole register, which takes twice as long.
        if constexpr (std::is_same_v<Number, double> && width == 4) {
            const Half low = __builtin_ia32_pd_pd256(x);
            const Half high = __builtin_ia32_vextractf128_pd256(x, 1);
            return low + high;
        }
#endif
#if defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
        const Half low = __builtin_shufflevector(x, x, static_cast<int>(i)...);
        const Half high = __builtin_shufflevector(x, x, static_cast<int>(i + width / 2)...);
        return low + high;
#endif
#endif
        return Half{(x[i] + x[i + width / 2])...};
    }
#endif
};

template <class Number>
struct Register<Number, 1> {
    using Type = Number;
    [[nodiscard]] static const Number& load(const Number* from) { return *from; }
    static void store(const Number& x, Number* to) { *to = x; }
    [[nodiscard]] static const Number& load_anywhere(const Number* from) { return *from; }
    static void store_anywhere(const Number& x, Number* to) { *to = x; }
    [[nodiscard]] static const Number& sum(const Number& x) { return x; }
    [[nodiscard]] static std::array<Number, 2> sums(const Number& x, const Number& y) {
        return {x, y};
    }
};

}  // namespace hvi::detail

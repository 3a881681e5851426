// Numbers side by side: one operation computes them all.
// SPDX-License-Identifier: MIT
//
// Where xsimd (8 or later) is found, double and float are computed in vectors of the processor, as
// wide as the compiler is told that it has them, functions included. Without xsimd, with
// -DHVI_NO_XSIMD and for other numbers the same is done one by one, in plain C++. Both round
// differently in the last bits, and so do vectors of different width where a compiler fuses
// products and sums; each build gives the same bits again.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include <hvi/arithmetic.hpp>
#include <hvi/math.hpp>
#include <hvi/scalar.hpp>
#include <hvi/system.hpp>

#if !defined(HVI_NO_XSIMD) && defined(__has_include)
#if __has_include(<xsimd/xsimd.hpp>)
#define HVI_HAS_XSIMD 1
#include <xsimd/xsimd.hpp>
#endif
#endif
#ifndef HVI_HAS_XSIMD
#define HVI_HAS_XSIMD 0
#endif

namespace hvi {
namespace detail {

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

template <class Number, std::size_t width>
inline constexpr bool has_register = !std::is_void_v<typename RegisterOf<Number, width>::type>;

/// How many numbers go into one register where `places` are to fill registers; 1: there is none.
template <class Number, std::size_t places>
[[nodiscard]] constexpr std::size_t register_width() {
    if (places % 8 == 0 && has_register<Number, 8>) { return 8; }
    if (places % 4 == 0 && has_register<Number, 4>) { return 4; }
    if (places % 2 == 0 && has_register<Number, 2>) { return 2; }
    return 1;
}

/// What computes `width` numbers at once.
template <class Number, std::size_t width>
struct Register {
    using Type = typename RegisterOf<Number, width>::type;
    [[nodiscard]] static Type load(const Number* from) { return Type::load_aligned(from); }
    static void store(const Type& x, Number* to) { x.store_aligned(to); }
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
    [[nodiscard]] static const Number& sum(const Number& x) { return x; }
};

/// So many places hold `count` numbers: registers of 4 and 8 are filled.
[[nodiscard]] constexpr std::size_t places_for(std::size_t count) {
    return count <= 2 ? count : (count + 3) / 4 * 4;
}

/// Numbers in memory, one for each of `count` lanes. Places that are left over are copies of the
/// last lane, so that nothing can happen there that does not happen in it; or zeros.
template <class Number, std::size_t count>
struct LaneRow {
    static constexpr std::size_t places = places_for(count);
    static constexpr std::size_t alignment =
        register_width<Number, places>() == 1 ? alignof(Number) : 64;

    alignas(alignment) Number at[places];

    [[nodiscard]] constexpr Number& operator[](std::size_t lane) { return at[lane]; }
    [[nodiscard]] constexpr const Number& operator[](std::size_t lane) const { return at[lane]; }

    /// Sets a lane, and its copies.
    constexpr void set(std::size_t lane, const Number& x) {
        at[lane] = x;
        for (std::size_t i = count; lane == count - 1 && i < places; ++i) { at[i] = x; }
    }
};

}  // namespace detail

/// `count` Numbers, in registers.
template <class Number, std::size_t count>
class Lanes {
    static constexpr std::size_t places = detail::places_for(count);
    static constexpr std::size_t width = detail::register_width<Number, places>();
    using Register = detail::Register<Number, width>;
    using Part = typename Register::Type;

public:
    using Row = detail::LaneRow<Number, count>;

    Lanes() = default;

    /// The same in all lanes.
    Lanes(const Number& x) {
        for (Part& part : parts_) { part = Part(x); }
    }

    Lanes(const Row& row) {
        for (std::size_t i = 0; i < parts; ++i) { parts_[i] = Register::load(row.at + i * width); }
    }

    void store(Row& row) const {
        for (std::size_t i = 0; i < parts; ++i) { Register::store(parts_[i], row.at + i * width); }
    }

    /// f(x) in each lane, f being a function of one register.
    template <class F>
    [[nodiscard]] Lanes map(F f) const {
        Lanes result;
        for (std::size_t i = 0; i < parts; ++i) { result.parts_[i] = f(parts_[i]); }
        return result;
    }

    template <class F>
    [[nodiscard]] Lanes map(const Lanes& other, F f) const {
        Lanes result;
        for (std::size_t i = 0; i < parts; ++i) {
            result.parts_[i] = f(parts_[i], other.parts_[i]);
        }
        return result;
    }

    [[nodiscard]] friend Lanes operator-(const Lanes& x) {
        return x.map([](const Part& a) -> Part { return -a; });
    }
    [[nodiscard]] friend Lanes operator+(const Lanes& x, const Lanes& y) {
        return x.map(y, [](const Part& a, const Part& b) -> Part { return a + b; });
    }
    [[nodiscard]] friend Lanes operator-(const Lanes& x, const Lanes& y) {
        return x.map(y, [](const Part& a, const Part& b) -> Part { return a - b; });
    }
    [[nodiscard]] friend Lanes operator*(const Lanes& x, const Lanes& y) {
        return x.map(y, [](const Part& a, const Part& b) -> Part { return a * b; });
    }
    [[nodiscard]] friend Lanes operator/(const Lanes& x, const Lanes& y) {
        return x.map(y, [](const Part& a, const Part& b) -> Part { return a / b; });
    }

    [[nodiscard]] friend Lanes abs(const Lanes& x) {
        return x.map([](const Part& a) -> Part {
            using detail::abs;  // xsimd's is found by its argument
            return abs(a);
        });
    }

    /// Over all places, those that are left over included.
    [[nodiscard]] friend Number sum(const Lanes& x) {
        Part total = x.parts_[0];
        for (std::size_t i = 1; i < parts; ++i) { total = total + x.parts_[i]; }
        return Register::sum(total);
    }

    /// Over the lanes alone.
    [[nodiscard]] friend Number sum_of_lanes(const Lanes& x) {
        if constexpr (count == places) {
            return sum(x);
        } else {
            Row row;
            x.store(row);
            Number total = row[0];
            for (std::size_t i = 1; i < count; ++i) { total = total + row[i]; }
            return total;
        }
    }

private:
    static constexpr std::size_t parts = places / width;

    std::array<Part, parts> parts_;
};

// NOTE: headers of scenes call functions as hvi::math::sin(x), of one number and of several. Those
// of a register are found by its type.
namespace math {

template <class Number, std::size_t count>
[[nodiscard]] Lanes<Number, count> acos(const Lanes<Number, count>& x) {
    return x.map([](const auto& a) { return acos(a); });
}
template <class Number, std::size_t count>
[[nodiscard]] Lanes<Number, count> asin(const Lanes<Number, count>& x) {
    return x.map([](const auto& a) { return asin(a); });
}
template <class Number, std::size_t count>
[[nodiscard]] Lanes<Number, count> atan(const Lanes<Number, count>& x) {
    return x.map([](const auto& a) { return atan(a); });
}
template <class Number, std::size_t count>
[[nodiscard]] Lanes<Number, count> cos(const Lanes<Number, count>& x) {
    return x.map([](const auto& a) { return cos(a); });
}
template <class Number, std::size_t count>
[[nodiscard]] Lanes<Number, count> cosh(const Lanes<Number, count>& x) {
    return x.map([](const auto& a) { return cosh(a); });
}
template <class Number, std::size_t count>
[[nodiscard]] Lanes<Number, count> exp(const Lanes<Number, count>& x) {
    return x.map([](const auto& a) { return exp(a); });
}
template <class Number, std::size_t count>
[[nodiscard]] Lanes<Number, count> expm1(const Lanes<Number, count>& x) {
    return x.map([](const auto& a) { return expm1(a); });
}
template <class Number, std::size_t count>
[[nodiscard]] Lanes<Number, count> log(const Lanes<Number, count>& x) {
    return x.map([](const auto& a) { return log(a); });
}
/// NOTE: one by one. That of xsimd is exp(y log(x)), off by as many units in the last place as that
/// exponent is large.
template <class Number, std::size_t count>
[[nodiscard]] Lanes<Number, count> pow(const Lanes<Number, count>& x,
                                       const Lanes<Number, count>& y) {
    typename Lanes<Number, count>::Row base, exponent;
    x.store(base);
    y.store(exponent);
    for (std::size_t i = 0; i < count; ++i) { base.set(i, pow(base[i], exponent[i])); }
    return base;
}
template <class Number, std::size_t count>
[[nodiscard]] Lanes<Number, count> pow(const Lanes<Number, count>& x, const Number& y) {
    return pow(x, Lanes<Number, count>(y));
}
template <class Number, std::size_t count>
[[nodiscard]] Lanes<Number, count> pow(const Number& x, const Lanes<Number, count>& y) {
    return pow(Lanes<Number, count>(x), y);
}
template <class Number, std::size_t count>
[[nodiscard]] Lanes<Number, count> sin(const Lanes<Number, count>& x) {
    return x.map([](const auto& a) { return sin(a); });
}
template <class Number, std::size_t count>
[[nodiscard]] Lanes<Number, count> sinh(const Lanes<Number, count>& x) {
    return x.map([](const auto& a) { return sinh(a); });
}
template <class Number, std::size_t count>
[[nodiscard]] Lanes<Number, count> sqrt(const Lanes<Number, count>& x) {
    return x.map([](const auto& a) { return sqrt(a); });
}
template <class Number, std::size_t count>
[[nodiscard]] Lanes<Number, count> tan(const Lanes<Number, count>& x) {
    return x.map([](const auto& a) { return tan(a); });
}
template <class Number, std::size_t count>
[[nodiscard]] Lanes<Number, count> tanh(const Lanes<Number, count>& x) {
    return x.map([](const auto& a) { return tanh(a); });
}

}  // namespace math

namespace detail {

/// How many numbers are computed at once.
template <class Value>
inline constexpr int lane_count = 1;
template <class Number, std::size_t count>
inline constexpr int lane_count<Lanes<Number, count>> = static_cast<int>(count);

/// Rows of coefficients, as tables of steppers have them, and their columns, for lanes.
template <class Number, std::size_t count>
[[nodiscard]] constexpr LaneRow<Number, count> lane_row(const Number (&row)[count]) {
    LaneRow<Number, count> result{};
    for (std::size_t i = 0; i < count; ++i) { result.set(i, row[i]); }
    return result;
}

template <class Number, std::size_t count>
[[nodiscard]] constexpr LaneRow<Number, count> lane_row(const std::array<Number, count>& row) {
    LaneRow<Number, count> result{};
    for (std::size_t i = 0; i < count; ++i) { result.set(i, row[i]); }
    return result;
}

template <class Number, std::size_t count>
using LaneMatrix = std::array<LaneRow<Number, count>, count>;  ///< columns

template <class Number, std::size_t count>
[[nodiscard]] constexpr LaneMatrix<Number, count>
lane_columns(const Number (&matrix)[count][count]) {
    LaneMatrix<Number, count> columns{};
    for (std::size_t j = 0; j < count; ++j) {
        for (std::size_t i = 0; i < count; ++i) { columns[j].set(i, matrix[i][j]); }
    }
    return columns;
}

/// One row of lanes for each component of a vector, in registers and in memory.
template <class Number, std::size_t count, std::size_t dimension>
using LaneVector = std::array<Lanes<Number, count>, dimension>;
template <class Number, std::size_t count, std::size_t dimension>
using LaneRows = std::array<LaneRow<Number, count>, dimension>;

template <class Number, std::size_t count, std::size_t dimension>
[[nodiscard]] LaneVector<Number, count, dimension>
load(const LaneRows<Number, count, dimension>& rows) {
    LaneVector<Number, count, dimension> lanes;
    for (std::size_t k = 0; k < dimension; ++k) { lanes[k] = rows[k]; }
    return lanes;
}

template <class Number, std::size_t count, std::size_t dimension>
void store(const LaneVector<Number, count, dimension>& lanes,
           LaneRows<Number, count, dimension>& rows) {
    for (std::size_t k = 0; k < dimension; ++k) { lanes[k].store(rows[k]); }
}

/// The vector of one lane.
template <class Vector, class Number, std::size_t count, std::size_t dimension>
[[nodiscard]] Vector lane_of(const LaneRows<Number, count, dimension>& rows, std::size_t lane) {
    Vector v{};
    for (std::size_t k = 0; k < dimension; ++k) { detail::at(v, k) = rows[k][lane]; }
    return v;
}

/// start + matrix x.
///
/// NOTE: in two sums, as a processor adds several times faster than it waits for one sum. And
/// inlined, as no register of this size lives through a call.
template <class Number, std::size_t count>
[[nodiscard, gnu::always_inline]] inline Lanes<Number, count>
product(const LaneMatrix<Number, count>& matrix, const LaneRow<Number, count>& x,
        Lanes<Number, count> start) {
    using Lane = Lanes<Number, count>;
    start = start + x[0] * Lane(matrix[0]);
    if constexpr (count > 1) {
        Lane other = x[1] * Lane(matrix[1]);
        for (std::size_t j = 2; j + 1 < count; j += 2) {
            start = start + x[j] * Lane(matrix[j]);
            other = other + x[j + 1] * Lane(matrix[j + 1]);
        }
        if constexpr (count % 2 == 1) { start = start + x[count - 1] * Lane(matrix[count - 1]); }
        start = start + other;
    }
    return start;
}

}  // namespace detail
}  // namespace hvi

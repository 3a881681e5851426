// Dual numbers, by which steps are differentiated exactly.
// SPDX-License-Identifier: MIT
//
// NOTE: to be included before the header of a stepper. Its templates look up hvi::math::sin(x) and
// hvi::detail::abs(x) where they are defined.
#pragma once

#include <cstddef>
#include <type_traits>

#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/math.hpp>
#include <hvi/detail/numbers/more_math.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/numbers/small_turns.hpp>

// NOTE: a namespace of its own, so that calls with dual numbers look up functions of the runtime
// where they are named alone.
namespace hvi::duals {

/// A number and its derivatives by n variables. Values are computed as numbers alone are.
/// Derivatives follow the rules of calculus: they are exact but for rounding, and no differences
/// are taken. Numbers are ordered by their values, and are equal if all their parts are.
///
/// NOTE: sums and products of many parts are not inlined. With 36 of them g++ then compiles a
/// stepper in half of the time, and its steps are as fast. Those of 6 parts are: steps of a top
/// would take 4 times as long, and with one part 13 times.
template <class Number, std::size_t n>
class Dual {
public:
    Number value = 0;
    Number by[n] = {};  ///< the derivatives

    constexpr Dual() = default;
    constexpr Dual(const Dual&) = default;
    constexpr Dual& operator=(const Dual&) = default;
    ~Dual() = default;

    /// Makes a constant.
    template <class Real,
              class = std::enable_if_t<std::is_arithmetic_v<Real> || std::is_same_v<Real, Number>>>
    constexpr Dual(Real constant) : value(static_cast<Number>(constant)) {}

    /// Copies a volatile number. NOTE: the runtime reads numbers through volatile ones, where a
    /// compiler must not know what they are.
    Dual(const volatile Dual& x) : value(x.value) {
        for (std::size_t i = 0; i < n; ++i) { by[i] = x.by[i]; }
    }

    /// Returns the value.
    explicit constexpr operator Number() const { return value; }

    /// Returns f(x), given f(x.value) and f'(x.value). NOTE: a zero derivative of x gives a zero
    /// derivative of f(x) even where f' is infinite.
    [[nodiscard]] friend constexpr Dual chain(const Dual& x, const Number& f, const Number& slope) {
        Dual result(f);
        for (std::size_t i = 0; i < n; ++i) { result.by[i] = x.by[i] == 0 ? 0 : slope * x.by[i]; }
        return result;
    }

    constexpr Dual& operator+=(const Dual& y) {
        return changed(y, [](Dual& x, const Dual& by_y) {
            x.value += by_y.value;
            for (std::size_t i = 0; i < n; ++i) { x.by[i] += by_y.by[i]; }
        });
    }
    constexpr Dual& operator-=(const Dual& y) {
        return changed(y, [](Dual& x, const Dual& by_y) {
            x.value -= by_y.value;
            for (std::size_t i = 0; i < n; ++i) { x.by[i] -= by_y.by[i]; }
        });
    }
    constexpr Dual& operator*=(const Dual& y) {
        return changed(y, [](Dual& x, const Dual& by_y) {
            for (std::size_t i = 0; i < n; ++i) {
                x.by[i] = x.by[i] * by_y.value + x.value * by_y.by[i];
            }
            x.value *= by_y.value;
        });
    }
    constexpr Dual& operator/=(const Dual& y) {
        return changed(y, [](Dual& x, const Dual& by_y) {
            x.value /= by_y.value;
            for (std::size_t i = 0; i < n; ++i) {
                x.by[i] = (x.by[i] - x.value * by_y.by[i]) / by_y.value;
            }
        });
    }

    friend constexpr Dual operator+(Dual x, const Dual& y) { return x += y; }
    friend constexpr Dual operator-(Dual x, const Dual& y) { return x -= y; }
    friend constexpr Dual operator*(Dual x, const Dual& y) { return x *= y; }
    friend constexpr Dual operator/(Dual x, const Dual& y) { return x /= y; }
    friend constexpr Dual operator-(Dual x) {
        x.value = -x.value;
        for (Number& part : x.by) { part = -part; }
        return x;
    }

    friend constexpr bool operator<(const Dual& x, const Dual& y) { return x.value < y.value; }
    friend constexpr bool operator>(const Dual& x, const Dual& y) { return x.value > y.value; }
    friend constexpr bool operator<=(const Dual& x, const Dual& y) { return x.value <= y.value; }
    friend constexpr bool operator>=(const Dual& x, const Dual& y) { return x.value >= y.value; }
    friend constexpr bool operator==(const Dual& x, const Dual& y) {
        bool equal = x.value == y.value;
        for (std::size_t i = 0; i < n; ++i) { equal = equal && x.by[i] == y.by[i]; }
        return equal;
    }
    friend constexpr bool operator!=(const Dual& x, const Dual& y) { return !(x == y); }

private:
    template <class Change>
    constexpr Dual& changed(const Dual& y, Change change) {
        constexpr std::size_t most_inlined = 6;
        if constexpr (n <= most_inlined) {
            change(*this, y);
        } else {
            change_apart(*this, y, change);
        }
        return *this;
    }
    template <class Change>
    [[gnu::noinline]] static constexpr void change_apart(Dual& x, const Dual& y, Change change) {
        change(x, y);
    }
};

}  // namespace hvi::duals

namespace hvi::detail {

using duals::Dual;

template <class Number, std::size_t n>
inline constexpr int bits<Dual<Number, n>> = bits<Number>;

template <class Number, std::size_t n>
inline constexpr bool is_number<Dual<Number, n>> = true;

/// Returns the largest absolute value of all parts, a constant; NaN where a part is NaN.
///
/// NOTE: steppers take abs() of the changes of their iterations, and of the values that these are
/// compared with. They end an iteration where the changes no longer fall. Values converge first,
/// and derivatives, at the same rate, some iterations later: this abs() waits for both. An H calls
/// hvi::math::abs.
template <class Number, std::size_t n>
[[nodiscard]] Dual<Number, n> abs(const Dual<Number, n>& x) {
    Number largest = abs(x.value);
    for (const Number& part : x.by) {
        const Number size = abs(part);
        largest = size > largest || size != size ? size : largest;
    }
    return largest;
}

/// Returns 2/sqrt(pi) exp(-x^2).
template <class Number>
[[nodiscard]] Number slope_of_erf(const Number& x) {
    return 2 / math::sqrt(math::acos(Number(-1))) * math::exp(-x * x);
}

}  // namespace hvi::detail

namespace hvi::math {

template <class Number, std::size_t n>
inline constexpr bool computes_in<detail::Dual<Number, n>> = true;

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> acos(const detail::Dual<Number, n>& x) {
    const Number v = x.value;
    return chain(x, math::acos(v), -1 / math::sqrt((1 - v) * (1 + v)));
}

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> acosh(const detail::Dual<Number, n>& x) {
    const Number v = x.value;
    return chain(x, math::acosh(v), 1 / math::sqrt((v - 1) * (v + 1)));
}

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> asin(const detail::Dual<Number, n>& x) {
    const Number v = x.value;
    return chain(x, math::asin(v), 1 / math::sqrt((1 - v) * (1 + v)));
}

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> asinh(const detail::Dual<Number, n>& x) {
    return chain(x, math::asinh(x.value), 1 / math::sqrt(1 + x.value * x.value));
}

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> atan(const detail::Dual<Number, n>& x) {
    return chain(x, math::atan(x.value), 1 / (1 + x.value * x.value));
}

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> atan2(const detail::Dual<Number, n>& y,
                                            const detail::Dual<Number, n>& x) {
    const Number square = x.value * x.value + y.value * y.value;
    return chain(y, math::atan2(y.value, x.value), x.value / square) +
           chain(x, 0, -y.value / square);
}

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> atanh(const detail::Dual<Number, n>& x) {
    const Number v = x.value;
    return chain(x, math::atanh(v), 1 / ((1 - v) * (1 + v)));
}

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> cbrt(const detail::Dual<Number, n>& x) {
    const Number root = math::cbrt(x.value);
    return chain(x, root, 1 / (3 * root * root));
}

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> cos(const detail::Dual<Number, n>& x) {
    return chain(x, math::cos(x.value), -math::sin(x.value));
}

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> cosh(const detail::Dual<Number, n>& x) {
    return chain(x, math::cosh(x.value), math::sinh(x.value));
}

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> erf(const detail::Dual<Number, n>& x) {
    return chain(x, math::erf(x.value), detail::slope_of_erf(x.value));
}

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> erfc(const detail::Dual<Number, n>& x) {
    return chain(x, math::erfc(x.value), -detail::slope_of_erf(x.value));
}

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> exp(const detail::Dual<Number, n>& x) {
    return chain(x, math::exp(x.value), math::exp(x.value));
}

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> expm1(const detail::Dual<Number, n>& x) {
    return chain(x, math::expm1(x.value), math::exp(x.value));
}

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> log(const detail::Dual<Number, n>& x) {
    return chain(x, math::log(x.value), 1 / x.value);
}

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> log10(const detail::Dual<Number, n>& x) {
    return chain(x, math::log10(x.value), 1 / (x.value * math::log(Number(10))));
}

/// NOTE: where x is below 0, which has no logarithm, y counts as a constant.
template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> pow(const detail::Dual<Number, n>& x,
                                          const detail::Dual<Number, n>& y) {
    const Number value = math::pow(x.value, y.value);
    const Number by_x = y.value == 0 ? 0 : y.value * math::pow(x.value, y.value - 1);
    const Number by_y = value == 0 ? 0 : value * math::log(x.value);
    return chain(x, value, by_x) + chain(y, 0, by_y);
}

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> sin(const detail::Dual<Number, n>& x) {
    return chain(x, math::sin(x.value), math::cos(x.value));
}

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> sinh(const detail::Dual<Number, n>& x) {
    return chain(x, math::sinh(x.value), math::cosh(x.value));
}

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> small_double_sin(const detail::Dual<Number, n>& x) {
    return chain(x, math::small_double_sin(x.value), 2 * math::cos(2 * x.value));
}

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> small_tan(const detail::Dual<Number, n>& x) {
    const Number tan = math::small_tan(x.value);
    return chain(x, tan, 1 + tan * tan);
}

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> sqrt(const detail::Dual<Number, n>& x) {
    const Number root = math::sqrt(x.value);
    return chain(x, root, 1 / (2 * root));
}

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> tan(const detail::Dual<Number, n>& x) {
    const Number cos = math::cos(x.value);
    return chain(x, math::tan(x.value), 1 / (cos * cos));
}

template <class Number, std::size_t n>
[[nodiscard]] detail::Dual<Number, n> tanh(const detail::Dual<Number, n>& x) {
    const Number cosh = math::cosh(x.value);
    return chain(x, math::tanh(x.value), 1 / cosh / cosh);
}

template <class Number, std::size_t n>
[[nodiscard]] bool islessgreater(const detail::Dual<Number, n>& x,
                                 const detail::Dual<Number, n>& y) {
    return math::islessgreater(x.value, y.value);
}

template <class Number, std::size_t n>
[[nodiscard]] bool isnormal(const detail::Dual<Number, n>& x) {
    return math::isnormal(x.value);
}

}  // namespace hvi::math

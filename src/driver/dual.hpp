// Dual numbers, by which steps computed in double are differentiated exactly.
// SPDX-License-Identifier: MIT
//
// NOTE: to be included before the header of a stepper. Its templates look up hvi::math::sin(x) and
// hvi::detail::abs(x) where they are defined.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

#include <hvi/detail/linear/dense.hpp>
#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/math.hpp>
#include <hvi/detail/numbers/more_math.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/numbers/small_turns.hpp>
#include <hvi/detail/numbers/two_product.hpp>

namespace hvi::driver {

/// A double and its derivatives by n variables. Values are computed as in double. Derivatives
/// follow the rules of calculus: they are exact but for rounding, and no differences are taken.
/// Numbers are ordered by their values, and are equal if all their parts are.
///
/// NOTE: sums and products of many parts are not inlined. With 36 of them g++ then compiles a
/// stepper in half of the time, and its steps are as fast. Those of 6 parts are: steps of a top
/// would take 4 times as long, and with one part 13 times.
template <std::size_t n>
class Dual {
public:
    double value = 0;
    double by[n] = {};  ///< the derivatives

    constexpr Dual() = default;
    constexpr Dual(const Dual&) = default;
    constexpr Dual& operator=(const Dual&) = default;
    ~Dual() = default;

    /// Makes a constant.
    template <class Real, class = std::enable_if_t<std::is_arithmetic_v<Real>>>
    constexpr Dual(Real constant) : value(static_cast<double>(constant)) {}

    /// Copies a volatile number. NOTE: the runtime reads numbers through volatile ones, where a
    /// compiler must not know what they are.
    Dual(const volatile Dual& x) : value(x.value) {
        for (std::size_t i = 0; i < n; ++i) { by[i] = x.by[i]; }
    }

    /// Returns the value.
    explicit constexpr operator double() const { return value; }

    /// Returns f(x), given f(x.value) and f'(x.value). NOTE: a zero derivative of x gives a zero
    /// derivative of f(x) even where f' is infinite.
    [[nodiscard]] friend constexpr Dual chain(const Dual& x, double f, double slope) {
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
        for (double& part : x.by) { part = -part; }
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

/// Derivatives that a number has beside its value.
template <class Number>
inline constexpr std::size_t parts_of = 0;
template <std::size_t n>
inline constexpr std::size_t parts_of<Dual<n>> = n;

/// Returns variable number i with this value.
template <std::size_t n>
[[nodiscard]] constexpr Dual<n> variable(double value, std::size_t i) {
    Dual<n> x(value);
    x.by[i] = 1;
    return x;
}

/// Returns 2/sqrt(pi) exp(-x^2).
[[nodiscard]] inline double slope_of_erf(double x) {
    return 2 / std::sqrt(std::acos(-1.0)) * std::exp(-x * x);
}

}  // namespace hvi::driver

namespace hvi::math {

template <std::size_t n>
inline constexpr bool computes_in<driver::Dual<n>> = true;

template <std::size_t n>
[[nodiscard]] driver::Dual<n> acos(const driver::Dual<n>& x) {
    const double v = x.value;
    return chain(x, std::acos(v), -1 / std::sqrt((1 - v) * (1 + v)));
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> acosh(const driver::Dual<n>& x) {
    const double v = x.value;
    return chain(x, std::acosh(v), 1 / std::sqrt((v - 1) * (v + 1)));
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> asin(const driver::Dual<n>& x) {
    const double v = x.value;
    return chain(x, std::asin(v), 1 / std::sqrt((1 - v) * (1 + v)));
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> asinh(const driver::Dual<n>& x) {
    return chain(x, std::asinh(x.value), 1 / std::sqrt(1 + x.value * x.value));
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> atan(const driver::Dual<n>& x) {
    return chain(x, std::atan(x.value), 1 / (1 + x.value * x.value));
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> atan2(const driver::Dual<n>& y, const driver::Dual<n>& x) {
    const double square = x.value * x.value + y.value * y.value;
    return chain(y, std::atan2(y.value, x.value), x.value / square) +
           chain(x, 0, -y.value / square);
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> atanh(const driver::Dual<n>& x) {
    const double v = x.value;
    return chain(x, std::atanh(v), 1 / ((1 - v) * (1 + v)));
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> cbrt(const driver::Dual<n>& x) {
    const double root = std::cbrt(x.value);
    return chain(x, root, 1 / (3 * root * root));
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> cos(const driver::Dual<n>& x) {
    return chain(x, std::cos(x.value), -std::sin(x.value));
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> cosh(const driver::Dual<n>& x) {
    return chain(x, std::cosh(x.value), std::sinh(x.value));
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> erf(const driver::Dual<n>& x) {
    return chain(x, std::erf(x.value), driver::slope_of_erf(x.value));
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> erfc(const driver::Dual<n>& x) {
    return chain(x, std::erfc(x.value), -driver::slope_of_erf(x.value));
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> exp(const driver::Dual<n>& x) {
    return chain(x, std::exp(x.value), std::exp(x.value));
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> expm1(const driver::Dual<n>& x) {
    return chain(x, std::expm1(x.value), std::exp(x.value));
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> log(const driver::Dual<n>& x) {
    return chain(x, std::log(x.value), 1 / x.value);
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> log10(const driver::Dual<n>& x) {
    return chain(x, std::log10(x.value), 1 / (x.value * std::log(10.0)));
}

/// NOTE: where x is below 0, which has no logarithm, y counts as a constant.
template <std::size_t n>
[[nodiscard]] driver::Dual<n> pow(const driver::Dual<n>& x, const driver::Dual<n>& y) {
    const double value = std::pow(x.value, y.value);
    const double by_x = y.value == 0 ? 0 : y.value * std::pow(x.value, y.value - 1);
    const double by_y = value == 0 ? 0 : value * std::log(x.value);
    return chain(x, value, by_x) + chain(y, 0, by_y);
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> sin(const driver::Dual<n>& x) {
    return chain(x, std::sin(x.value), std::cos(x.value));
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> sinh(const driver::Dual<n>& x) {
    return chain(x, std::sinh(x.value), std::cosh(x.value));
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> small_double_sin(const driver::Dual<n>& x) {
    return chain(x, small_double_sin(x.value), 2 * std::cos(2 * x.value));
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> small_tan(const driver::Dual<n>& x) {
    const double tan = small_tan(x.value);
    return chain(x, tan, 1 + tan * tan);
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> sqrt(const driver::Dual<n>& x) {
    const double root = std::sqrt(x.value);
    return chain(x, root, 1 / (2 * root));
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> tan(const driver::Dual<n>& x) {
    const double cos = std::cos(x.value);
    return chain(x, std::tan(x.value), 1 / (cos * cos));
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> tanh(const driver::Dual<n>& x) {
    const double cosh = std::cosh(x.value);
    return chain(x, std::tanh(x.value), 1 / cosh / cosh);
}

template <std::size_t n>
[[nodiscard]] bool islessgreater(const driver::Dual<n>& x, const driver::Dual<n>& y) {
    return std::islessgreater(x.value, y.value);
}

template <std::size_t n>
[[nodiscard]] bool isnormal(const driver::Dual<n>& x) {
    return std::isnormal(x.value);
}

}  // namespace hvi::math

namespace hvi::detail {

template <std::size_t n>
inline constexpr int bits<driver::Dual<n>> = std::numeric_limits<double>::digits;

template <std::size_t n>
inline constexpr bool is_number<driver::Dual<n>> = true;

/// Returns the largest absolute value of all parts, a constant; NaN where a part is NaN.
///
/// NOTE: steppers take abs() of the changes of their iterations, and of the values that these are
/// compared with. They end an iteration where the changes no longer fall. Values converge first,
/// and derivatives, at the same rate, some iterations later: this abs() waits for both. An H calls
/// hvi::math::abs.
template <std::size_t n>
[[nodiscard]] driver::Dual<n> abs(const driver::Dual<n>& x) {
    double largest = std::abs(x.value);
    for (const double part : x.by) {
        const double size = std::abs(part);
        largest = size > largest || size != size ? size : largest;
    }
    return largest;
}

/// Returns a product of values with what rounding cuts off; derivatives have no digits to spare.
template <std::size_t n>
[[nodiscard]] Pair<driver::Dual<n>> two_product(const driver::Dual<n>& a,
                                                const driver::Dual<n>& b) {
    return {a * b, two_product(a.value, b.value).lo};
}

template <std::size_t n>
[[nodiscard]] driver::Dual<n> opaque(const driver::Dual<n>& x) {
    return x;
}

/// Factors of the values. With them Newton's method x -= J^-1 f(x) computes x as in double. With
/// any factors the derivatives converge to those of the solution, as x does.
template <std::size_t n>
class Factors<driver::Dual<n>> {
public:
    /// Computes the factors; see Factors.
    [[nodiscard]] bool compute(const SquareMatrix<driver::Dual<n>>& matrix) {
        SquareMatrix<double> values(matrix.size());
        for (std::size_t i = 0; i < matrix.size(); ++i) {
            for (std::size_t j = 0; j < matrix.size(); ++j) { values(i, j) = matrix(i, j).value; }
        }
        size_ = matrix.size();
        return factors_.compute(values);
    }

    /// Replaces the right side b by the solution.
    void solve(driver::Dual<n>* b) const {
        solve_part([&](std::size_t k) -> double& { return b[k].value; });
        for (std::size_t i = 0; i < n; ++i) {
            solve_part([&](std::size_t k) -> double& { return b[k].by[i]; });
        }
    }
    void solve(driver::Dual<n>* b, std::size_t) const { solve(b); }

private:
    template <class Part>
    void solve_part(Part part) const {
        std::vector<double> side(size_);
        for (std::size_t k = 0; k < size_; ++k) { side[k] = part(k); }
        factors_.solve(side.data());
        for (std::size_t k = 0; k < size_; ++k) { part(k) = side[k]; }
    }

    Factors<double> factors_;
    std::size_t size_ = 0;
};

}  // namespace hvi::detail

// Dual numbers of doubles.
// SPDX-License-Identifier: MIT
//
// NOTE: to be included before the header of a stepper, as those of any numbers are.
#pragma once

#include <cstddef>
#include <vector>

#include <hvi/detail/linear/dense.hpp>
#include <hvi/detail/numbers/dual.hpp>
#include <hvi/detail/numbers/two_product.hpp>

namespace hvi::driver {

/// A double and its derivatives by n variables.
template <std::size_t n>
using Dual = detail::Dual<double, n>;

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

}  // namespace hvi::driver

namespace hvi::detail {

/// Returns a product of values with what rounding cuts off; derivatives have no digits to spare.
template <std::size_t n>
[[nodiscard]] Pair<driver::Dual<n>> two_product(const driver::Dual<n>& a,
                                                const driver::Dual<n>& b) {
    return {a * b, two_product(a.value, b.value).lo};
}

/// Returns whether a number and its derivatives are 0: products with one that varies are none.
template <std::size_t n>
[[nodiscard]] bool is_zero(const Pair<driver::Dual<n>>& x) {
    for (const double part : x.hi.by) {
        if (part != 0) { return false; }
    }
    return x.hi == 0;
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

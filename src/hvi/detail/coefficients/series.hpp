// Truncated power series.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_SERIES_HPP
#define HVI_SERIES_HPP

#include <array>
#include <cstddef>

namespace hvi::detail {

/// Truncated series c_0 + c_1 t + ... + c_{n-1} t^{n-1}.
template <class T, std::size_t n>
class Series {
public:
    Series() = default;
    explicit Series(const T& constant) { c_[0] = constant; }

    [[nodiscard]] T& operator[](std::size_t j) { return c_[j]; }
    [[nodiscard]] const T& operator[](std::size_t j) const { return c_[j]; }

    friend Series operator+(Series a, const Series& b) {
        for (std::size_t j = 0; j < n; ++j) { a.c_[j] = a.c_[j] + b.c_[j]; }
        return a;
    }

    friend Series operator*(const Series& a, const Series& b) {
        Series product;
        for (std::size_t i = 0; i < n; ++i) {
            if (is_zero(a.c_[i])) { continue; }  // NOTE: every other coefficient of a sine is zero.
            for (std::size_t j = 0; i + j < n; ++j) {
                if (is_zero(b.c_[j])) { continue; }
                product.c_[i + j] = product.c_[i + j] + a.c_[i] * b.c_[j];
            }
        }
        return product;
    }

    /// Returns c_first + c_{first+1} t + ...
    [[nodiscard]] T sum_from(std::size_t first, const T& t) const {
        T sum{};
        for (std::size_t j = n; j-- > first;) { sum = sum * t + c_[j]; }
        return sum;
    }

private:
    std::array<T, n> c_{};
};

}  // namespace hvi::detail

#endif  // HVI_SERIES_HPP

// Products of coefficients with slopes side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <utility>

#include <hvi/detail/lanes/lane_tables.hpp>
#include <hvi/detail/lanes/lanes.hpp>
#include <hvi/detail/stages/moved.hpp>
#include <hvi/detail/stages/system.hpp>

namespace hvi::detail {

/// Number of components up to which a step has so little to compute that it waits for its own
/// stores.
inline constexpr std::size_t few_components = 3;

/// Keeps rows in memory, from where processors spread their numbers over the lanes of registers
/// while loading. g++ would take the numbers from the registers that were stored there, by
/// instructions that compete with the arithmetic.
///
/// NOTE: measured with AVX2, gauss:8: it reduces the time of Henon-Heiles to 0.88, that of Kepler's
/// problem to 0.96, and raises that of one component to 1.04. With AVX-512 registers are spread as
/// fast as they are loaded, and few registers do not wait to be stored.
template <class Number, std::size_t count, std::size_t dimension>
[[gnu::always_inline]] inline void keep_in_memory(const LaneRows<Number, count, dimension>& rows) {
#if HVI_REGISTER_BYTES
    constexpr std::size_t few = HVI_REGISTER_BYTES > 32 ? few_components : 1;
    if constexpr (dimension > few) {
        asm("" : "+m"(const_cast<LaneRows<Number, count, dimension>&>(rows)));
    }
#endif
    static_cast<void>(rows);
}

/// Returns start + matrix x, where the matrix consists of columns.
///
/// NOTE: in two sums, as a processor adds several times faster than it waits for one sum; and
/// inlined, as no register of this size lives through a call.
template <class Number, std::size_t rows, std::size_t columns, std::size_t most>
[[nodiscard, gnu::always_inline]] inline Lanes<Number, rows, most>
product(const std::array<LaneRow<Number, rows>, columns>& matrix, const LaneRow<Number, columns>& x,
        Lanes<Number, rows, most> start) {
    using Lane = Lanes<Number, rows, most>;
    start = start + x[0] * Lane(matrix[0]);
    if constexpr (columns > 1) {
        Lane other = x[1] * Lane(matrix[1]);
        for (std::size_t j = 2; j + 1 < columns; j += 2) {
            start = start + x[j] * Lane(matrix[j]);
            other = other + x[j + 1] * Lane(matrix[j + 1]);
        }
        if constexpr (columns % 2 == 1) {
            start = start + x[columns - 1] * Lane(matrix[columns - 1]);
        }
        start = start + other;
    }
    return start;
}

/// Number of rows that are multiplied with the columns of a matrix at once.
///
/// NOTE: enough rows that their sums do not wait for each other, and no more than stay in registers
/// beside a column.
template <class Lane>
inline constexpr std::size_t rows_at_once = Lane::registers <= 2   ? 4
                                            : Lane::registers <= 8 ? 9 / Lane::registers
                                                                   : 1;

/// Number of sums of registers that do not wait for each other: two products and sums start at
/// once, and each takes four cycles.
inline constexpr std::size_t sums_at_once = 8;

/// Calls use(k, y) with y_i = start(k + i) + matrix x_{k+i} for the rows k + i.
template <class Lane, class Slopes, class Start, class Use, std::size_t columns, std::size_t... i>
[[gnu::always_inline]] inline void
products_at(std::size_t k, const std::array<typename Lane::Row, columns>& matrix, const Slopes& x,
            Start start, Use use, std::index_sequence<i...>) {
    using Rows = std::array<Lane, sizeof...(i)>;
    if constexpr (sizeof...(i) * Lane::registers < sums_at_once) {
        use(k, Rows{product(matrix, x[k + i], start(k + i))...});
    } else {
        Rows y{start(k + i)...};
        for (std::size_t j = 0; j < columns; ++j) {
            const Lane column(matrix[j]);
            ((y[i] = y[i] + x[k + i][j] * column), ...);
        }
        use(k, y);
    }
}

/// Calls use(k, y) as products_at() does, in blocks that cover the rows from `first` to `last`,
/// that one excluded.
template <class Lane, std::size_t first, std::size_t last, class Slopes, class Start, class Use,
          std::size_t columns>
[[gnu::always_inline]] inline void
products_between(const std::array<typename Lane::Row, columns>& matrix, const Slopes& x,
                 Start start, Use use) {
    constexpr std::size_t dimension = last - first;
    constexpr std::size_t block = rows_at_once<Lane> < dimension ? rows_at_once<Lane> : dimension;
    if constexpr (dimension > 0) {
        for (std::size_t k = first; k + block <= last; k += block) {
            products_at<Lane>(k, matrix, x, start, use, std::make_index_sequence<block>());
        }
        constexpr std::size_t rest = dimension % block;
        if constexpr (rest > 0) {
            products_at<Lane>(last - rest, matrix, x, start, use, std::make_index_sequence<rest>());
        }
    }
}

/// Calls use(k, y) as products_at() does, in blocks that cover all rows.
template <class Lane, class Slopes, class Start, class Use, std::size_t columns>
[[gnu::always_inline]] inline void products(const std::array<typename Lane::Row, columns>& matrix,
                                            const Slopes& x, Start start, Use use) {
    products_between<Lane, 0, std::tuple_size_v<Slopes>>(matrix, x, start, use);
}

/// Stores lanes into the rows from k on.
template <class Lane, std::size_t n, std::size_t dimension>
void store_from(std::size_t k, const std::array<Lane, n>& lanes,
                std::array<typename Lane::Row, dimension>& rows) {
    for (std::size_t i = 0; i < n; ++i) { lanes[i].store(rows[k + i]); }
}

/// Sets the rows from k on to start + way, and adds up over lanes how much they change, for
/// `changes`.
template <class Lane, class Start, class Vector, std::size_t n, std::size_t dimension>
[[gnu::always_inline]] inline void
move_from(std::size_t k, const Start& start, const std::array<Lane, n>& ways,
          std::array<typename Lane::Row, dimension>& rows, Vector& changes) {
    std::array<Lane, n> change;
    for (std::size_t i = 0; i < n; ++i) {
        const Lane value = moved(detail::at(start, k + i), ways[i]);
        change[i] = abs(value - Lane(rows[k + i]));
        value.store(rows[k + i]);
    }
    const auto sums = Lane::sums(change);
    for (std::size_t i = 0; i < n; ++i) { detail::at(changes, k + i) = sums[i]; }
}

/// Sets rows = now rows + before (the rows before), and the rows before to the old rows.
template <class Lane, class Matrix, std::size_t dimension>
void extrapolate(std::array<typename Lane::Row, dimension>& rows, const Matrix& now,
                 const Matrix& before, std::array<typename Lane::Row, dimension>& rows_before) {
    std::array<typename Lane::Row, dimension> far;
    products<Lane>(
        before, rows_before, [](std::size_t) { return Lane(0); },
        [&](std::size_t k, const auto& y) { store_from(k, y, far); });
    copy<Lane>(rows, rows_before);
    products<Lane>(
        now, rows, [&](std::size_t k) { return Lane(far[k]); },
        [&](std::size_t k, const auto& y) { store_from(k, y, rows); });
}

template <class Lane, class Matrix, std::size_t dimension>
void extrapolate(std::array<typename Lane::Row, dimension>& rows, const Matrix& now) {
    products<Lane>(
        now, rows, [](std::size_t) { return Lane(0); },
        [&](std::size_t k, const auto& y) { store_from(k, y, rows); });
}

}  // namespace hvi::detail

// Vectors and tables of numbers side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/lanes/lanes.hpp>
#include <hvi/detail/stages/system.hpp>

namespace hvi::detail {

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

template <class Number, std::size_t count>
void store(const Lanes<Number, count>& lanes, LaneRow<Number, count>& row) {
    lanes.store(row);
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

/// rows = now rows + before (the rows before), and the rows before become these.
template <class Number, std::size_t count, std::size_t dimension>
void extrapolate(LaneRows<Number, count, dimension>& rows, const LaneMatrix<Number, count>& now,
                 const LaneMatrix<Number, count>& before,
                 LaneRows<Number, count, dimension>& rows_before) {
    for (std::size_t k = 0; k < dimension; ++k) {
        const LaneRow<Number, count> row = rows[k];
        const Lanes<Number, count> far =
            product(before, rows_before[k], Lanes<Number, count>(Number(0)));
        product(now, row, far).store(rows[k]);
        rows_before[k] = row;
    }
}

template <class Number, std::size_t count, std::size_t dimension>
void extrapolate(LaneRows<Number, count, dimension>& rows, const LaneMatrix<Number, count>& now) {
    for (LaneRow<Number, count>& row : rows) {
        product(now, row, Lanes<Number, count>(Number(0))).store(row);
    }
}

}  // namespace hvi::detail

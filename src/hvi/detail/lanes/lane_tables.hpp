// Vectors and tables of numbers side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/lanes/lanes.hpp>
#include <hvi/detail/stages/system.hpp>

namespace hvi::detail {

/// Makes rows of coefficients for lanes from tables of steppers, and their columns.
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
using LaneMatrix = std::array<LaneRow<Number, count>, count>;  ///< by columns

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

template <class Number, std::size_t count, std::size_t most>
void store(const Lanes<Number, count, most>& lanes, LaneRow<Number, count>& row) {
    lanes.store(row);
}

/// Rows as an argument of functions of a scene: reading loads a row, and writing stores a row times
/// a factor.
///
/// NOTE: this replaces vectors of lanes, which g++ copies from memory to memory in halves, so that
/// the next load waits for both.
template <class Lane>
class LaneAccess {
public:
    using Row = typename Lane::Row;

    /// Gives access for reading.
    [[gnu::always_inline]] explicit LaneAccess(const Row* rows) : from_(rows) {}
    /// Gives access for writing values times `factor`.
    [[gnu::always_inline]] LaneAccess(Row* rows, const Lane& factor) : to_(rows), factor_(factor) {}

    [[nodiscard, gnu::always_inline]] Lane operator[](std::size_t k) const { return from_[k]; }

    class Place {
    public:
        [[gnu::always_inline]] Place(Row& row, const Lane& factor) : row_(row), factor_(factor) {}
        [[gnu::always_inline]] void operator=(const Lane& value) { (factor_ * value).store(row_); }

    private:
        Row& row_;
        const Lane& factor_;
    };
    [[nodiscard, gnu::always_inline]] Place operator[](std::size_t k) { return {to_[k], factor_}; }

private:
    const Row* from_ = nullptr;
    Row* to_ = nullptr;
    Lane factor_;
};

template <class Lane>
struct HeldBy<LaneAccess<Lane>> {
    using type = Lane;
};

template <class Lane, std::size_t dimension>
[[nodiscard, gnu::always_inline]] inline LaneAccess<Lane>
read(const std::array<typename Lane::Row, dimension>& rows) {
    return LaneAccess<Lane>(rows.data());
}

template <class Lane, std::size_t dimension>
[[nodiscard, gnu::always_inline]] inline LaneAccess<Lane>
write(std::array<typename Lane::Row, dimension>& rows, const Lane& factor) {
    return LaneAccess<Lane>(rows.data(), factor);
}

/// Returns the vector of one lane.
template <class Vector, class Number, std::size_t count, std::size_t dimension>
[[nodiscard]] Vector lane_of(const LaneRows<Number, count, dimension>& rows, std::size_t lane) {
    Vector v{};
    for (std::size_t k = 0; k < dimension; ++k) { detail::at(v, k) = rows[k][lane]; }
    return v;
}

/// Returns the vector of the middle lane, or the mean of the two lanes in the middle.
template <class Vector, class Number, std::size_t count, std::size_t dimension>
[[nodiscard]] Vector middle_of(const LaneRows<Number, count, dimension>& rows) {
    Vector v{};
    for (std::size_t k = 0; k < dimension; ++k) {
        detail::at(v, k) = (rows[k][(count - 1) / 2] + rows[k][count / 2]) / 2;
    }
    return v;
}

template <class Lane, std::size_t dimension>
void copy(const std::array<typename Lane::Row, dimension>& from,
          std::array<typename Lane::Row, dimension>& to) {
    for (std::size_t k = 0; k < dimension; ++k) { Lane(from[k]).store(to[k]); }
}

/// Sets out = x - y.
template <class Lane>
void subtract(const typename Lane::Row& x, const typename Lane::Row& y, typename Lane::Row& out) {
    (Lane(x) - Lane(y)).store(out);
}

}  // namespace hvi::detail

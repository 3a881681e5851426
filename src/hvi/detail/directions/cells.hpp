// Directions and the stages of a step, in lanes: one direction, or eight.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/lanes/lane_products.hpp>
#include <hvi/detail/lanes/lane_tables.hpp>
#include <hvi/detail/lanes/lanes.hpp>
#include <hvi/detail/trajectories/trajectory_clock.hpp>

namespace hvi::detail {

/// One direction, whose stages are lanes. A cell is a number of each stage.
template <class Scalar, std::size_t stages, std::size_t most = widest>
struct StagesInLanes {
    static constexpr std::size_t directions = 1;
    static constexpr std::size_t parts = 1;  ///< of a cell
    using Lane = Lanes<Scalar, stages, most>;
    using Row = typename Lane::Row;
    using Cell = std::array<Lane, parts>;
    using Number = Scalar;  ///< of each direction,
    using Kept = Scalar;    ///< and in memory

    /// The factors of part i, where there is a factor for each stage.
    [[nodiscard]] static Lane factor(const LaneRow<Scalar, stages>& of_stages, std::size_t) {
        return Lane(of_stages);
    }

    /// start + matrix x of component k, the matrix being columns.
    template <class Rows>
    [[nodiscard, gnu::always_inline]] static Cell product(const LaneMatrix<Scalar, stages>& matrix,
                                                          const Rows& x, std::size_t k,
                                                          const Cell& start) {
        return {detail::product(matrix, x[0][k], start[0])};
    }

    /// Over the stages.
    [[nodiscard]] static Number sum(const Cell& x) { return sum_of_lanes(x[0]); }
    [[nodiscard]] static Number total(const Lane& x) { return sum_of_lanes(x); }

    /// Numbers that the system has kept for the stages of part i.
    template <std::size_t count>
    [[nodiscard]] static LaneAccess<Lane> kept(const LaneRows<Scalar, stages, count>& rows,
                                               std::size_t) {
        return read<Lane>(rows);
    }

    [[nodiscard]] static Scalar& of_direction(Kept& x, std::size_t) { return x; }
    static void store(const Number& x, Kept& to) { to = x; }

    template <class Rows>
    [[nodiscard]] static Scalar get(const Rows& rows, std::size_t stage, std::size_t k,
                                    std::size_t) {
        return rows[0][k][stage];
    }
    template <class Rows>
    static void set(Rows& rows, std::size_t stage, std::size_t k, std::size_t, const Scalar& x) {
        rows[0][k].set(stage, x);
    }

    [[nodiscard]] static bool all_of(bool each) { return each; }
    [[nodiscard]] static bool any_of(bool each) { return each; }
    [[nodiscard]] static Number smaller(const Number& a, const Number& b) { return a < b ? a : b; }
};

/// A number of one stage out of what the system has kept for all.
template <class Row>
class KeptOfStage {
public:
    KeptOfStage(const Row* rows, std::size_t stage) : rows_(rows), stage_(stage) {}

    [[nodiscard]] const auto& operator[](std::size_t k) const { return rows_[k][stage_]; }

private:
    const Row* rows_;
    std::size_t stage_;
};

/// Eight directions, which are lanes. A cell has a part for each stage.
template <class Scalar, std::size_t stages>
struct DirectionsInLanes {
    static constexpr std::size_t directions = trajectories_at_once;
    static constexpr std::size_t parts = stages;
    using Lane = Lanes<Scalar, directions>;
    using Row = typename Lane::Row;
    using Cell = std::array<Lane, parts>;
    using Number = Lane;
    using Kept = Row;

    [[nodiscard]] static Lane factor(const LaneRow<Scalar, stages>& of_stages, std::size_t i) {
        return Lane(of_stages[i]);
    }

    template <class Rows>
    [[nodiscard, gnu::always_inline]] static Cell product(const LaneMatrix<Scalar, stages>& matrix,
                                                          const Rows& x, std::size_t k,
                                                          const Cell& start) {
        Cell y = start;
        for (std::size_t j = 0; j < stages; ++j) {
            const Lane x_j(x[j][k]);
            for (std::size_t i = 0; i < stages; ++i) { y[i] = y[i] + matrix[j][i] * x_j; }
        }
        return y;
    }

    [[nodiscard]] static Number sum(const Cell& x) {
        Lane all = x[0];
        for (std::size_t i = 1; i < stages; ++i) { all = all + x[i]; }
        return all;
    }
    [[nodiscard]] static Number total(const Lane& x) { return x; }

    template <std::size_t count>
    [[nodiscard]] static KeptOfStage<LaneRow<Scalar, stages>>
    kept(const LaneRows<Scalar, stages, count>& rows, std::size_t i) {
        return {rows.data(), i};
    }

    [[nodiscard]] static Scalar& of_direction(Kept& x, std::size_t lane) { return x[lane]; }
    static void store(const Number& x, Kept& to) { x.store(to); }

    template <class Rows>
    [[nodiscard]] static Scalar get(const Rows& rows, std::size_t stage, std::size_t k,
                                    std::size_t direction) {
        return rows[stage][k][direction];
    }
    template <class Rows>
    static void set(Rows& rows, std::size_t stage, std::size_t k, std::size_t direction,
                    const Scalar& x) {
        rows[stage][k][direction] = x;
    }

    [[nodiscard]] static bool all_of(const typename Lane::Mask& each) { return all(each); }
    [[nodiscard]] static bool any_of(const typename Lane::Mask& each) { return any(each); }
    [[nodiscard]] static Number smaller(const Number& a, const Number& b) {
        return select(a < b, a, b);
    }
};

}  // namespace hvi::detail

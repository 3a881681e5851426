// The stages of a step with rotations, side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include <hvi/detail/coefficients/weights.hpp>
#include <hvi/detail/groups/chart.hpp>
#include <hvi/detail/groups/chart_memory.hpp>
#include <hvi/detail/groups/chart_space.hpp>
#include <hvi/detail/groups/lane_angles.hpp>
#include <hvi/detail/lanes/lane_math.hpp>
#include <hvi/detail/lanes/lane_products.hpp>
#include <hvi/detail/lanes/lane_tables.hpp>
#include <hvi/detail/lanes/lanes.hpp>
#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/stages/curve.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// Coefficients of ChartLanes.
template <class Scalar, std::size_t stages>
struct ChartTable {
    LaneMatrix<Scalar, stages> m, mt;
    LaneMatrix<Scalar, stages> of_charts{};  ///< -m_ji, of the momenta of charts

    constexpr ChartTable(const Scalar (&of_q)[stages][stages], const Scalar (&of_p)[stages][stages])
        : m(lane_columns(of_q)), mt(lane_columns(of_p)) {
        for (std::size_t j = 0; j < stages; ++j) {
            for (std::size_t i = 0; i < stages; ++i) { of_charts[j].set(i, -of_q[j][i]); }
        }
    }
};

/// ChartStages in lanes: there is a row for each component, with a lane for each stage. Fixed
/// points compute all stages at once, and Newton's method asks for one after the other.
///
/// NOTE: functions that sweeps call are inlined, as no register of this size lives through a call.
template <class Space, std::size_t stages, std::size_t most = widest>
class ChartLanes : public ChartMemory<Space> {
public:
    using Of = Space;
    using Scalar = typename Space::Scalar;
    using Vector = typename Space::Vector;
    using Positions = typename Space::Positions;
    using Part = Vector3<Scalar>;
    using Point = ChartPoint<Scalar>;
    using Lane = Lanes<Scalar, stages, most>;
    using Row = typename Lane::Row;
    using Table = ChartTable<Scalar, stages>;
    using Matrix = LaneMatrix<Scalar, stages>;

    static constexpr std::size_t count = stages;
    static constexpr std::size_t dimension = Space::degrees_of_freedom;
    using Rows = LaneRows<Scalar, stages, dimension>;

    Rows Lq{}, Lp{};
    Row hb{};              ///< h b_i; see weigh()
    Vector pi_end{};       ///< pi_1 behind the coordinates, whose places are unused
    State<Vector> change;  ///< of the stage values in one sweep

    /// Sets hb.
    void weigh(const Scalar (&b)[stages]) {
        if (this->h == weighed_) { return; }
        hb = lane_row(weights_of_step(this->h, b));
        weighed_ = this->h;
    }

    // ---- starting values ----

    /// Extrapolates the slopes of the last step, times `last`, or those of the last two. Returns
    /// false where there are none for steps of this size. See ChartStages.
    [[nodiscard]] bool extrapolate(const Table& table, const Matrix& last) {
        if (!this->goes_on) { return false; }
        weigh_momenta();
        for (Rows* rows : {&by_q_, &by_p_, &momenta_}) { detail::extrapolate<Lane>(*rows, last); }
        begin_with_weighted(table);
        return true;
    }
    [[nodiscard]] bool extrapolate(const Table& table, const Matrix& last, const Matrix& before) {
        const bool has_both = this->goes_on && has_slopes_before_;
        has_slopes_before_ = this->goes_on;
        if (!this->goes_on) { return false; }
        weigh_momenta();
        const auto move = [&](Rows& rows, Rows& rows_before) {
            if (has_both) {
                detail::extrapolate<Lane>(rows, last, before, rows_before);
            } else {
                rows_before = rows;
            }
        };
        move(by_q_, by_q_before_);
        move(by_p_, by_p_before_);
        move(momenta_, momenta_before_);
        if (has_both) { begin_with_weighted(table); }
        return has_both;
    }

    /// Sets slopes as at the start of the step, by gradient(q, p, dHdq, dHdp).
    template <class Gradient>
    void predict(const Table& table, Gradient gradient) {
        Vector by_q{}, by_p{};
        gradient(this->at.q, this->at.p, by_q, by_p);
        const Lane weights(hb);
        for (std::size_t k = 0; k < dimension; ++k) {
            (weights * Lane(by_q[k])).store(by_q_[k]);
            (weights * Lane(by_p[k])).store(by_p_[k]);
            Lane(this->at.p[k]).store(momenta_[k]);
        }
        begin_with_slopes(table);
    }

    /// Sets all slopes to zero: all stages are at the start of the step.
    void begin_without_slopes(const Table& table) {
        Lq = Lp = torques_ = {};
        balance(turns());
        momenta(table);
        positions(table);
    }

    /// Multiplies all slopes by a factor; see Sweeps.
    void nudge(const Scalar& factor) {
        for (Rows* rows : {&Lq, &Lp}) {
            for (Row& row : *rows) { (Lane(factor) * Lane(row)).store(row); }
        }
    }

    // ---- sweeps ----

    /// Points xi_1 = sum_i Lq_i, one for each rotation.
    using Turns = typename Space::template PerRotation<Point>;
    [[nodiscard, gnu::always_inline]] inline Turns turns() const {
        Turns all;
        for (std::size_t r = 0; r < Space::rotations; ++r) { all[r] = Point(sum_of(Lq, r)); }
        return all;
    }

    /// Returns L_1 of rotation r, from the torques of the stages and xi_1.
    [[nodiscard, gnu::always_inline]] inline Part momentum_at_end(std::size_t r,
                                                                  const Point& turn) const {
        return turn.turned_back(Space::part(this->at.p, r) - sum_of(torques_, r));
    }

    /// Sets pi_1 from the torques of the stages and xi_1.
    [[gnu::always_inline]] inline void balance(const Turns& turns) {
        for (std::size_t r = 0; r < Space::rotations; ++r) {
            Space::set_part(pi_end, r, turns[r].T_transposed(momentum_at_end(r, turns[r])));
        }
    }

    /// Sets P_i = p + (e_p + sum_j mt_ij Lp_j) and pi_i = pi_1 - sum_j m_ji Lp_j.
    [[gnu::always_inline]] inline void momenta(const Table& table) {
        keep_in_memory(Lp);
        products_between<Lane, 0, flat>(
            table.mt, Lp, [&](std::size_t k) { return Lane(this->remainder.p[k]); },
            [&](std::size_t k, const auto& ways)
                __attribute__((always_inline)) { move_from(k, this->at.p, ways, y_, change.p); });
        products_between<Lane, flat, dimension>(
            table.of_charts, Lp, [](std::size_t) { return Lane(Scalar(0)); },
            [&](std::size_t k, const auto& ways)
                __attribute__((always_inline)) { move_from(k, pi_end, ways, y_, change.p); });
    }

    /// Sets Q_i = q + (e_q + sum_j m_ij Lq_j) and xi_i = sum_j m_ij Lq_j.
    [[gnu::always_inline]] inline void positions(const Table& table) {
        keep_in_memory(Lq);
        products_between<Lane, 0, flat>(
            table.m, Lq, [&](std::size_t k) { return Lane(this->remainder.q[k]); },
            [&](std::size_t k, const auto& ways)
                __attribute__((always_inline)) { move_from(k, this->at.q, ways, x_, change.q); });
        products_between<Lane, flat, dimension>(
            table.m, Lq, [](std::size_t) { return Lane(Scalar(0)); },
            [&](std::size_t k, const auto& ways)
                __attribute__((always_inline)) { move_from(k, Vector{}, ways, x_, change.q); });
    }

    /// Sets both slopes of all stages, by gradient(q, p, dHdq, dHdp).
    template <class Gradient>
    [[gnu::always_inline]] inline void slopes(Gradient gradient) {
        const Points points = points_at(x_);
        for (std::size_t k = 0; k < flat; ++k) { Lane(y_[k]).store(momenta_[k]); }
        for (std::size_t r = 0; r < Space::rotations; ++r) {
            set_part(momenta_, r, points[r].T_inverse_transposed(part(y_, r)));
        }
        auto by_q = write<Lane>(by_q_, Lane(hb)), by_p = write<Lane>(by_p_, Lane(hb));
        gradient(places(points), read<Lane>(momenta_), by_q, by_p);
        set_slopes(points);
    }

    /// Return the size that the rounding of component k of the stages is compared with; see
    /// ChartStages.
    [[nodiscard]] Scalar size_q(std::size_t k) const {
        const bool is_flat = k < flat;
        const std::size_t first = flat + 9 * ((k - flat) / 3);
        Scalar size = is_flat ? detail::abs(this->at.q[k]) : Scalar(0);
        for (std::size_t l = first; l < first + 9 && !is_flat; ++l) {
            size = larger(size, detail::abs(this->at.q[l]));
        }
        return size + sum(abs(Lane(x_[k])) + abs(Lane(Lq[k])));
    }
    [[nodiscard]] Scalar size_p(std::size_t k) const {
        const bool is_flat = k < flat;
        const std::size_t first = is_flat ? k : k - (k - flat) % 3;
        Scalar size = 0;
        for (std::size_t l = first; l < first + (is_flat ? 1 : 3); ++l) {
            size += detail::abs(this->at.p[l]) + sum(abs(Lane(y_[l])) + abs(Lane(Lp[l])));
        }
        return size;
    }

    // ---- the end ----

    /// Returns whether all stages, and the end, are in the chart; see ChartStages.
    [[nodiscard]] bool is_in_chart() const {
        constexpr double limit = 39.4784176;  // 4 pi^2, a little less
        bool is_in = true;
        for (const Point& point : turns()) {
            is_in = is_in && !(point.square_of_angle() > Scalar(limit));
        }
        for (std::size_t r = 0; r < Space::rotations; ++r) {
            const Vector3<Lane> xi = part(x_, r);
            is_in = is_in && !any(Lane(Scalar(limit)) < dot(xi, xi));
        }
        return is_in;
    }

    /// Moves `at` to the end of the step.
    void advance() {
        for (std::size_t k = 0; k < flat; ++k) {
            this->advance_flat(k, sum_of_lanes(Lane(Lq[k])), sum_of_lanes(Lane(Lp[k])));
        }
        const Turns turns = this->turns();
        for (std::size_t r = 0; r < Space::rotations; ++r) {
            const Part torque = Part{} - sum_of(torques_, r);
            this->advance_rotation(r, turns[r], times(Space::rotation(this->at.q, r), torque));
        }
    }

    // ---- the curve of the last step ----

    /// Returns the position at tau; see ChartStages.
    template <class... Bend>
    [[nodiscard]] Positions position(Scalar tau, const Bend&... bend) const {
        if (!this->has_ended()) { return nowhere(Positions{}); }
        Positions q{};
        for (std::size_t k = 0; k < flat; ++k) {
            const Scalar to_end = (Scalar(1) - tau) * sum_of_lanes(Lane(Lq[k]));
            const Scalar away = bend_of(k, bend...) - to_end;
            q[k] = this->at.q[k] + (this->remainder.q[k] + away);
        }
        for (std::size_t r = 0; r < Space::rotations; ++r) {
            Part xi = tau * sum_of(Lq, r);
            for (std::size_t k = 0; k < 3; ++k) { xi[k] += bend_of(flat + 3 * r + k, bend...); }
            Space::set_rotation(q, r, this->rotated_from_start(r, Point(xi)));
        }
        return q;
    }

    // ---- one stage, for Newton's method; see ChartStages ----

    struct StageSlopes {
        Vector by_q{}, by_p{}, momentum{};
    };
    [[nodiscard]] StageSlopes slopes_of_stage(std::size_t i) const {
        StageSlopes slopes;
        for (std::size_t k = 0; k < dimension; ++k) {
            slopes.by_q[k] = by_q_[k][i] / hb[i];
            slopes.by_p[k] = by_p_[k][i] / hb[i];
            slopes.momentum[k] = momenta_[k][i];
        }
        return slopes;
    }
    [[nodiscard]] Point point(std::size_t i, std::size_t r) const {
        return Point(Space::part(lane_of<Vector>(x_, i), r));
    }
    [[nodiscard]] Positions position(std::size_t i) const {
        Positions q{};
        for (std::size_t k = 0; k < flat; ++k) { q[k] = x_[k][i]; }
        for (std::size_t r = 0; r < Space::rotations; ++r) {
            Space::set_rotation(q, r, this->rotated(r, point(i, r)));
        }
        return q;
    }
    [[nodiscard]] const Scalar& slope_q(std::size_t i, std::size_t k) const { return Lq[k][i]; }
    [[nodiscard]] const Scalar& slope_p(std::size_t i, std::size_t k) const { return Lp[k][i]; }
    void set_slope_q(std::size_t i, std::size_t k, const Scalar& value) { Lq[k].set(i, value); }
    void set_slope_p(std::size_t i, std::size_t k, const Scalar& value) { Lp[k].set(i, value); }

private:
    static constexpr std::size_t flat = Space::coordinates;
    using Points = std::array<ChartPoint<Lane>, Space::rotations>;
    using Places = std::array<Lane, flat + 9 * Space::rotations>;

    [[nodiscard, gnu::always_inline]] static Vector3<Lane> part(const Rows& rows, std::size_t r) {
        const std::size_t k = flat + 3 * r;
        return {Lane(rows[k]), Lane(rows[k + 1]), Lane(rows[k + 2])};
    }
    [[gnu::always_inline]] static void set_part(Rows& rows, std::size_t r,
                                                const Vector3<Lane>& part) {
        for (std::size_t k = 0; k < 3; ++k) { part[k].store(rows[flat + 3 * r + k]); }
    }

    /// 1 in lanes, 0 in places that are left over.
    static constexpr Row lanes_alone() {
        Row row{};
        for (std::size_t i = 0; i < stages; ++i) { row.at[i] = Scalar(1); }
        return row;
    }

    /// Returns the sums over the stages of a rotation's components. NOTE: by products, as
    /// sum_of_lanes() goes through memory where places are left over, and a sweep waits for these
    /// sums.
    [[nodiscard, gnu::always_inline]] static Part sum_of(const Rows& rows, std::size_t r) {
        Vector3<Lane> all = part(rows, r);
        if constexpr (Row::places > stages) { all = Lane(lanes_alone()) * all; }
        return Lane::sums(all);
    }

    [[nodiscard, gnu::always_inline]] static Points points_at(const Rows& xi) {
        Points points;
        for (std::size_t r = 0; r < Space::rotations; ++r) {
            points[r] = ChartPoint<Lane>(part(xi, r));
        }
        return points;
    }

    /// Returns the positions of all stages. NOTE: where a gradient takes no rotations, or some rows
    /// of them, compilers leave out the rest.
    [[nodiscard, gnu::always_inline]] Places places(const Points& points) const {
        Places q;
        for (std::size_t k = 0; k < flat; ++k) { q[k] = Lane(x_[k]); }
        for (std::size_t r = 0; r < Space::rotations; ++r) {
            const Matrix3<Lane> R = this->rotated(r, points[r]);
            for (std::size_t k = 0; k < 9; ++k) { q[flat + 9 * r + k] = R[k]; }
        }
        return q;
    }

    /// Sets Lq, Lp and the torques from h b_i (dH/dq, D), h b_i (dH/dp, Omega) and L_i: the
    /// gradient of L . T w by xi is linear in w.
    [[gnu::always_inline]] inline void set_slopes(const Points& points) {
        for (std::size_t k = 0; k < flat; ++k) {
            Lane(by_p_[k]).store(Lq[k]);
            (-Lane(by_q_[k])).store(Lp[k]);
        }
        for (std::size_t r = 0; r < Space::rotations; ++r) {
            const ChartPoint<Lane>& point = points[r];
            const Vector3<Lane> D = part(by_q_, r);
            const Vector3<Lane> w = point.T_inverse(part(by_p_, r));
            set_part(Lq, r, w);
            set_part(Lp, r, point.gradient(part(momenta_, r), w) - point.T_transposed(D));
            set_part(torques_, r, point.turned(D));
        }
    }

    /// Sets the momenta to h b_i L_i, as slopes are kept.
    void weigh_momenta() {
        const Lane weights(hb);
        for (Row& row : momenta_) { (weights * Lane(row)).store(row); }
    }
    void begin_with_weighted(const Table& table) {
        const Lane weights(hb);
        for (Row& row : momenta_) { (Lane(row) / weights).store(row); }
        begin_with_slopes(table);
    }

    /// Sets Lq, Lp and torques from slopes, with charts that follow the angular velocities.
    void begin_with_slopes(const Table& table) {
        Rows w = by_p_, xi{};
        set_places(table, w, xi);
        for (int sweep = 0; sweep < sweeps_of_angles(stages); ++sweep) {
            for (std::size_t r = 0; r < Space::rotations; ++r) {
                set_part(w, r, nearly_T_inverse(part(xi, r), part(by_p_, r)));
            }
            set_places(table, w, xi);
        }
        set_slopes(points_at(xi));
    }
    /// Sets xi_i = sum_j m_ij w_j.
    static void set_places(const Table& table, const Rows& w, Rows& xi) {
        products_between<Lane, flat, dimension>(
            table.m, w, [](std::size_t) { return Lane(Scalar(0)); },
            [&](std::size_t k, const auto& ways) { store_from(k, ways, xi); });
    }

    [[nodiscard]] Scalar bend_of(std::size_t) const { return Scalar(0); }
    [[nodiscard]] Scalar bend_of(std::size_t k, const std::array<Scalar, stages>& bend) const {
        return sum_of_lanes(Lane(lane_row(bend)) * Lane(Lq[k]));
    }

    Rows x_{}, y_{};                    ///< (Q, xi) and (P, pi)
    Rows by_q_{}, by_p_{}, momenta_{};  ///< h b_i (dH/dq, D), h b_i (dH/dp, Omega); (P, L)
    Rows by_q_before_{}, by_p_before_{}, momenta_before_{};  ///< of the step before the last
    Rows torques_{};                                         ///< behind the coordinates
    Scalar weighed_ = 0;                                     ///< the step size of hb
    bool has_slopes_before_ = false;  ///< of a step of the same size, before the last one
};

}  // namespace hvi::detail

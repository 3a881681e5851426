// The stages of a step with rotations.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include <hvi/detail/coefficients/weights.hpp>
#include <hvi/detail/groups/chart.hpp>
#include <hvi/detail/groups/chart_memory.hpp>
#include <hvi/detail/groups/chart_space.hpp>
#include <hvi/detail/stages/curve.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// The discrete Hamiltonian (5.7) of Leok & Zhang in natural charts. The stages are those of (4.18)
/// for
///
///     H~(q, xi, p, pi; R_0) = H(q, R_0 exp(hat xi), p, T(xi)^-T pi),
///
/// see ChartPoint, between (q, 0, p, pi_0) and (q_1, xi_1, p_1, pi_1), where R_0 is the rotation at
/// the start of the step. The chart moves with it, so that H_d^+ depends on R_0 in two ways. With
/// D, the derivative of H by rotations of the body,
///
///     dexp_{xi_1}^-T pi_1 + h sum_i b_i exp(hat xi_i) D_i = L_0,     dexp_{-xi_1}^-T pi_1 = L_1,
///
/// These say together that the torques change R L, the angular momentum in space:
///
///     R_1 L_1 = R_0 L_0 - h sum_i b_i R_i D_i.
///
/// So pi_1 = T(xi_1)^T L_1 follows from the stages, and so does pi_i = pi_1 - sum_j m_ji Lp_j.
/// NOTE: beginning with pi_0 = L_0, as if the chart stayed, makes steps of the same order that are
/// not symplectic and do not conserve the momentum map.
///
/// Slopes are scaled as in Stages, with the three components of a rotation behind the coordinates:
/// Lq_i = h b_i dH~/d(p, pi) and Lp_i = -h b_i dH~/d(q, xi).
template <class Space, std::size_t stages>
class ChartStages : public ChartMemory<Space> {
public:
    using Of = Space;
    using Scalar = typename Space::Scalar;
    using Vector = typename Space::Vector;
    using Positions = typename Space::Positions;
    using Part = Vector3<Scalar>;
    using Point = ChartPoint<Scalar>;
    using Table = Scalar[stages][stages];

    static constexpr std::size_t count = stages;

    std::array<Vector, stages> Lq{}, Lp{};
    std::array<Scalar, stages> hb{};  ///< h b_i; see weigh()
    State<Vector> change;             ///< of the stage values in one sweep

    /// Prepares a step of size h from x. Precondition: h != 0.
    template <class At>
    [[nodiscard]] Status begin(const At& x, Scalar step_size) {
        const Status status = ChartMemory<Space>::begin(x, step_size);
        if constexpr (!Space::has_fixed_size) { fit_stages(); }
        return status;
    }

    /// Sets hb.
    void weigh(const Scalar (&b)[stages]) {
        if (this->h == weighed_) { return; }
        hb = weights_of_step(this->h, b);
        weighed_ = this->h;
    }

    // ---- starting values ----

    /// Slopes that a step leaves for extrapolation, all of them in the body, where they go on
    /// smoothly from chart to chart.
    struct StageSlopes {
        Vector by_q{}, by_p{};  ///< dH/dq and D, dH/dp and Omega
        Vector momentum{};      ///< p and L
    };

    /// Extrapolates the slopes of the last step, times `last`, or those of the last two. Returns
    /// false where there are none for steps of this size.
    [[nodiscard]] bool extrapolate(const Table& m, const Table& last) {
        if (!this->goes_on) { return false; }
        const auto old = slopes_;
        for (std::size_t i = 0; i < stages; ++i) {
            clear(slopes_[i]);
            add(slopes_[i], last[i], old, hb[i]);
        }
        begin_with_slopes(m);
        return true;
    }
    [[nodiscard]] bool extrapolate(const Table& m, const Table& last, const Table& before) {
        const bool has_both = this->goes_on && has_slopes_before_;
        has_slopes_before_ = this->goes_on;
        const auto old = slopes_;
        for (std::size_t i = 0; i < stages && has_both; ++i) {
            clear(slopes_[i]);
            add(slopes_[i], last[i], old, hb[i]);
            add(slopes_[i], before[i], slopes_before_, hb[i]);
        }
        slopes_before_ = old;
        if (has_both) { begin_with_slopes(m); }
        return has_both;
    }

    /// Sets slopes as at the start of the step, by gradient(q, p, dHdq, dHdp).
    template <class Gradient>
    void predict(const Table& m, Gradient gradient) {
        StageSlopes start;
        clear(start);
        start.momentum = this->at.p;
        gradient(this->at.q, this->at.p, start.by_q, start.by_p);
        slopes_.fill(start);
        begin_with_slopes(m);
    }

    /// Sets all slopes to zero: all stages are at the start of the step.
    void begin_without_slopes(const Table& m, const Table& mt) {
        Lq = {};
        Lp = {};
        torques_ = {};
        balance(turns());
        momenta(m, mt);
        positions(m);
    }

    /// Multiplies all slopes by a factor; see Sweeps.
    void nudge(const Scalar& factor) {
        for (auto* slopes : {&Lq, &Lp}) {
            for (Vector& each : *slopes) {
                for (std::size_t k = 0; k < each.size(); ++k) { each[k] = each[k] * factor; }
            }
        }
    }

    // ---- sweeps ----

    /// Points xi_1 = sum_i Lq_i, one for each rotation.
    using Turns = typename Space::template PerRotation<Point>;
    HVI_INLINE_IN_SPACE [[nodiscard]] Turns turns() const {
        Turns all = no_turns();
        for (std::size_t r = 0; r < Space::rotations; ++r) {
            Part xi{};
            for (std::size_t k = 0; k < 3; ++k) {
                xi[k] = sum_of(Lq, Space::coordinates + 3 * r + k);
            }
            all[r] = Point(xi);
        }
        return all;
    }

    /// Returns L_1 of rotation r, from the torques of the stages and xi_1.
    [[nodiscard]] Part momentum_at_end(std::size_t r, const Point& turn) const {
        Part spin = Space::part(this->at.p, r);
        for (std::size_t i = 0; i < stages; ++i) { spin = spin - torques_[i][r]; }
        return turn.turned_back(spin);
    }

    /// Sets pi_1 from the torques of the stages and xi_1.
    void balance(const Turns& turns) {
        for (std::size_t r = 0; r < Space::rotations; ++r) {
            Space::set_part(pi_end, r, turns[r].T_transposed(momentum_at_end(r, turns[r])));
        }
    }

    /// Sets P_i = p + (e_p + sum_j mt_ij Lp_j) and pi_i = pi_1 - sum_j m_ji Lp_j; mt_ij is 1 -
    /// m_ji.
    void momenta(const Table& m, const Table& mt) {
        Space::set_zero(change.p);
        for (std::size_t i = 0; i < stages; ++i) {
            for (std::size_t k = 0; k < Space::degrees_of_freedom; ++k) {
                const bool is_flat = k < Space::coordinates;
                Scalar sum = is_flat ? this->remainder.p[k] : Scalar(0);
                for (std::size_t j = 0; j < stages; ++j) {
                    sum += (is_flat ? mt[i][j] : -m[j][i]) * Lp[j][k];
                }
                const Scalar value = moved(is_flat ? this->at.p[k] : pi_end[k], sum);
                change.p[k] += abs(value - y_[i][k]);
                y_[i][k] = value;
            }
        }
    }

    /// Sets Q_i = q + (e_q + sum_j m_ij Lq_j) and xi_i = sum_j m_ij Lq_j, with all that depends on
    /// xi_i.
    void positions(const Table& m) {
        Space::set_zero(change.q);
        for (std::size_t i = 0; i < stages; ++i) {
            for (std::size_t k = 0; k < Space::degrees_of_freedom; ++k) {
                const bool is_flat = k < Space::coordinates;
                Scalar sum = is_flat ? this->remainder.q[k] : Scalar(0);
                for (std::size_t j = 0; j < stages; ++j) { sum += m[i][j] * Lq[j][k]; }
                const Scalar value = is_flat ? moved(this->at.q[k], sum) : sum;
                change.q[k] += abs(value - x_[i][k]);
                x_[i][k] = value;
            }
            set_place(i);
        }
    }

    /// Sets both slopes of all stages, by gradient(stage, q, p, dHdq, dHdp).
    template <class Gradient>
    void slopes(Gradient gradient) {
        for (std::size_t i = 0; i < stages; ++i) {
            gradient(i, position(i), slopes_[i].momentum, slopes_[i].by_q, slopes_[i].by_p);
            set_slopes(i);
        }
    }

    /// Return the size that the rounding of component k of the stages is compared with. For a
    /// rotation it covers all of its entries, and all of its angular momentum.
    [[nodiscard]] Scalar size_q(std::size_t k) const {
        const bool is_flat = k < Space::coordinates;
        const std::size_t first = Space::coordinates + 9 * ((k - Space::coordinates) / 3);
        Scalar sum = is_flat ? abs(this->at.q[k]) : Scalar(0);
        for (std::size_t l = first; l < first + 9 && !is_flat; ++l) {
            sum = larger(sum, abs(this->at.q[l]));
        }
        for (std::size_t i = 0; i < stages; ++i) { sum += abs(x_[i][k]) + abs(Lq[i][k]); }
        return sum;
    }
    [[nodiscard]] Scalar size_p(std::size_t k) const {
        const bool is_flat = k < Space::coordinates;
        const std::size_t first = is_flat ? k : k - (k - Space::coordinates) % 3;
        Scalar sum = 0;
        for (std::size_t l = first; l < first + (is_flat ? 1 : 3); ++l) {
            sum += abs(this->at.p[l]);
            for (std::size_t i = 0; i < stages; ++i) { sum += abs(y_[i][l]) + abs(Lp[i][l]); }
        }
        return sum;
    }

    // ---- the end ----

    /// Returns whether all stages, and the end, are in the chart: turned by less than 2 pi. NOTE:
    /// also true of NaN, which another status reports.
    [[nodiscard]] bool is_in_chart() const {
        constexpr double most = 39.4784176;  // 4 pi^2, a little less
        bool is_in = true;
        const auto look = [&](const Turns& points) {
            for (const Point& point : points) {
                is_in = is_in && !(point.square_of_angle() > Scalar(most));
            }
        };
        look(turns());
        for (const Turns& points : points_) { look(points); }
        return is_in;
    }

    /// Moves `at` to the end of the step.
    void advance() {
        for (std::size_t k = 0; k < Space::coordinates; ++k) {
            this->advance_flat(k, sum_of(Lq, k), sum_of(Lp, k));
        }
        const Turns turns = this->turns();
        for (std::size_t r = 0; r < Space::rotations; ++r) {
            Part torque{};
            for (std::size_t i = 0; i < stages; ++i) { torque = torque - torques_[i][r]; }
            this->advance_rotation(r, turns[r], times(Space::rotation(this->at.q, r), torque));
        }
    }

    // ---- the curve of the last step ----

    /// Returns the position at tau, in parts of the step; NaN where there is none. `bend` is the
    /// distance of the curve from its chord, for each slope.
    template <class... Bend>
    [[nodiscard]] Positions position(Scalar tau, const Bend&... bend) const {
        Positions q = Space::no_positions();
        if (!this->has_ended()) { return nowhere(std::move(q)); }
        for (std::size_t k = 0; k < Space::coordinates; ++k) {
            const Scalar to_end = (Scalar(1) - tau) * sum_of(Lq, k);
            const Scalar away = bend_of(k, bend...) - to_end;
            q[k] = this->at.q[k] + (this->remainder.q[k] + away);
        }
        for (std::size_t r = 0; r < Space::rotations; ++r) {
            Part xi{};
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t l = Space::coordinates + 3 * r + k;
                xi[k] = tau * sum_of(Lq, l) + bend_of(l, bend...);
            }
            Space::set_rotation(q, r, this->rotated_from_start(r, Point(xi)));
        }
        return q;
    }

    // ---- one stage, for Newton's method ----

    Vector pi_end{};  ///< pi_1 behind the coordinates, whose places are unused

    /// Returns the positions of stage i. NOTE: computed when asked for: where a gradient takes no
    /// rotations, or some rows of them, compilers leave out the rest.
    HVI_INLINE_IN_SPACE [[nodiscard]] Positions position(std::size_t i) const {
        Positions q = Space::no_positions();
        for (std::size_t k = 0; k < Space::coordinates; ++k) { q[k] = x_[i][k]; }
        for (std::size_t r = 0; r < Space::rotations; ++r) {
            Space::set_rotation(q, r, this->rotated(r, points_[i][r]));
        }
        return q;
    }
    [[nodiscard]] const StageSlopes& slopes_of_stage(std::size_t i) const { return slopes_[i]; }
    [[nodiscard]] const Point& point(std::size_t i, std::size_t r) const { return points_[i][r]; }
    [[nodiscard]] const Scalar& slope_q(std::size_t i, std::size_t k) const { return Lq[i][k]; }
    [[nodiscard]] const Scalar& slope_p(std::size_t i, std::size_t k) const { return Lp[i][k]; }
    void set_slope_q(std::size_t i, std::size_t k, const Scalar& value) { Lq[i][k] = value; }
    void set_slope_p(std::size_t i, std::size_t k, const Scalar& value) { Lp[i][k] = value; }

private:
    /// Makes room for the numbers of coordinates and rotations.
    void fit_stages() {
        if (points_[0].size() == Space::rotations && Lq[0].size() == Space::degrees_of_freedom) {
            return;
        }
        for (auto* vectors : {&Lq, &Lp, &x_, &y_}) {
            for (Vector& each : *vectors) { Space::set_zero(each); }
        }
        Space::set_zero(pi_end);
        for (Turns& points : points_) { points.resize(Space::rotations); }
        for (auto& torques : torques_) { torques.resize(Space::rotations); }
    }

    void clear(StageSlopes& slopes) const {
        for (Vector* each : {&slopes.by_q, &slopes.by_p, &slopes.momentum}) {
            Space::set_zero(*each);
        }
    }

    [[nodiscard]] Turns no_turns() const {
        if constexpr (Space::has_fixed_size) {
            return Turns{};
        } else {
            return Turns(Space::rotations);
        }
    }

    [[nodiscard]] Scalar bend_of(std::size_t) const { return Scalar(0); }
    [[nodiscard]] Scalar bend_of(std::size_t k, const std::array<Scalar, stages>& bend) const {
        Scalar sum = 0;
        for (std::size_t i = 0; i < stages; ++i) { sum += bend[i] * Lq[i][k]; }
        return sum;
    }

    [[nodiscard]] static Scalar sum_of(const std::array<Vector, stages>& slopes, std::size_t k) {
        Scalar sum = 0;
        for (const Vector& slope : slopes) { sum += slope[k]; }
        return sum;
    }

    /// Adds sum_j N_ij (h b_j) from_j / weight, where the weight is h b_i.
    void add(StageSlopes& to, const Scalar (&row)[stages],
             const std::array<StageSlopes, stages>& from, const Scalar& weight) const {
        for (std::size_t j = 0; j < stages; ++j) {
            const Scalar factor = row[j] * hb[j] / weight;
            for (std::size_t k = 0; k < Space::degrees_of_freedom; ++k) {
                to.by_q[k] += factor * from[j].by_q[k];
                to.by_p[k] += factor * from[j].by_p[k];
                to.momentum[k] += factor * from[j].momentum[k];
            }
        }
    }

    /// Sets Lq, Lp and torques from slopes, with charts that follow the angular velocities.
    void begin_with_slopes(const Table& m) {
        for (std::size_t r = 0; r < Space::rotations; ++r) {
            const auto angular_velocity = [&](std::size_t i) {
                return hb[i] * Space::part(slopes_[i].by_p, r);
            };
            std::array<Part, stages> w;
            for (std::size_t i = 0; i < stages; ++i) { w[i] = angular_velocity(i); }
            std::array<Part, stages> xi = places(m, w);
            for (int sweep = 0; sweep < sweeps_of_angles(stages); ++sweep) {
                for (std::size_t i = 0; i < stages; ++i) {
                    w[i] = nearly_T_inverse(xi[i], angular_velocity(i));
                }
                xi = places(m, w);
            }
            for (std::size_t i = 0; i < stages; ++i) { points_[i][r] = Point(xi[i]); }
        }
        for (std::size_t i = 0; i < stages; ++i) { set_slopes(i); }
    }
    /// Returns xi_i = sum_j m_ij w_j.
    [[nodiscard]] static std::array<Part, stages> places(const Table& m,
                                                         const std::array<Part, stages>& w) {
        std::array<Part, stages> xi{};
        for (std::size_t i = 0; i < stages; ++i) {
            for (std::size_t j = 0; j < stages; ++j) { xi[i] = xi[i] + m[i][j] * w[j]; }
        }
        return xi;
    }

    /// Sets the position and the momentum of a stage from x_ and y_.
    HVI_INLINE_IN_SPACE void set_place(std::size_t i) {
        for (std::size_t k = 0; k < Space::coordinates; ++k) { slopes_[i].momentum[k] = y_[i][k]; }
        for (std::size_t r = 0; r < Space::rotations; ++r) {
            points_[i][r] = Point(Space::part(x_[i], r));
            Space::set_part(slopes_[i].momentum, r,
                            points_[i][r].T_inverse_transposed(Space::part(y_[i], r)));
        }
    }

    HVI_INLINE_IN_SPACE void set_slopes(std::size_t i) {
        const StageSlopes& slope = slopes_[i];
        for (std::size_t k = 0; k < Space::coordinates; ++k) {
            Lq[i][k] = hb[i] * slope.by_p[k];
            Lp[i][k] = -hb[i] * slope.by_q[k];
        }
        for (std::size_t r = 0; r < Space::rotations; ++r) {
            const Point& point = points_[i][r];
            const Part D = Space::part(slope.by_q, r);
            const Part w = point.T_inverse(Space::part(slope.by_p, r));
            const Part g =
                point.T_transposed(D) - point.gradient(Space::part(slope.momentum, r), w);
            Space::set_part(Lq[i], r, hb[i] * w);
            Space::set_part(Lp[i], r, -hb[i] * g);
            torques_[i][r] = hb[i] * point.turned(D);
        }
    }

    std::array<Vector, stages> x_{}, y_{};  ///< (Q, xi) and (P, pi)
    std::array<StageSlopes, stages> slopes_{}, slopes_before_{};
    std::array<Turns, stages> points_{};
    std::array<typename Space::template PerRotation<Part>, stages> torques_{};
    Scalar weighed_ = 0;              ///< the step size of hb
    bool has_slopes_before_ = false;  ///< of a step of the same size, before the last one
};

}  // namespace hvi::detail

// The stages of implicit steppers, of trajectories side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/coefficients/weights.hpp>
#include <hvi/detail/lanes/lane_pairs.hpp>
#include <hvi/detail/stages/free_path.hpp>
#include <hvi/detail/stages/moved.hpp>
#include <hvi/detail/trajectories/lane_sweeps.hpp>
#include <hvi/detail/trajectories/trajectories.hpp>
#include <hvi/detail/trajectories/trajectory_factors.hpp>
#include <hvi/detail/trajectories/trajectory_sums.hpp>

namespace hvi::detail {

/// Common part of both forms of stages: the start of the step, and the memory of the last one.
///
/// Slopes, as starting values for the next step, belong to the state in which the step ended:
/// begin() drops those of a lane unless it is given exactly these bits. Remainders are part of the
/// state.
template <class Vector, std::size_t stages, class One>
struct TrajectoryMemory {
    using State = Trajectories<Vector, RemaindersCarried, One>;
    using Scalar = ScalarOf<Vector>;
    using Lane = typename State::Lane;
    using Mask = typename State::Mask;
    using Row = typename Lane::Row;
    using Rows = typename State::Rows;
    using Values = typename State::Values;
    using Slopes = std::array<Rows, stages>;
    static constexpr std::size_t dimension = fixed_size<Vector>();

    Rows q{}, p{};  ///< start of the step
    Rows remainder_q{}, remainder_p{};
    TrajectoryClock<One> clock;
    Rows change_q{}, change_p{};   ///< of the stage values in one sweep, over stages
    Row h{};                       ///< step sizes
    std::array<Row, stages> hb{};  ///< h b_j
    bool some_go_on = false;       ///< whether lanes have slopes of the step before
    bool some_begin = false;       ///< whether lanes have none

    /// Gives a lane another step size.
    void resize(std::size_t lane, Scalar step_size, const Scalar (&b)[stages]) {
        h.set(lane, step_size);
        const std::array<Scalar, stages> weights = weights_of_step(step_size, b);
        for (std::size_t j = 0; j < stages; ++j) { hb[j].set(lane, weights[j]); }
        forget(lane);
    }

    /// Prepares a step from x. Returns whether it has something to do.
    [[nodiscard]] bool begin(State& x) {
        if (!sums_.begin(x, h)) { return false; }
        forget_what_changed(x);
        some_begin = any(new_lanes() & x.going());
        some_go_on = any(!new_lanes() & x.going());
        q = x.q;
        p = x.p;
        clock = x.clock;
        remainder_q = x.carried.q;
        remainder_p = x.carried.p;
        return true;
    }

    /// End of a step, and its remainders.
    struct Ending {
        Values q, p, remainder_q, remainder_p;
    };

    /// Returns the start of the step as an Ending.
    [[nodiscard]] Ending beginning() const {
        Ending at;
        for (std::size_t k = 0; k < dimension; ++k) {
            at.q[k] = Lane(q[k]);
            at.p[k] = Lane(p[k]);
            at.remainder_q[k] = Lane(remainder_q[k]);
            at.remainder_p[k] = Lane(remainder_p[k]);
        }
        return at;
    }

    /// Ends the step of x at `at`.
    template <class Outcome>
    [[nodiscard]] const LaneStatus& end(State& x, const Outcome& outcome, const Ending& at) {
        x.count(outcome.iterations);
        if (!all(outcome.converged)) {
            x.stop(outcome.not_finite, Status::Code::not_finite);
            x.stop(!outcome.converged, Status::Code::not_converged);
        }
        sums_.end_at(x, at.q, at.p, at.remainder_q, at.remainder_p, [](auto) {});
        ended_q_ = x.q;
        ended_p_ = x.p;
        ended_clock_ = x.clock;
        Lane(Scalar(1)).store(known_);
        return x.status();
    }

    /// Returns the lanes that have no slopes of the step before.
    [[nodiscard]] Mask new_lanes() const { return Lane(known_) == Lane(Scalar(0)); }

    /// Forget what the last step left in a lane, or in all of them.
    void forget(std::size_t lane) { known_.set(lane, 0); }
    void forget() {
        known_ = {};
        sums_.forget();
    }

protected:
    /// Returns start + sum_j row_j x_j, in two sums, as a processor adds several times faster than
    /// it waits for one sum.
    [[nodiscard]] static Lane sum(const Scalar (&row)[stages], const Slopes& x, std::size_t k,
                                  Lane start) {
        start = start + row[0] * Lane(x[0][k]);
        if constexpr (stages > 1) {
            Lane other = row[1] * Lane(x[1][k]);
            for (std::size_t j = 2; j + 1 < stages; j += 2) {
                start = start + row[j] * Lane(x[j][k]);
                other = other + row[j + 1] * Lane(x[j + 1][k]);
            }
            if constexpr (stages % 2 == 1) {
                start = start + row[stages - 1] * Lane(x[stages - 1][k]);
            }
            start = start + other;
        }
        return start;
    }

    static void extrapolate(Slopes& slopes, const Scalar (&N)[stages][stages]) {
        const Slopes before = slopes;
        for (std::size_t i = 0; i < stages; ++i) {
            for (std::size_t k = 0; k < dimension; ++k) {
                sum(N[i], before, k, Lane(Scalar(0))).store(slopes[i][k]);
            }
        }
    }

    /// Sets slopes to values in these lanes.
    static void keep(const Mask& lanes, bool are_all, const Values& values, Rows& slopes) {
        if (are_all) {
            store(values, slopes);
        } else {
            State::keep(lanes, values, slopes);
        }
    }

private:
    /// Forgets the slopes of lanes whose state is not that in which the last step ended.
    void forget_what_changed(const State& x) {
        if (same_rows(ended_q_, x.q) && same_rows(ended_p_, x.p) &&
            ended_clock_.shows_time_of(x.clock)) {
            return;
        }
        for (std::size_t lane = 0; lane < trajectories_at_once; ++lane) {
            const bool is_same = same_lane(ended_q_, x.q, lane) && same_lane(ended_p_, x.p, lane) &&
                                 ended_clock_.shows_time_of(x.clock, lane);
            if (!is_same) { forget(lane); }
        }
    }

    [[nodiscard]] static bool same_rows(const Rows& a, const Rows& b) {
        for (std::size_t k = 0; k < dimension; ++k) {
            if (!same_bits(a[k], b[k])) { return false; }
        }
        return true;
    }

    [[nodiscard]] static bool same_lane(const Rows& a, const Rows& b, std::size_t lane) {
        return same_bits(lane_of<Vector>(a, lane), lane_of<Vector>(b, lane));
    }

    Rows ended_q_{}, ended_p_{};
    TrajectoryClock<One> ended_clock_;
    Row known_{};  ///< 1 where a step ended there, with its slopes
    TrajectorySums<State> sums_;
};

/// Stages of positions alone; see VelocityStages.
template <class Vector, std::size_t stages, class One = hvi::State<Vector>>
struct VelocityTrajectories : TrajectoryMemory<Vector, stages, One> {
    using Base = TrajectoryMemory<Vector, stages, One>;
    using Base::dimension;
    using typename Base::Lane;
    using typename Base::Mask;
    using typename Base::Rows;
    using typename Base::Scalar;
    using typename Base::Slopes;
    using typename Base::Values;

    Slopes Q{}, Lp{}, W{};
    Slopes drifted{};                  ///< e_q + c_i w
    Rows free_path{}, rest_of_path{};  ///< w is the sum of both; see VelocityStages

    /// Sets w and `drifted` for stages at the times c.
    template <class System>
    void drift_freely(const System& system, const Scalar (&c)[stages]) {
        factors_.set(system, this->h);
        scale_momenta(system);
        for (std::size_t i = 0; i < stages; ++i) {
            for (std::size_t k = 0; k < dimension; ++k) {
                ((Lane(this->remainder_q[k]) + c[i] * Lane(rest_of_path[k])) +
                 c[i] * Lane(free_path[k]))
                    .store(drifted[i][k]);
            }
        }
    }

    /// Gives a lane another step size.
    void resize(std::size_t lane, Scalar step_size, const Scalar (&b)[stages]) {
        Base::resize(lane, step_size, b);
        factors_.forget();
    }

    /// Forget what depends on the last step, or on the parameters, of a lane or of all.
    void forget(std::size_t lane) {
        Base::forget(lane);
        factors_.forget();
    }
    void forget() {
        Base::forget();
        factors_.forget();
    }

    /// Sets starting values in these lanes: forces as at the start of the step.
    template <class System>
    void predict(const System& system, const Mask& lanes) {
        predict(system, lanes, [&](Values& out) { system.dHdq(load(this->q), out); });
    }

    /// Sets starting values in these lanes: forces by `dHdq(out)` at the start of the step.
    template <class System, class Gradient>
    void predict(const System& system, const Mask& lanes, Gradient dHdq) {
        const bool are_all = all(lanes);
        Values slope;
        dHdq(slope);
        for (std::size_t i = 0; i < stages; ++i) { push(system, i, slope, lanes, are_all); }
    }

    /// Sets starting values from those of the last step.
    void extrapolate(const Scalar (&N)[stages][stages]) { Base::extrapolate(W, N); }

    /// Sets Q_i = q + (e_q + c_i w + sum_j n_ij W_j).
    void positions(const Scalar (&n)[stages][stages]) {
        for (std::size_t k = 0; k < dimension; ++k) {
            const Lane from(this->q[k]);
            Lane change(Scalar(0));
            for (std::size_t i = 0; i < stages; ++i) {
                const Lane place = moved(from, Base::sum(n[i], W, k, Lane(drifted[i][k])));
                change = change + abs(place - Lane(Q[i][k]));
                place.store(Q[i][k]);
            }
            change.store(this->change_q[k]);
        }
    }

    /// Sets Lp_i = -h b_i dH/dq, W_i = h K Lp_i, in these lanes.
    template <class System>
    void forces(const System& system, const Mask& lanes) {
        forces(system, lanes, [&](std::size_t i, Values& out) { system.dHdq(load(Q[i]), out); });
    }

    /// Sets Lp_i and W_i in these lanes by `dHdq(i, out)`.
    template <class System, class Gradient>
    void forces(const System& system, const Mask& lanes, Gradient dHdq) {
        const bool are_all = all(lanes);
        for (std::size_t i = 0; i < stages; ++i) {
            Values slope;
            dHdq(i, slope);
            push(system, i, slope, lanes, are_all);
        }
    }

    /// Advances x: q by w + sum_j (1 - c_j) W_j, and w by sum_j W_j.
    template <class System, class Outcome>
    [[nodiscard]] const LaneStatus& advance(const System&, typename Base::State& x,
                                            const Outcome& outcome, const Scalar (&c)[stages]) {
        typename Base::Ending at = this->beginning();
        for (std::size_t k = 0; k < dimension; ++k) {
            Lane near(rest_of_path[k]);
            for (std::size_t j = 0; j < stages; ++j) { near = near + (1 - c[j]) * Lane(W[j][k]); }
            move_far<Lane>(at.q[k], at.remainder_q[k], Lane(free_path[k]), near);
            move_by_kick<Lane>(at.p[k], at.remainder_p[k], change_of_p<System>(k));
        }
        return this->end(x, outcome, at);
    }

    /// Returns the size that the rounding of component k of Q is compared with; see VelocityLanes.
    [[nodiscard]] Lane size_q(std::size_t k) const {
        Lane size = abs(Lane(this->q[k])) + abs(Lane(free_path[k]));
        for (std::size_t i = 0; i < stages; ++i) {
            size = size + (abs(Lane(Q[i][k])) + abs(Lane(W[i][k])));
        }
        return size;
    }

private:
    template <class System>
    void push(const System& system, std::size_t i, const Values& slope, const Mask& lanes,
              bool are_all) {
        Values force, scaled, path;
        for (std::size_t k = 0; k < dimension; ++k) {
            force[k] = -Lane(this->hb[i]) * slope[k];
            scaled[k] = factors_[k] * force[k];
        }
        if constexpr (System::has_diagonal_mass) {
            path = scaled;
        } else {
            system.inverse_mass(scaled, path);
        }
        this->keep(lanes, are_all, force, Lp[i]);
        this->keep(lanes, are_all, path, W[i]);
    }

    template <class System>
    void scale_momenta(const System& system) {
        Values path, rest;
        for (std::size_t k = 0; k < dimension; ++k) {
            const Lane offset = System::has_diagonal_mass ? factors_.offset(k) : Lane(Scalar(0));
            const Pair<Lane> w =
                scaled_momentum<Lane>(factors_[k], this->p[k], this->remainder_p[k], offset);
            path[k] = w.hi;
            rest[k] = w.lo;
        }
        if constexpr (!System::has_diagonal_mass) {
            const Values scaled = path, scaled_rest = rest;
            system.inverse_mass(scaled, path);
            system.inverse_mass(scaled_rest, rest);
            for (std::size_t k = 0; k < dimension; ++k) { rest[k] = rest[k] + factors_.offset(k); }
        }
        store(path, free_path);
        store(rest, rest_of_path);
    }

    /// Returns the change of component k of p by the forces of the step; see PathFactors.
    template <class System>
    [[nodiscard]] Pair<Lane> change_of_p(std::size_t k) const {
        const auto kick = [&](std::size_t j) {
            if constexpr (System::has_diagonal_mass) {
                return Lane(W[j][k]);
            } else {
                return opaque(factors_[k] * Lane(Lp[j][k]));
            }
        };
        const Pair<Lane> change =
            momentum_of(exact_sum<Lane, stages>(kick), factors_[k], factors_.inverse(k));
        const Mask zeros = factors_.zeros(k);
        if (!any(zeros)) { return change; }
        const Pair<Lane> force =
            exact_sum<Lane, stages>([&](std::size_t j) { return Lane(Lp[j][k]); });
        return {select(zeros, force.hi, change.hi), select(zeros, force.lo, change.lo)};
    }

    TrajectoryFactors<Vector> factors_;
};

/// Stages of positions and momenta; see Stages.
template <class Vector, std::size_t stages, class One = hvi::State<Vector>>
struct PairTrajectories : TrajectoryMemory<Vector, stages, One> {
    using Base = TrajectoryMemory<Vector, stages, One>;
    using Base::dimension;
    using typename Base::Lane;
    using typename Base::Mask;
    using typename Base::Rows;
    using typename Base::Scalar;
    using typename Base::Slopes;
    using typename Base::Values;

    Slopes Q{}, P{}, Lq{}, Lp{};

    /// Set starting values in these lanes: slopes as at the start of the step.
    void predict_q(const Mask& lanes, const Values& gradient) {
        for (std::size_t i = 0; i < stages; ++i) { set(lanes, Lane(this->hb[i]), gradient, Lq[i]); }
    }
    void predict_p(const Mask& lanes, const Values& gradient) {
        for (std::size_t i = 0; i < stages; ++i) {
            set(lanes, -Lane(this->hb[i]), gradient, Lp[i]);
        }
    }

    /// Set starting values from those of the last step.
    void extrapolate_q(const Scalar (&N)[stages][stages]) { Base::extrapolate(Lq, N); }
    void extrapolate_p(const Scalar (&N)[stages][stages]) { Base::extrapolate(Lp, N); }

    /// Sets Q_i = q + (e_q + sum_j m_ij Lq_j).
    void positions(const Scalar (&m)[stages][stages]) {
        stage_values(m, Lq, this->q, this->remainder_q, Q, this->change_q);
    }

    /// Sets P_j = p + (e_p + sum_i mt_ji Lp_i).
    void momenta(const Scalar (&mt)[stages][stages]) {
        stage_values(mt, Lp, this->p, this->remainder_p, P, this->change_p);
    }

    /// Sets Lq_j = h b_j dH/dp in these lanes, by `dHdp(j, out)`.
    template <class Gradient>
    void velocities(const Mask& lanes, Gradient dHdp) {
        const bool are_all = all(lanes);
        for (std::size_t j = 0; j < stages; ++j) {
            slope(lanes, are_all, dHdp, j, Lane(this->hb[j]), Lq);
        }
    }

    /// Sets Lp_i = -h b_i dH/dq in these lanes, by `dHdq(i, out)`.
    template <class Gradient>
    void forces(const Mask& lanes, Gradient dHdq) {
        const bool are_all = all(lanes);
        for (std::size_t i = 0; i < stages; ++i) {
            slope(lanes, are_all, dHdq, i, -Lane(this->hb[i]), Lp);
        }
    }

    /// Sets both slopes in these lanes, by `gradient(i, dHdq, dHdp)`.
    template <class Gradient>
    void slopes(const Mask& lanes, Gradient gradient) {
        const bool are_all = all(lanes);
        for (std::size_t i = 0; i < stages; ++i) {
            Values dHdq, dHdp;
            gradient(i, dHdq, dHdp);
            keep_scaled(lanes, are_all, -Lane(this->hb[i]), dHdq, Lp[i]);
            keep_scaled(lanes, are_all, Lane(this->hb[i]), dHdp, Lq[i]);
        }
    }

    /// Advances x: q by sum_j Lq_j, p by sum_i Lp_i.
    template <class Outcome>
    [[nodiscard]] const LaneStatus& advance(typename Base::State& x, const Outcome& outcome) {
        typename Base::Ending at = this->beginning();
        for (std::size_t k = 0; k < dimension; ++k) {
            Lane sum_q(Lq[0][k]);
            Lane sum_p(Lp[0][k]);
            for (std::size_t j = 1; j < stages; ++j) {
                sum_q = sum_q + Lane(Lq[j][k]);
                sum_p = sum_p + Lane(Lp[j][k]);
            }
            move<Lane>(at.q[k], at.remainder_q[k], sum_q);
            move<Lane>(at.p[k], at.remainder_p[k], sum_p);
        }
        return this->end(x, outcome, at);
    }

    /// Return the size that the rounding of component k of Q, and of P, is compared with.
    [[nodiscard]] Lane size_q(std::size_t k) const { return size(this->q, Q, Lq, k); }
    [[nodiscard]] Lane size_p(std::size_t k) const { return size(this->p, P, Lp, k); }

private:
    static void set(const Mask& lanes, const Lane& factor, Values gradient, Rows& slope) {
        keep_scaled(lanes, all(lanes), factor, gradient, slope);
    }

    template <class Gradient>
    static void slope(const Mask& lanes, bool are_all, Gradient gradient, std::size_t i,
                      const Lane& factor, Slopes& slopes) {
        Values out;
        gradient(i, out);
        keep_scaled(lanes, are_all, factor, out, slopes[i]);
    }

    static void keep_scaled(const Mask& lanes, bool are_all, const Lane& factor, Values& gradient,
                            Rows& slope) {
        for (Lane& component : gradient) { component = factor * component; }
        Base::keep(lanes, are_all, gradient, slope);
    }

    static void stage_values(const Scalar (&m)[stages][stages], const Slopes& slopes,
                             const Rows& start, const Rows& cut_off, Slopes& values,
                             Rows& changes) {
        for (std::size_t k = 0; k < dimension; ++k) {
            const Lane from(start[k]);
            Lane change(Scalar(0));
            for (std::size_t i = 0; i < stages; ++i) {
                const Lane value = moved(from, Base::sum(m[i], slopes, k, Lane(cut_off[k])));
                change = change + abs(value - Lane(values[i][k]));
                value.store(values[i][k]);
            }
            change.store(changes[k]);
        }
    }

    [[nodiscard]] static Lane size(const Rows& start, const Slopes& values, const Slopes& slopes,
                                   std::size_t k) {
        Lane size = abs(Lane(start[k]));
        for (std::size_t i = 0; i < stages; ++i) {
            size = size + (abs(Lane(values[i][k])) + abs(Lane(slopes[i][k])));
        }
        return size;
    }
};

}  // namespace hvi::detail

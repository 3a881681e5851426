// Trajectories side by side: the state that a stepper of ensembles advances.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/lanes/lane_math.hpp>
#include <hvi/detail/lanes/lane_tables.hpp>
#include <hvi/detail/lanes/lanes.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/detail/trajectories/trajectory_clock.hpp>
#include <hvi/state.hpp>

namespace hvi {

/// Statuses of a step, one for each trajectory.
class [[nodiscard]] LaneStatus {
public:
    [[nodiscard]] const Status& operator[](std::size_t lane) const { return lanes_[lane]; }

    /// Returns whether all went well.
    [[nodiscard]] bool ok() const { return ok_; }

    void set(std::size_t lane, Status status) {
        lanes_[lane] = status;
        ok_ = true;
        for (const Status& each : lanes_) { ok_ = ok_ && each.ok(); }
    }

    void count(std::size_t lane, int iterations) { lanes_[lane].iterations = iterations; }

private:
    std::array<Status, trajectories_at_once> lanes_{};
    bool ok_ = true;
};

namespace detail {

// ---- memory of steps for the next, beside (q, p) ----

/// A number for each trajectory.
template <class Number>
using TrajectoryRow = LaneRow<Number, trajectories_at_once>;

template <class Vector>
using TrajectoryRows = LaneRows<ScalarOf<Vector>, trajectories_at_once, fixed_size<Vector>()>;
template <class Vector>
using TrajectoryValues = LaneVector<ScalarOf<Vector>, trajectories_at_once, fixed_size<Vector>()>;

/// Types of the vectors q and p of states, and states as such vectors. Those that turn bodies have
/// another form; see trajectory_bodies.hpp.
template <class Vector>
struct TrajectoryForm {
    using Positions = Vector;
    using Momenta = Vector;

    template <class One>
    [[nodiscard]] static const One& flat(const One& x) {
        return x;
    }
    template <class One>
    static void set(One& x, const One& at) {
        x = at;
    }
};

template <class Vector>
using PositionRows = TrajectoryRows<typename TrajectoryForm<Vector>::Positions>;
template <class Vector>
using MomentumRows = TrajectoryRows<typename TrajectoryForm<Vector>::Momenta>;

/// Copies a lane of other rows to a lane of these.
template <class Rows>
void take_lane(Rows& rows, std::size_t lane, const Rows& other, std::size_t from) {
    for (std::size_t k = 0; k < rows.size(); ++k) { rows[k].set(lane, other[k][from]); }
}

/// Empty memory.
template <class Vector>
struct NothingCarried {
    void begin_anew(std::size_t) {}
    void take(std::size_t, const NothingCarried&, std::size_t) {}
};

/// The last slope of a step, which is the first of the next.
template <class Vector>
struct SlopeCarried {
    using Row = TrajectoryRow<ScalarOf<Vector>>;
    using Lane = Lanes<ScalarOf<Vector>, trajectories_at_once>;

    TrajectoryRows<Vector> slope{};
    bool are_known = false;  ///< the slopes of all lanes

    void begin_anew(std::size_t lane) {
        known_.set(lane, 0);
        are_known = false;
    }

    void take(std::size_t lane, const SlopeCarried& other, std::size_t from) {
        take_lane(slope, lane, other.slope, from);
        known_.set(lane, other.known_[from]);
        are_known = are_known && known_[lane] != 0;
    }

    /// Sets `kept` to `fresh` in the lanes whose slope is not known.
    template <class Values>
    void fill(const Values& fresh, Values& kept) const {
        const auto known = Lane(ScalarOf<Vector>(0)) < Lane(known_);
        for (std::size_t k = 0; k < kept.size(); ++k) {
            kept[k] = select(known, kept[k], fresh[k]);
        }
    }

    /// Takes note that the slopes of all lanes are those of a step.
    void know() {
        if (are_known) { return; }
        Lane(ScalarOf<Vector>(1)).store(known_);
        are_known = true;
    }

private:
    Row known_{};  ///< 1 where the slope is known
};

/// Remainders of q and of p.
template <class Vector>
struct RemaindersCarried {
    PositionRows<Vector> q{};
    MomentumRows<Vector> p{};

    void begin_anew(std::size_t lane) {
        for (auto& row : q) { row.set(lane, 0); }
        for (auto& row : p) { row.set(lane, 0); }
    }

    void take(std::size_t lane, const RemaindersCarried& other, std::size_t from) {
        take_lane(q, lane, other.q, from);
        take_lane(p, lane, other.p, from);
    }
};

/// Remainders, and the last slope.
template <class Vector>
struct RemaindersAndSlopeCarried : RemaindersCarried<Vector>, SlopeCarried<Vector> {
    void begin_anew(std::size_t lane) {
        RemaindersCarried<Vector>::begin_anew(lane);
        SlopeCarried<Vector>::begin_anew(lane);
    }

    void take(std::size_t lane, const RemaindersAndSlopeCarried& other, std::size_t from) {
        RemaindersCarried<Vector>::take(lane, other, from);
        SlopeCarried<Vector>::take(lane, other, from);
    }
};

/// Returns 0 in the lanes in which all components of x are finite. NOTE: x - x is 0, or NaN.
template <class Lane, std::size_t dimension>
[[nodiscard]] Lane zero_where_finite(const std::array<Lane, dimension>& x) {
    Lane sum = x[0] - x[0];
    for (std::size_t k = 1; k < dimension; ++k) { sum = sum + (x[k] - x[k]); }
    return sum;
}

/// Returns the lanes in which all components of x and y are finite.
template <class Lane, std::size_t of_x, std::size_t of_y>
[[nodiscard]] auto where_finite(const std::array<Lane, of_x>& x, const std::array<Lane, of_y>& y) {
    return zero_where_finite(x) + zero_where_finite(y) == Lane(ScalarOf<typename Lane::Row>(0));
}

}  // namespace detail

/// Eight trajectories, with q, p and, if each `One` has it, the time: a row of lanes for each
/// component. A trajectory whose step failed has stopped: it keeps the state before that step, and
/// is not advanced any more.
template <class Vector, template <class> class Carried, class One = State<Vector>>
class Trajectories {
public:
    using Form = detail::TrajectoryForm<Vector>;
    using Positions = typename Form::Positions;
    using Momenta = typename Form::Momenta;
    using Scalar = detail::ScalarOf<Momenta>;
    using Lane = Lanes<Scalar, trajectories_at_once>;
    using Mask = typename Lane::Mask;
    using Rows = detail::TrajectoryRows<Momenta>;
    using Values = detail::TrajectoryValues<Momenta>;
    using PositionValues = detail::TrajectoryValues<Positions>;

    detail::TrajectoryRows<Positions> q{};
    Rows p{};
    detail::TrajectoryClock<One> clock;
    Carried<Vector> carried;

    /// Puts x into all eight lanes.
    explicit Trajectories(const One& x = {}) {
        for (std::size_t lane = 0; lane < trajectories_at_once; ++lane) { set(lane, x); }
    }

    /// Puts another trajectory into a lane.
    void set(std::size_t lane, const One& x) {
        const auto& from = Form::flat(x);
        for (std::size_t k = 0; k < q.size(); ++k) { q[k].set(lane, detail::at(from.q, k)); }
        for (std::size_t k = 0; k < p.size(); ++k) { p[k].set(lane, detail::at(from.p, k)); }
        clock.set(lane, x);
        carried.begin_anew(lane);
        going_.set(lane, 1);
        status_.set(lane, Status());
    }

    /// Copies a trajectory with all that it carries from a lane of others.
    void take(std::size_t lane, const Trajectories& other, std::size_t from) {
        detail::take_lane(q, lane, other.q, from);
        detail::take_lane(p, lane, other.p, from);
        clock.take(lane, other.clock, from);
        carried.take(lane, other.carried, from);
        going_.set(lane, other.going_[from]);
        status_.set(lane, other.status_[from]);
    }

    /// Empties a lane: steps of others do not look at it any more.
    void rest(std::size_t lane) {
        going_.set(lane, 0);
        status_.set(lane, Status());
    }

    [[nodiscard]] One operator[](std::size_t lane) const {
        One x;
        auto at = Form::flat(x);
        at.q = detail::lane_of<Positions>(q, lane);
        at.p = detail::lane_of<Momenta>(p, lane);
        Form::set(x, at);
        clock.get(lane, x);
        return x;
    }

    // ---- for steppers ----

    /// Returns the statuses of the last step.
    [[nodiscard]] const LaneStatus& status() const { return status_; }

    /// Returns the lanes that have not stopped.
    [[nodiscard]] Mask going() const { return Lane(Scalar(0)) < Lane(going_); }

    /// Returns whether a step has something to do; h is its size in each lane.
    [[nodiscard]] bool begins(const typename Lane::Row& h) {
        clock.begin(h);
        return status_.ok() || any(going());
    }

    /// Ends a step. The lanes of `made` that have not stopped move to (new_q, new_p), and their
    /// time by the size of the step. The others stop. `carry(put)` moves the memory likewise, by
    /// calls of put(values, rows).
    ///
    /// NOTE: both choices of a mask were computed before, once, in all lanes. Were they computed in
    /// two places, for all lanes and for some, a compiler might fuse products and sums in one place
    /// alone, and a trajectory would depend on its neighbours.
    template <class Carry>
    void end(const PositionValues& new_q, const Values& new_p, const Mask& made, Carry carry) {
        const auto time = clock.end();
        const Mask finite = time.finite(made);
        const auto move = [&](auto put) {
            put(new_q, q);
            put(new_p, p);
            time.move(clock, put);
            carry(put);
        };
        if (status_.ok() && all(finite)) {
            move([](const auto& values, auto& rows) { detail::store(values, rows); });
            return;
        }
        const Mask advanced = finite & going();
        move([&](const auto& values, auto& rows) { keep(advanced, values, rows); });
        stop(!advanced, Status::Code::not_finite);
    }

    /// Ends a step that leaves no memory for the next.
    void end(const PositionValues& new_q, const Values& new_p, const Mask& made) {
        end(new_q, new_p, made, [](auto) {});
    }

    /// Stops these lanes, where they have not stopped before.
    void stop(const Mask& lanes, Status::Code code) {
        const Mask stopping = lanes & going();
        typename Lane::Row now;
        select(stopping, Lane(Scalar(1)), Lane(Scalar(0))).store(now);
        for (std::size_t lane = 0; lane < trajectories_at_once; ++lane) {
            if (now[lane] == 0) { continue; }
            status_.set(lane, Status(code, status_[lane].iterations));
            going_.set(lane, 0);
        }
    }

    /// Sets the numbers of iterations of the stages, in the lanes that have not stopped.
    void count(const Lane& iterations) {
        typename Lane::Row row;
        iterations.store(row);
        for (std::size_t lane = 0; lane < trajectories_at_once; ++lane) {
            if (status_[lane].ok()) { status_.count(lane, static_cast<int>(row[lane])); }
        }
    }

    /// Sets rows to values in these lanes.
    template <std::size_t dimension>
    static void keep(const Mask& lanes, const std::array<Lane, dimension>& values,
                     std::array<typename Lane::Row, dimension>& rows) {
        for (std::size_t k = 0; k < rows.size(); ++k) { keep(lanes, values[k], rows[k]); }
    }
    static void keep(const Mask& lanes, const Lane& values, typename Lane::Row& row) {
        select(lanes, values, Lane(row)).store(row);
    }

private:
    typename Lane::Row going_{};  ///< 1, or 0 where a lane has stopped
    LaneStatus status_;
};

}  // namespace hvi

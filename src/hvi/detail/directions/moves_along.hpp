// Directions that the kicks and drifts of an explicit step carry along.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <hvi/detail/directions/cells.hpp>
#include <hvi/detail/directions/direction_state.hpp>
#include <hvi/detail/directions/groups.hpp>

namespace hvi::detail {

/// The number of no point; see KeptOfPoint.
inline constexpr std::uint64_t nowhere = 0;

/// Directions that are moved side by side, and their slopes where these were evaluated last.
template <class Cells, std::size_t dimension>
class MovedDirections {
public:
    using Scalar = ScalarOf<typename Cells::Row>;
    static constexpr std::size_t width = Cells::directions;

    template <class Iterator>
    void take(Iterator directions, std::size_t count) {
        if (!state_.take(directions, count)) { forget(); }
    }
    template <class Iterator>
    void give(Iterator directions, std::size_t count) {
        state_.give(directions, count);
    }

    /// dp -= hb d2H/dq2 dq.
    template <class System, class Kept>
    void kick(const System& system, const Kept& kept, const Scalar& hb) {
        if (force_at_ != kept.number()) {
            Values out;
            system.along_q(kept.values(), values(state_.q), out);
            store(out, force_);
            force_at_ = kept.number();
        }
        for (std::size_t k = 0; k < dimension; ++k) {
            Cells::store(Number(state_.p[k]) - hb * Number(force_[k]), state_.p[k]);
        }
        velocity_at_ = nowhere;
    }

    /// dq += hb d2H/dp2 dp.
    template <class System, class Kept>
    void drift(const System& system, const Kept& kept, const Scalar& hb) {
        if (velocity_at_ != kept.number()) {
            Values out;
            system.along_p(kept.values(), values(state_.p), out);
            store(out, velocity_);
            velocity_at_ = kept.number();
        }
        for (std::size_t k = 0; k < dimension; ++k) {
            Cells::store(Number(state_.q[k]) + hb * Number(velocity_[k]), state_.q[k]);
        }
        force_at_ = nowhere;
    }

    [[nodiscard]] bool is_finite() const { return state_.is_finite(); }
    void forget() { force_at_ = velocity_at_ = nowhere; }

private:
    using Number = typename Cells::Number;
    using Values = std::array<Number, dimension>;
    using Vector = typename DirectionState<Cells, dimension>::Vector;

    [[nodiscard]] static Values values(const Vector& x) {
        Values result;
        for (std::size_t k = 0; k < dimension; ++k) { result[k] = Number(x[k]); }
        return result;
    }
    static void store(const Values& from, Vector& to) {
        for (std::size_t k = 0; k < dimension; ++k) { Cells::store(from[k], to[k]); }
    }

    DirectionState<Cells, dimension> state_;
    Vector force_{}, velocity_{};
    std::uint64_t force_at_ = nowhere, velocity_at_ = nowhere;  ///< numbers of points
};

/// Numbers that a system keeps of a point for second derivatives along directions.
template <class Vector, std::size_t count>
class KeptOfPoint {
public:
    /// Computes them, unless this is the point where they are known.
    template <class Compute>
    void look_at(const Vector& point, const Compute& compute) {
        if (is_known_ && same_bits(point, point_)) { return; }
        compute(values_);
        copy(point, point_);
        is_known_ = true;
        ++number_;
    }

    [[nodiscard]] const std::array<ScalarOf<Vector>, count>& values() const { return values_; }
    /// Another one for each point that was looked at.
    [[nodiscard]] std::uint64_t number() const { return number_; }
    void forget() { is_known_ = false; }

private:
    std::array<ScalarOf<Vector>, count> values_{};
    std::uint64_t number_ = nowhere;
    Vector point_{};
    bool is_known_ = false;
};

/// Any number of directions at a state that is kicked and drifts in turn. So many numbers the
/// system keeps for second derivatives by q along directions, and by p.
///
/// NOTE: where the last slope of a step is the first one of the next so it is for directions.
template <class Vector, std::size_t kept_by_q, std::size_t kept_by_p>
class MovesAlong {
public:
    using Scalar = ScalarOf<Vector>;

    /// See Groups.
    template <class Directions>
    void take(const Directions& directions) {
        groups_.take(directions);
    }
    template <class Directions>
    void give(Directions& directions) {
        groups_.give(directions);
    }

    /// Kicks of size hb at the position q, and drifts of that size.
    template <class System>
    void kick(const System& system, const Vector& q, const Scalar& hb) {
        at_q_.look_at(q, [&](auto& kept) { system.keep_q(q, kept); });
        kick_all(system, hb);
    }
    template <class System>
    void kick(const System& system, const Vector& q, const Scalar& hb, const Scalar& time) {
        at_q_.forget();
        at_q_.look_at(q, [&](auto& kept) { system.keep_q(q, time, kept); });
        kick_all(system, hb);
    }
    template <class System>
    void drift(const System& system, const Vector& p, const Scalar& hb) {
        at_p_.look_at(p, [&](auto& kept) { system.keep_p(p, kept); });
        groups_.each([&](auto& group, std::size_t, std::size_t) {
            group.drift(system, at_p_, hb);
            return true;
        });
    }

    [[nodiscard]] bool is_finite() {
        return groups_.each(
            [](auto& group, std::size_t, std::size_t) { return group.is_finite(); });
    }

    void forget() {
        groups_.forget();
        at_q_.forget();
        at_p_.forget();
    }

private:
    static constexpr std::size_t dimension = fixed_size<Vector>();
    using One = MovedDirections<StagesInLanes<Scalar, 1>, dimension>;
    using Eight = MovedDirections<DirectionsInLanes<Scalar, 1>, dimension>;

    template <class System>
    void kick_all(const System& system, const Scalar& hb) {
        groups_.each([&](auto& group, std::size_t, std::size_t) {
            group.kick(system, at_q_, hb);
            return true;
        });
    }

    /// The number of directions that cost as much one by one as eight side by side.
    static constexpr std::size_t few = 4;

    Groups<One, Eight, few> groups_;
    KeptOfPoint<Vector, kept_by_q> at_q_;
    KeptOfPoint<Vector, kept_by_p> at_p_;
};

}  // namespace hvi::detail

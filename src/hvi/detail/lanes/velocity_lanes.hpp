// The stages of an implicit stepper for quadratic kinetic energy, side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/coefficients/weights.hpp>
#include <hvi/detail/lanes/lane_math.hpp>
#include <hvi/detail/lanes/lane_pairs.hpp>
#include <hvi/detail/lanes/lane_products.hpp>
#include <hvi/detail/lanes/lane_tables.hpp>
#include <hvi/detail/lanes/lanes.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/free_path.hpp>
#include <hvi/detail/stages/step_memory.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// Coefficients of VelocityStages for lanes.
template <class Scalar, std::size_t stages>
struct VelocityTable {
    LaneRow<Scalar, stages> c;
    LaneMatrix<Scalar, stages> n;
    LaneRow<Scalar, stages> left;  ///< 1 - c_j

    constexpr VelocityTable(const Scalar (&times)[stages],
                            const Scalar (&coefficients)[stages][stages])
        : c(lane_row(times)), n(lane_columns(coefficients)), left{} {
        for (std::size_t j = 0; j < stages; ++j) { left.set(j, 1 - times[j]); }
    }
};

/// VelocityStages in lanes: there is a row for each component, with a lane for each stage.
///
/// NOTE: functions that sweeps call are inlined, as no register of this size lives through a call.
template <class Vector, std::size_t stages, std::size_t most = widest>
struct VelocityLanes : StepMemory<Vector> {
    using Scalar = ScalarOf<Vector>;
    using Lane = Lanes<Scalar, stages, most>;
    using Row = typename Lane::Row;
    using Table = VelocityTable<Scalar, stages>;
    static constexpr std::size_t dimension = fixed_size<Vector>();

    LaneRows<Scalar, stages, dimension> Q{}, Lp{}, W{};
    LaneRows<Scalar, stages, dimension> drifted{};  ///< e_q + c_i w
    Vector free_path{}, rest_of_path{};             ///< w is the sum of both
    Row hb{};                                       ///< h b_j

    /// Sets the values that depend on h alone.
    template <class System>
    void weigh(const System& system, const Scalar (&b)[stages]) {
        if (this->h == weighed_) { return; }
        hb = lane_row(weights_of_step(this->h, b));
        factors_.set(system, this->n, this->h);
        weighed_ = this->h;
    }

    /// Sets w and `drifted`.
    template <class System>
    void drift_freely(const System& system, const Table& table) {
        factors_.scale(system, this->at.p, this->remainder.p, free_path, rest_of_path);
        const Lane c(table.c);
        for (std::size_t k = 0; k < dimension; ++k) {
            ((detail::at(this->remainder.q, k) + c * detail::at(rest_of_path, k)) +
             c * detail::at(free_path, k))
                .store(drifted[k]);
        }
    }

    /// Sets starting values: forces as at the start of the step, where dH/dq is `gradient`.
    template <class System>
    void predict(const System& system, const Vector& gradient) {
        for (std::size_t k = 0; k < dimension; ++k) {
            (-(Lane(hb) * detail::at(gradient, k))).store(Lp[k]);
        }
        drifts(system);
    }

    /// Sets all slopes to zero.
    void rest() { Lp = W = {}; }

    /// Sets starting values from the slopes of the last step, or of the last two.
    template <class... Before>
    void extrapolate(const LaneMatrix<Scalar, stages>& N, Before&&... before) {
        detail::extrapolate<Lane>(Lp, N, before...);
    }

    /// Sets Q_i = q + (e_q + c_i w + sum_j n_ij W_j).
    [[gnu::always_inline]] void positions(const Table& table) {
        keep_in_memory(W);
        products<Lane>(
            table.n, W, [&](std::size_t k) { return Lane(drifted[k]); },
            [&](std::size_t k, const auto& ways) __attribute__((always_inline)) {
                move_from(k, this->at.q, ways, Q, this->change.q);
            });
    }

    /// Sets Lp_i = -h b_i dH/dq; `time` is the T_i, where H depends on time.
    template <class System, class... Time>
    [[gnu::always_inline]] void forces(const System& system, const Time&... time) {
        auto out = write<Lane>(Lp, -Lane(hb));
        system.dHdq(read<Lane>(Q), Lane(time)..., out);
    }

    /// Sets the forces and the drifts. NOTE: few components stay in registers, so that no load
    /// waits for a store.
    template <class System, class... Time>
    [[gnu::always_inline]] void push(const System& system, const Time&... time) {
        if constexpr (dimension > few_components) {
            forces(system, time...);
            drifts(system);
        } else {
            std::array<Lane, dimension> Q_i, Lp_i, W_i;
            for (std::size_t k = 0; k < dimension; ++k) { Q_i[k] = Lane(Q[k]); }
            system.dHdq(Q_i, Lane(time)..., Lp_i);
            const Lane minus_hb = -Lane(hb);
            for (std::size_t k = 0; k < dimension; ++k) {
                Lp_i[k] = minus_hb * Lp_i[k];
                Lp_i[k].store(Lp[k]);
                Lp_i[k] = factor(k) * Lp_i[k];
            }
            if constexpr (System::has_diagonal_mass) {
                W_i = Lp_i;
            } else {
                system.inverse_mass(Lp_i, W_i);
            }
            for (std::size_t k = 0; k < dimension; ++k) { W_i[k].store(W[k]); }
        }
    }

    /// Sets W_i = h K Lp_i.
    template <class System>
    [[gnu::always_inline]] void drifts(const System& system) {
        if constexpr (System::has_diagonal_mass) {
            for (std::size_t k = 0; k < dimension; ++k) { (factor(k) * Lane(Lp[k])).store(W[k]); }
        } else {
            std::array<Lane, dimension> scaled, W_i;
            for (std::size_t k = 0; k < dimension; ++k) { scaled[k] = factor(k) * Lane(Lp[k]); }
            system.inverse_mass(scaled, W_i);
            for (std::size_t k = 0; k < dimension; ++k) { W_i[k].store(W[k]); }
        }
    }

    /// Moves `at` to the end of the step.
    ///
    /// NOTE: sums over stages first, so that components are moved side by side afterwards.
    template <class System>
    void advance(const System& system, const Table& table) {
        std::array<Scalar, dimension> near, kicks, rests;
        for (std::size_t k = 0; k < dimension; ++k) { near[k] = near_of_q(table, k); }
        for (std::size_t k = 0; k < dimension; ++k) {
            const Pair<Scalar> kick = kick_of(system, k);
            kicks[k] = kick.hi;
            rests[k] = kick.lo;
        }
        for (std::size_t k = 0; k < dimension; ++k) {
            move_far<Scalar>(detail::at(this->at.q, k), detail::at(this->remainder.q, k),
                             detail::at(free_path, k), near[k]);
        }
        factors_.kick(
            this->at.p, this->remainder.p,
            [&](auto k) {
                return Pair<Scalar>{kicks[index(k)], rests[index(k)]};
            },
            [&](auto k) { return exact_sum_of<stages>(&Lp[index(k)].at[0]); });
    }

    /// Returns w + sum_j (1 - c_j) W_j.
    [[nodiscard]] Scalar increment_q(const Table& table, std::size_t k) const {
        return detail::at(free_path, k) + near_of_q(table, k);
    }

    /// Returns the size that the rounding of component k of Q is compared with.
    ///
    /// NOTE: a stage may be near 0 where q is not, and it moves by the rounding of q.
    [[nodiscard]] Scalar size_q(std::size_t k) const {
        return detail::abs(detail::at(this->at.q, k)) + detail::abs(detail::at(free_path, k)) +
               sum(abs(Lane(Q[k])) + abs(Lane(W[k])));
    }

    // ---- one stage, for Newton's method; see VelocityStages ----

    [[nodiscard]] Vector position(std::size_t j) const { return lane_of<Vector>(Q, j); }
    /// Returns the middle stage, or the mean of the two stages in the middle.
    [[nodiscard]] Vector middle() const { return middle_of<Vector>(Q); }
    [[nodiscard]] Scalar force(std::size_t j, std::size_t k) const { return Lp[k][j]; }
    void set_force(std::size_t j, std::size_t k, Scalar value) { Lp[k].set(j, value); }

private:
    [[nodiscard]] static std::size_t index(typename StepMemory<Vector>::Index k) {
        return static_cast<std::size_t>(k);
    }

    [[nodiscard]] Scalar factor(std::size_t k) const { return detail::at(factors_.all(), k); }

    /// Returns the motion of q beside the free path: sum_j (1 - c_j) W_j, and the rest of that
    /// path.
    [[nodiscard]] Scalar near_of_q(const Table& table, std::size_t k) const {
        return detail::at(rest_of_path, k) + sum_of_lanes(Lane(table.left) * Lane(W[k]));
    }

    /// Returns the sum of the forces Lp_j, each times the factor of momenta and rounded.
    template <class System>
    [[nodiscard]] Pair<Scalar> kick_of(const System&, std::size_t k) const {
        if constexpr (System::has_diagonal_mass) {
            return exact_sum_of<stages>(&W[k].at[0]);
        } else {
            return exact_sum<Scalar, stages>(
                [&](std::size_t j) { return opaque(factor(k) * Lp[k][j]); });
        }
    }

    PathFactors<Vector> factors_;
    Scalar weighed_ = 0;  ///< step size of hb and the factors
};

}  // namespace hvi::detail

// Factors from momenta to free paths, of trajectories side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <hvi/detail/lanes/lane_tables.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/detail/trajectories/trajectories.hpp>

namespace hvi::detail {

/// Factors h K_k of each trajectory, where K is diagonal; else the factors are h. See PathFactors.
template <class Vector>
class TrajectoryFactors {
public:
    using Scalar = ScalarOf<Vector>;
    using Lane = Lanes<Scalar, trajectories_at_once>;
    using Mask = typename Lane::Mask;

    /// Sets the factors for steps of these sizes. Precondition: sizes and the system are those of
    /// the last call, unless forget() was called between.
    template <class System>
    void set(const System& system, const typename Lane::Row& h) {
        if (are_known_) { return; }
        Values velocity, diagonal;
        look_at(system, velocity, diagonal);
        for (std::size_t k = 0; k < dimension; ++k) {
            const Lane factor = Lane(h) * diagonal[k];
            factor.store(factor_[k]);
            (Lane(Scalar(1)) / factor).store(inverse_[k]);
            (Lane(h) * velocity[k]).store(offset_[k]);
        }
        are_known_ = true;
    }

    void forget() { are_known_ = false; }

    [[nodiscard]] Lane operator[](std::size_t k) const { return factor_[k]; }
    [[nodiscard]] Lane inverse(std::size_t k) const { return inverse_[k]; }

    /// Returns h times the part of dH/dp that does not depend on p.
    [[nodiscard]] Lane offset(std::size_t k) const { return offset_[k]; }

    /// Returns the trajectories in which p_k does not move q_k.
    [[nodiscard]] Mask zeros(std::size_t k) const { return (*this)[k] == Lane(Scalar(0)); }

private:
    static constexpr std::size_t dimension = fixed_size<Vector>();
    using Rows = TrajectoryRows<Vector>;
    using Values = LaneVector<Scalar, trajectories_at_once, dimension>;

    /// Sets dH/dp without p, and K_k, or 1.
    template <class System>
    static void look_at(const System& system, Values& velocity, Values& diagonal) {
        Values p;
        for (std::size_t k = 0; k < dimension; ++k) { p[k] = Lane(Scalar(0)); }
        system.dHdp(p, velocity);
        for (std::size_t k = 0; k < dimension; ++k) { p[k] = Lane(Scalar(1)); }
        if constexpr (System::has_diagonal_mass) {
            system.inverse_mass(p, diagonal);
        } else {
            diagonal = p;
        }
    }

    Rows factor_{}, inverse_{}, offset_{};
    bool are_known_ = false;  ///< whether the rows are of the system and its step sizes
};

}  // namespace hvi::detail

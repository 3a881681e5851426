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

    /// Sets the factors for h. Precondition: the system is that of the last call, unless forget()
    /// was called between.
    template <class System>
    void set(const System& system, Scalar h) {
        if (is_known_ && h == h_) { return; }
        if (!is_known_) { look_at(system); }
        h_ = h;
        for (std::size_t k = 0; k < dimension; ++k) {
            const Lane factor = h * Lane(K_[k]);
            factor.store(factor_[k]);
            (Lane(Scalar(1)) / factor).store(inverse_[k]);
            (h * Lane(velocity_[k])).store(offset_[k]);
        }
    }

    void forget() { is_known_ = false; }

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

    /// Sets the values that do not depend on h.
    template <class System>
    void look_at(const System& system) {
        Values p, velocity, diagonal;
        for (std::size_t k = 0; k < dimension; ++k) { p[k] = Lane(Scalar(0)); }
        system.dHdp(p, velocity);
        for (std::size_t k = 0; k < dimension; ++k) { p[k] = Lane(Scalar(1)); }
        if constexpr (System::has_diagonal_mass) {
            system.inverse_mass(p, diagonal);
        } else {
            diagonal = p;
        }
        store(velocity, velocity_);
        store(diagonal, K_);
        is_known_ = true;
    }

    Rows K_{}, velocity_{};  ///< K_k, or 1; dH/dp without p
    Rows factor_{}, inverse_{}, offset_{};
    Scalar h_ = 0;
    bool is_known_ = false;  ///< whether the rows are of the system
};

}  // namespace hvi::detail

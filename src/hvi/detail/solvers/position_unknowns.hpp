// Unknowns of Newton's method where the momenta of the stages are eliminated.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// Scaled forces Lp_j of VelocityStages, which solve
///
///     Lp_j + h b_j dH/dq(Q_j) = 0,    Q_i = q + (e_q + (h c_i v + h sum_j n_ij K Lp_j)).
///
/// The Jacobian of these equations is J = 1 + h^2 (C x G K) with C_ij = b_i n_ij, where all stages
/// have one matrix G of second derivatives.
template <class Vector>
class PositionUnknowns {
protected:
    using Scalar = ScalarOf<Vector>;

    template <class Coupled>
    static constexpr std::size_t r = Coupled::unknown.size();

    /// Makes room. Returns true where there was not enough.
    template <class Coupled>
    [[nodiscard]] bool make_room(const Coupled& coupled) {
        n_ = static_cast<std::size_t>(coupled.s.n);
        if (slopes_.size() == r<Coupled> * n_) { return false; }
        slopes_.resize(r<Coupled> * n_);
        correction_.resize(r<Coupled> * n_);
        return true;
    }

    /// Sets all unknowns to 0.
    template <class Coupled>
    void begin_at_rest(Coupled& coupled) {
        slopes_.assign(slopes_.size(), Scalar(0));
        put_slopes(coupled);
        is_start_ = true;
    }

    /// Sets Lp -= J^-1 (Lp + h b dH/dq); `solve(x)` replaces x by J^-1 x.
    ///
    /// NOTE: the first correction uses dH/dq = g + G (Q - q) of the start, where `times(v, out)`
    /// sets out = G v: where h is not small against the fastest period, H need not be defined at q
    /// + h c v. The corrected slopes are what the step adds up: see PairEquations.
    template <class Coupled, class Times, class Solve>
    void correct_by(Coupled& coupled, Times&& times, Solve&& solve) {
        if (is_start_) {
            linear_forces(coupled, times);
        } else {
            coupled.forces();
        }
        is_start_ = false;
        for_each_unknown<Coupled>([&](std::size_t i, std::size_t j, std::size_t k) {
            correction_[i] = slopes_[i] - coupled.s.force(j, k);
        });
        solve(correction_);
        for (std::size_t i = 0; i < slopes_.size(); ++i) { slopes_[i] -= correction_[i]; }
        put_slopes(coupled);
    }

    /// Counts the change as large as the values. NOTE: where GMRES does not converge, its
    /// correction may be next to nothing, far from the solution. Such a correction must not pass
    /// for rounding.
    template <class Coupled>
    static void count_as_unknown(Coupled& coupled) {
        for (IndexOf<Vector> k = 0; k < coupled.s.n; ++k) {
            coupled.s.change.q[k] = coupled.size_q(k);
        }
    }

    /// Calls f(i, j, k) for component k of each unknown Lp_j, the unknown number i.
    template <class Coupled, class F>
    void for_each_unknown(F f) const {
        std::size_t i = 0;
        for (const std::size_t j : Coupled::unknown) {
            for (std::size_t k = 0; k < n_; ++k) { f(i++, j, k); }
        }
    }

    /// Multiplies the vector over all stages of each component of x by a matrix.
    template <std::size_t size>
    void transform(const Scalar (&matrix)[size][size], std::vector<Scalar>& x) const {
        for (std::size_t k = 0; k < n_; ++k) {
            Scalar old[size];
            for (std::size_t i = 0; i < size; ++i) { old[i] = x[i * n_ + k]; }
            for (std::size_t i = 0; i < size; ++i) {
                Scalar sum = 0;
                for (std::size_t j = 0; j < size; ++j) { sum += matrix[i][j] * old[j]; }
                x[i * n_ + k] = sum;
            }
        }
    }

    std::size_t n_ = 0;

private:
    template <class Coupled>
    void put_slopes(Coupled& coupled) {
        for_each_unknown<Coupled>([&](std::size_t i, std::size_t j, std::size_t k) {
            coupled.s.set_force(j, k, slopes_[i]);
        });
        coupled.drifts();
        coupled.positions();
    }

    template <class Coupled, class Times>
    void linear_forces(Coupled& coupled, Times& times) {
        auto& s = coupled.s;
        coupled.force_at_start(s.slope);
        detail::fit(way_, s.n);
        detail::fit(bend_, s.n);
        for (const std::size_t j : Coupled::unknown) {
            const Vector& Q = s.position(j);
            for (IndexOf<Vector> k = 0; k < s.n; ++k) { way_[k] = Q[k] - s.at.q[k]; }
            times(way_, bend_);
            for (std::size_t k = 0; k < n_; ++k) {
                s.set_force(j, k, -s.hb[j] * (at(s.slope, k) + at(bend_, k)));
            }
        }
    }

    std::vector<Scalar> slopes_, correction_;  ///< component k of stage j at j n + k
    Vector way_{}, bend_{};
    bool is_start_ = false;
};

}  // namespace hvi::detail

// What Newton's method solves for where the momenta of the stages are eliminated.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// The scaled forces Lp_j of VelocityStages, which are to fulfil
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

    /// Makes room; true where there was not enough.
    template <class Coupled>
    [[nodiscard]] bool make_room(const Coupled& coupled) {
        n_ = static_cast<std::size_t>(coupled.s.n);
        if (slopes_.size() == r<Coupled> * n_) { return false; }
        slopes_.resize(r<Coupled> * n_);
        correction_.resize(r<Coupled> * n_);
        return true;
    }

    /// Sets all to 0.
    template <class Coupled>
    void begin_at_rest(Coupled& coupled) {
        slopes_.assign(slopes_.size(), Scalar(0));
        put_slopes(coupled);
    }

    /// Lp + h b dH/dq, of the forces that the stages have.
    template <class Coupled>
    void set_residual(const Coupled& coupled) {
        for_each_unknown<Coupled>([&](std::size_t i, std::size_t j, std::size_t k) {
            correction_[i] = slopes_[i] - coupled.s.force(j, k);
        });
    }

    /// NOTE: the corrected slopes are what the step adds up: see PairEquations.
    template <class Coupled>
    void subtract_correction(Coupled& coupled) {
        for (std::size_t i = 0; i < slopes_.size(); ++i) { slopes_[i] -= correction_[i]; }
        put_slopes(coupled);
    }

    /// Calls f(i, j, k) for component k of each unknown Lp_j, the unknown i.
    template <class Coupled, class F>
    void for_each_unknown(F f) const {
        std::size_t i = 0;
        for (const std::size_t j : Coupled::unknown) {
            for (std::size_t k = 0; k < n_; ++k) { f(i++, j, k); }
        }
    }

    /// Multiplies what belongs to one component of x, for all stages, by a matrix.
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

    std::vector<Scalar> slopes_, correction_;  ///< component k of stage j at j n + k
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
};

}  // namespace hvi::detail

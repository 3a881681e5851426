// Unknowns of Newton's method where positions and momenta of the stages are coupled.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/solvers/joint_slopes.hpp>
#include <hvi/detail/stages/system.hpp>

namespace hvi::detail {

/// Whether stages have times that second derivatives take.
template <class Coupled, class = void>
struct HasClock : std::false_type {};
template <class Coupled>
struct HasClock<Coupled, std::void_t<decltype(std::declval<const Coupled&>().clock)>>
    : std::true_type {};

/// Scaled slopes Lq and Lp of Stages, which have to equal the slopes at the stages that they make.
template <class Vector>
class SlopeUnknowns {
protected:
    using Scalar = ScalarOf<Vector>;

    template <class Coupled>
    static constexpr std::size_t unknowns() {
        return Coupled::unknown_q.size() + Coupled::unknown_p.size();
    }

    /// Makes room. Returns true where there was not enough.
    template <class Coupled>
    [[nodiscard]] bool make_room(const Coupled& coupled) {
        const auto n = static_cast<std::size_t>(coupled.s.n);
        const std::size_t size = unknowns<Coupled>() * n;
        if (slopes_.size() == size) { return false; }
        n_ = n;
        for (std::vector<Scalar>* v : {&slopes_, &correction_}) { v->resize(size); }
        return true;
    }

    /// Sets all unknowns to 0.
    template <class Coupled>
    void begin_at_rest(Coupled& coupled) {
        slopes_.assign(slopes_.size(), Scalar(0));
        scatter(coupled);
        coupled.momenta();
        coupled.positions();
    }

    /// Sets L -= J^-1 (L - slopes at the stages of L); `solve(x)` replaces x by J^-1 x.
    ///
    /// NOTE: the step adds up the corrected slopes, not gradients evaluated at the corrected
    /// stages, which would carry the rounding of the stages times (h omega)^2.
    template <class Coupled, class Solve>
    void correct_by(Coupled& coupled, Solve&& solve) {
        if constexpr (HasJointSlopes<Coupled>::value) {
            coupled.slopes();
        } else {
            coupled.velocities();
            coupled.forces();
        }
        gather(coupled, correction_);
        for (std::size_t i = 0; i < slopes_.size(); ++i) {
            correction_[i] = slopes_[i] - correction_[i];
        }
        solve(correction_);
        for (std::size_t i = 0; i < slopes_.size(); ++i) { slopes_[i] -= correction_[i]; }
        scatter(coupled);
        coupled.momenta();
        coupled.positions();
        measure(coupled);
    }

    /// Calls f with the time of stage i, or without it where H does not depend on the time.
    template <class Coupled, class F>
    static void with_time([[maybe_unused]] const Coupled& coupled, [[maybe_unused]] std::size_t i,
                          F f) {
        if constexpr (HasClock<Coupled>::value) {
            f(coupled.clock.t[i]);
        } else {
            f();
        }
    }

    std::size_t n_ = 0;

private:
    template <class Coupled>
    void measure(Coupled& coupled) {
        auto& change = coupled.s.change;
        for (std::size_t k = 0; k < n_; ++k) {
            at(change.q, k) = 0;
            at(change.p, k) = 0;
            for (std::size_t i = 0; i < unknowns<Coupled>(); ++i) {
                Vector& changes = i < Coupled::unknown_q.size() ? change.q : change.p;
                at(changes, k) += abs(correction_[i * n_ + k]);
            }
        }
    }

    template <class Coupled>
    void gather(const Coupled& coupled, std::vector<Scalar>& slopes) const {
        std::size_t offset = 0;
        for (const std::size_t j : Coupled::unknown_q) {
            for (std::size_t k = 0; k < n_; ++k) { slopes[offset++] = coupled.s.slope_q(j, k); }
        }
        for (const std::size_t i : Coupled::unknown_p) {
            for (std::size_t k = 0; k < n_; ++k) { slopes[offset++] = coupled.s.slope_p(i, k); }
        }
    }

    template <class Coupled>
    void scatter(Coupled& coupled) const {
        std::size_t offset = 0;
        for (const std::size_t j : Coupled::unknown_q) {
            for (std::size_t k = 0; k < n_; ++k) { coupled.s.set_slope_q(j, k, slopes_[offset++]); }
        }
        for (const std::size_t i : Coupled::unknown_p) {
            for (std::size_t k = 0; k < n_; ++k) { coupled.s.set_slope_p(i, k, slopes_[offset++]); }
        }
    }

    std::vector<Scalar> slopes_, correction_;  ///< components of unknown_q, then of unknown_p
};

}  // namespace hvi::detail

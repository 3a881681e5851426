// A fixed number of sweeps over coupled stages: an explicit step, for accuracies above round-off.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/solvers/joint_slopes.hpp>
#include <hvi/detail/solvers/sweep.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi {
namespace detail {

/// Sweeps as those of FixedPoint, from the same starting values, of a number that is given; see
/// more_from_start.
template <class Vector>
class CountedSweeps {
public:
    /// Makes `count` sweeps, or more, and a last evaluation. The status is not_finite where a stage
    /// is not. Preconditions: those of FixedPoint; count > 0.
    template <class Coupled>
    [[nodiscard]] Status solve(Coupled coupled, int count) {
        constexpr bool is_joint = HasJointSlopes<Coupled>::value;
        if (!coupled.s.goes_on || !went_on_) { count += more_from_start; }
        went_on_ = coupled.s.goes_on;
        if constexpr (!Coupled::separable && !is_joint) { coupled.positions(); }
        detail::sweep<true>(coupled);
        for (int done = 1;; ++done) {
            detail::close(coupled);
            if (done == count) { break; }
            detail::sweep<false>(coupled);
        }
        return Status(is_finite(coupled) ? Status::Code::ok : Status::Code::not_finite, count);
    }

private:
    /// NOTE: where H vanishes far away, a step through infinity may end in a finite state.
    template <class Coupled>
    [[nodiscard]] static bool is_finite(const Coupled& coupled) {
        using Scalar = ScalarOf<Vector>;
        Scalar size = 0;
        for (IndexOf<Vector> k = 0; k < coupled.s.n; ++k) {
            if constexpr (Coupled::has_q) { size += coupled.size_q(k); }
            if constexpr (Coupled::has_p) { size += coupled.size_p(k); }
        }
        return size < infinity<Scalar>;
    }

    bool went_on_ = false;  ///< whether the step before went on from another
};

}  // namespace detail

/// Solver policy of generated steppers: exactly `count` sweeps a step, from extrapolated slopes.
/// # Use
/// FixedSweeps is the second argument of a stepper's class, in place of FixedPoint. A step then is
/// explicit, and evaluates the gradient `count` times at each stage. Each sweep brings it nearer to
/// the symplectic step, by about a digit where steps are short. It is symplectic up to the last
/// change alone: the energy may drift by as much in each step, so that it is for runs that end
/// before this shows. In the first two steps, and in two after a change of the state or of h, there
/// are no slopes to extrapolate, and 16 sweeps more are made. The status is not_finite where a
/// stage is.
/// ```cpp
/// #include <array>
/// #include <cmath>
///
/// #include <hvi/fixed_sweeps.hpp>
/// #include <hvi/generated/gauss_2_separable.hpp>
///
/// struct Pendulum {
///     using Vector = std::array<double, 1>;
///     void dHdq(const Vector& q, Vector& out) const { out[0] = std::sin(q[0]); }
///     void dHdp(const Vector& p, Vector& out) const { out[0] = p[0]; }
/// };
///
/// template <int count>
/// double error_of_energy() {
///     hvi::generated::Gauss2Separable<Pendulum, hvi::FixedSweeps<count>> stepper;
///     hvi::State<Pendulum::Vector> x{{1.5}, {0.0}};
///     const double start = -std::cos(1.5);
///     for (int step = 0; step < 100; ++step) {
///         if (!stepper.step(x, 0.1).ok()) { return 1; }
///     }
///     return std::abs(x.p[0] * x.p[0] / 2 - std::cos(x.q[0]) - start);
/// }
///
/// int main() {
///     return error_of_energy<1>() < 1e-2 && error_of_energy<4>() < 1e-6 ? 0 : 1;
/// }
/// ```
template <int count>
struct FixedSweeps {
    static_assert(count > 0, "hvi: a step makes at least one sweep");

    static constexpr bool takes_starting_values = true;

    template <class Vector>
    class Iteration {
    public:
        /// Preconditions: those of FixedPoint.
        template <class Coupled>
        [[nodiscard]] Status solve(Coupled coupled) {
            return sweeps_.solve(coupled, count);
        }

    private:
        detail::CountedSweeps<Vector> sweeps_;
    };
};

}  // namespace hvi

// Fixed-point iteration for coupled stages: no derivatives, no linear algebra; for h that is small
// against the fastest period.
// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>
#include <utility>

#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/solvers/joint_slopes.hpp>
#include <hvi/detail/solvers/round_off.hpp>
#include <hvi/detail/solvers/sweep.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi {
namespace detail {

/// Whether the slopes that are solved for can all be moved at once.
template <class Coupled, class = void>
struct CanBeNudged : std::false_type {};
template <class Coupled>
struct CanBeNudged<Coupled, std::void_t<decltype(std::declval<Coupled&>().nudge(1))>>
    : std::true_type {};

/// Partitioned sweeps that use each new value at once: P from Lp, Lq from dHdp, Q from Lq, Lp from
/// dHdq. For separable H one partitioned sweep contracts as much as two Jacobi sweeps, which
/// compute Q and P from the slopes of the sweep before. Where H couples q and p the gain is small,
/// and equations with joint slopes are iterated as Jacobi does: neither gradient waits for the
/// other.
///
/// `first_order`: a sweep with the first-order change of dHdq follows each evaluation of dHdq.
template <class Vector, bool first_order>
class Sweeps {
public:
    static constexpr int most_iterations = 200;

    /// Gives up after `most` iterations and, where `ends_growth`, as soon as changes grow too much;
    /// see RoundOff::grows(). Precondition: Lq and Lp hold starting values; for separable H Lp
    /// alone does.
    template <bool ends_growth = false, class Coupled>
    [[nodiscard]] Status solve(Coupled coupled, int most = most_iterations) {
        if constexpr (is_fixed) {
            RoundOff<Vector> round_off(rounding);
            return iterate<ends_growth>(coupled, round_off, most);
        } else {
            return iterate<ends_growth>(coupled, kept_.round_off, most);
        }
    }

private:
    using Scalar = ScalarOf<Vector>;
    static constexpr Scalar rounding = 8 * epsilon<Scalar>;
    /// NOTE: the watcher of changes is on the stack where its size is fixed. Elsewhere a compiler
    /// must assume that stores to the stages may change it, and sweeps took a tenth more
    /// instructions.
    static constexpr bool is_fixed = fixed_size<Vector>() > 0;
    struct Nothing {};
    struct Kept {
        RoundOff<Vector> round_off{rounding};
    };

    template <bool ends_growth, class Coupled>
    [[nodiscard, gnu::always_inline]] Status iterate(Coupled& coupled, RoundOff<Vector>& round_off,
                                                     int most) {
        constexpr bool is_joint = HasJointSlopes<Coupled>::value;
        if constexpr (!Coupled::separable && !is_joint) { coupled.positions(); }
        round_off.begin(coupled.s.n);
        detail::sweep<true>(coupled);        // this change is measured against values of no meaning
        [[maybe_unused]] int nudged_in = 0;  // the iteration of the nudge; 0: none so far
        for (int iteration = 2; iteration <= most; ++iteration) {
            evaluate(coupled);
            if constexpr (CanBeNudged<Coupled>::value) {
                if (nudged_in == 0 && can_nudge(iteration) && nudge(coupled, round_off)) {
                    nudged_in = iteration;
                }
            }
            detail::sweep<false>(coupled);
            switch (judge(coupled, round_off)) {
            case Verdict::go_on:
                if constexpr (ends_growth) {
                    if (round_off.template grows<Coupled::has_q, by_p<Coupled>>(coupled.s.change,
                                                                                coupled)) {
                        return Status(Status::Code::not_converged, iteration);
                    }
                }
                break;
            case Verdict::unchanged:
                // NOTE: slopes that were nudged do not belong to these stages.
                if constexpr (CanBeNudged<Coupled>::value) {
                    if (nudged_in == 0 && can_nudge(iteration)) { break; }
                    if (nudged_in == iteration) { break; }
                }
                return Status(Status::Code::ok, iteration);
            case Verdict::at_noise: finish(coupled); return Status(Status::Code::ok, iteration);
            case Verdict::not_finite:
                // NOTE: a value that is not finite after the first sweeps comes from a diverging
                // iteration.
                return Status(iteration == 2 ? Status::Code::not_finite
                                             : Status::Code::not_converged,
                              iteration);
            }
            if constexpr (first_order) {
                coupled.forces_by_tangents();
                detail::sweep<false>(coupled);
            }
        }
        return Status(Status::Code::not_converged, most);
    }

    template <class Coupled>
    [[gnu::always_inline]] static void evaluate(Coupled& coupled) {
        if constexpr (first_order) {
            coupled.forces_and_tangents();
        } else {
            detail::close(coupled);
        }
    }

    /// Moves slopes that are nearly at rest to one side of their limit, and in the next step to the
    /// other side. Returns whether the slopes were near enough.
    ///
    /// NOTE: rounded sweeps have many fixed points, or circle among a few numbers. The side that
    /// they come from decides where they end, and extrapolated slopes always come from the same
    /// side: the energy of nonseparable drifts by -2.6e-19 of H a step with gauss:4 and h = 1/7,
    /// and with nudges by 0.0 +- 0.2e-19. Iterations of few sweeps have few such fixed points.
    template <class Coupled>
    [[nodiscard]] static bool nudge(Coupled& coupled, RoundOff<Vector>& round_off) {
        if (!round_off.template is_near<Coupled::has_q, by_p<Coupled>>(coupled)) { return false; }
        constexpr Scalar distance = 8 * epsilon<Scalar>;
        coupled.nudge(coupled.s.side ? 1 + distance : 1 - distance);
        return true;
    }

    /// NOTE: at least three sweeps follow a nudge. In iterations of this length they leave a fifth
    /// of a unit of it. Where sweeps contract less, the rest of the nudge would exceed the error
    /// that it mends.
    [[nodiscard]] static constexpr bool can_nudge(int iteration) {
        return 8 <= iteration && iteration <= 25;
    }

    /// Calls close() without inlining it once more. NOTE: on a copy of `coupled`, so that nothing
    /// else may point to the data of the loop.
    template <class Coupled>
    [[gnu::noinline]] static void finish(Coupled coupled) {
        detail::close(coupled);
    }

    /// Whether changes of P are judged. For separable H a sweep is a map of the positions alone:
    /// when they stay, all stays.
    template <class Coupled>
    static constexpr bool by_p = Coupled::has_p && !(Coupled::separable && Coupled::has_q);

    template <class Coupled>
    [[nodiscard]] static Verdict judge(const Coupled& coupled, RoundOff<Vector>& round_off) {
        return round_off.template judge<Coupled::has_q, by_p<Coupled>>(coupled.s.change, coupled);
    }

    std::conditional_t<is_fixed, Nothing, Kept> kept_;
};

}  // namespace detail

/// Solver policy of generated steppers, the default.
/// # Use
/// FixedPoint is the second argument of a stepper's class. The system offers its gradient and
/// nothing else. The iteration contracts while h is small against the fastest period 2 pi/omega: h
/// omega < 1 is enough for Gauss' methods, and hvi::Newton is for larger steps. An iteration
/// evaluates the gradient at each stage, and the last iteration is at round-off: there is no
/// tolerance to choose. The status is not_converged where the iteration grows or does not end in
/// 200 iterations, and not_finite where a derivative of H is not finite at the beginning.
/// ```cpp
/// #include <array>
/// #include <cmath>
///
/// #include <hvi/fixed_point.hpp>
/// #include <hvi/generated/gauss_2.hpp>
///
/// struct Rotor {  // H = (q^2 + p^2)^2/4: the larger the circle, the faster it turns
///     using Vector = std::array<double, 1>;
///     void dHdq(const Vector& q, const Vector& p, Vector& out) const {
///         out[0] = (q[0] * q[0] + p[0] * p[0]) * q[0];
///     }
///     void dHdp(const Vector& q, const Vector& p, Vector& out) const {
///         out[0] = (q[0] * q[0] + p[0] * p[0]) * p[0];
///     }
/// };
///
/// int main() {
///     hvi::generated::Gauss2<Rotor, hvi::FixedPoint> stepper;
///     hvi::State<Rotor::Vector> x{{1.0}, {0.0}};
///     for (int step = 0; step < 1000; ++step) {
///         if (!stepper.step(x, 0.1).ok()) { return 1; }
///     }
///     // Gauss' methods conserve what is quadratic: the circle.
///     const double error = x.q[0] * x.q[0] + x.p[0] * x.p[0] - 1;
///     const hvi::Status::Code too_large = stepper.step(x, 10.0).code();
///     return std::abs(error) < 1e-14 && too_large == hvi::Status::Code::not_converged ? 0 : 1;
/// }
/// ```
struct FixedPoint {
    static constexpr bool takes_starting_values = true;

    template <class Vector>
    using Iteration = detail::Sweeps<Vector, false>;
};

}  // namespace hvi

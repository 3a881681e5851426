// Newton's method for coupled stages: for h that is not small against the fastest period.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include <Eigen/Dense>
#include <hvi/arithmetic.hpp>
#include <hvi/round_off.hpp>
#include <hvi/state.hpp>
#include <hvi/system.hpp>

namespace hvi {
namespace detail {

template <class Vector>
using MatrixOf = Eigen::Matrix<ScalarOf<Vector>, Eigen::Dynamic, Eigen::Dynamic>;

template <class System, class Vector, class = void>
struct HasHessian : std::false_type {};
template <class System, class Vector>
struct HasHessian<System, Vector,
                  std::void_t<decltype(std::declval<const System&>().d2Hdq2(
                                  std::declval<const Vector&>(), std::declval<const Vector&>(),
                                  std::declval<MatrixOf<Vector>&>())),
                              decltype(std::declval<const System&>().d2Hdqdp(
                                  std::declval<const Vector&>(), std::declval<const Vector&>(),
                                  std::declval<MatrixOf<Vector>&>())),
                              decltype(std::declval<const System&>().d2Hdp2(
                                  std::declval<const Vector&>(), std::declval<const Vector&>(),
                                  std::declval<MatrixOf<Vector>&>()))>> : std::true_type {};

template <class System, class Vector, class = void>
struct HasSeparableHessian : std::false_type {};
template <class System, class Vector>
struct HasSeparableHessian<
    System, Vector,
    std::void_t<decltype(std::declval<const System&>().d2Hdq2(std::declval<const Vector&>(),
                                                              std::declval<MatrixOf<Vector>&>())),
                decltype(std::declval<const System&>().d2Hdp2(std::declval<const Vector&>(),
                                                              std::declval<MatrixOf<Vector>&>()))>>
    : std::true_type {};

}  // namespace detail

/// Solver policy of generated steppers: Newton's method with the exact Hessian, which the system
/// offers besides its gradient:
///
///     void d2Hdq2(const Vector& q, const Vector& p, Matrix& out) const;
///     void d2Hdqdp(const Vector& q, const Vector& p, Matrix& out) const;
///     void d2Hdp2(const Vector& q, const Vector& p, Matrix& out) const;
///
/// with Matrix = Eigen::MatrixXd where the vectors hold doubles, else Eigen::MatrixX<float> or
/// Eigen::MatrixX<long double>, and out(i, j) the derivative by q_i and p_j in the second; for
/// separable H d2Hdq2(q, out) and d2Hdp2(p, out). `out` comes as a zero matrix of the right size.
///
/// The factors of the Jacobian are kept over iterations and steps while the iteration contracts
/// well. They are forgotten with the state that they belong to and when h changes.
struct Newton {
    static constexpr int most_iterations = 60;
    static constexpr bool takes_starting_values = false;

    template <class Vector>
    class Iteration {
    public:
        template <class Coupled>
        [[nodiscard]] Status solve(Coupled coupled) {
            check<Coupled>();
            fit<Coupled>(coupled.s.n);
            round_off_.begin(coupled.s.n);
            begin(coupled);
            const bool reusable =
                factored_ && coupled.s.continues && coupled.s.h == coupled.s.h_before;
            bool reused = reusable;
            if (!reusable && !factorise(coupled)) { return Status(Status::Code::singular); }

            Scalar last_change = 0;
            for (int iteration = 1; iteration <= most_iterations; ++iteration) {
                correct(coupled);
                switch (round_off_.template judge<Coupled::has_q, Coupled::has_p>(coupled.s.change,
                                                                                  coupled)) {
                case detail::Verdict::go_on: break;
                case detail::Verdict::unchanged:
                case detail::Verdict::at_noise: return Status(Status::Code::ok, iteration);
                case detail::Verdict::not_finite: return failed(iteration);
                }
                const Scalar change = relative_change(coupled);
                const bool falls = iteration == 1 || change < last_change;
                const bool contracts = iteration == 1 || 4 * change <= last_change;
                last_change = change;
                if (!falls && change <= rounding) { return Status(Status::Code::ok, iteration); }
                if (contracts || change <= well) { continue; }
                if (reused) {
                    begin(coupled);
                    reused = false;
                }
                if (!factorise(coupled)) { return Status(Status::Code::singular, iteration); }
            }
            factored_ = false;
            return Status(Status::Code::not_converged, most_iterations);
        }

    private:
        using Index = Eigen::Index;
        using Scalar = detail::ScalarOf<Vector>;
        using Matrix = detail::MatrixOf<Vector>;
        using Column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
        static_assert(detail::is_standard<Scalar>,
                      "hvi::Newton: Eigen does not compute in these numbers: use hvi::FixedPoint");
        // NOTE: the part of a value that a correction may be and pass for rounding: it is rounding
        // times the inverse of J, which may magnify it somewhat. A correction below it ends the
        // iteration only when corrections no longer fall (Hairer, McLachlan & Razakarivony 2008).
        // To end at the first one below 4 epsilon, or where the rate of contraction promised a
        // next one below 2^-58, made the energy of Kepler's problem drift.
        static constexpr Scalar rounding = 128 * detail::epsilon<Scalar>;
        // So near to the solution any contraction does: with half of the digits and some more.
        static constexpr Scalar well = detail::power_of_two<Scalar>(-4 * detail::bits<Scalar> / 7);

        template <class Coupled>
        static constexpr void check() {
            using System = std::decay_t<decltype(std::declval<Coupled&>().system)>;
            if constexpr (Coupled::separable) {
                static_assert(detail::HasSeparableHessian<System, Vector>::value,
                              "hvi::Newton: for H = T(p) + U(q) the system must offer const "
                              "members d2Hdq2(q, out) and d2Hdp2(p, out), out a matrix of Eigen");
            } else {
                static_assert(detail::HasHessian<System, Vector>::value,
                              "hvi::Newton: the system must offer const members d2Hdq2, d2Hdqdp "
                              "and d2Hdp2, each (q, p, out), out a matrix of Eigen");
            }
        }

        template <class Coupled>
        static constexpr Index unknowns() {
            return static_cast<Index>(Coupled::unknown_q.size() + Coupled::unknown_p.size());
        }

        template <class Coupled>
        void fit(detail::IndexOf<Vector> dimension) {
            const Index size = unknowns<Coupled>() * static_cast<Index>(dimension);
            if (jacobian_.rows() == size) { return; }
            n_ = static_cast<Index>(dimension);
            jacobian_.resize(size, size);
            factors_ = Eigen::PartialPivLU<Matrix>(size);
            for (Column* v : {&slopes_, &residual_, &correction_}) { v->resize(size); }
            for (Matrix* block : {&Hqq_, &Hqp_, &Hpp_}) { block->resize(n_, n_); }
            factored_ = false;
        }

        /// NOTE: from no slopes at all, not from extrapolated ones: no polynomial follows a
        /// solution whose period is short against h, and q, p is where H is sure to be defined.
        template <class Coupled>
        void begin(Coupled& coupled) {
            slopes_.setZero();
            scatter(coupled);
            coupled.momenta();
            coupled.positions();
        }

        /// One step of the iteration: L -= J^-1 (L - slopes at the stages of L).
        ///
        /// NOTE: the corrected slopes are what the step adds up, not gradients evaluated at the
        /// corrected stages: those would carry the rounding of the stages times (h omega)^2.
        template <class Coupled>
        void correct(Coupled& coupled) {
            coupled.velocities();
            coupled.forces();
            gather(coupled, residual_);
            residual_ = slopes_ - residual_;
            correction_ = factors_.solve(residual_);
            slopes_ -= correction_;
            scatter(coupled);
            coupled.momenta();
            coupled.positions();
            measure(coupled);
        }

        template <class Coupled>
        void measure(Coupled& coupled) {
            auto& change = coupled.s.change;
            constexpr std::size_t velocities = Coupled::unknown_q.size();
            for (Index k = 0; k < n_; ++k) {
                at(change.q, k) = 0;
                at(change.p, k) = 0;
                for (Index i = 0; i < unknowns<Coupled>(); ++i) {
                    Vector& changes = i < static_cast<Index>(velocities) ? change.q : change.p;
                    at(changes, k) += std::abs(correction_[i * n_ + k]);
                }
            }
        }

        template <class Coupled>
        [[nodiscard]] Scalar relative_change(const Coupled& coupled) const {
            Scalar change = 0;
            for (Index k = 0; k < n_; ++k) {
                const auto component = static_cast<detail::IndexOf<Vector>>(k);
                if constexpr (Coupled::has_q) {
                    change = detail::larger(
                        change, ratio(coupled.s.change.q[component], coupled.size_q(component)));
                }
                if constexpr (Coupled::has_p) {
                    change = detail::larger(
                        change, ratio(coupled.s.change.p[component], coupled.size_p(component)));
                }
            }
            return change;
        }

        [[nodiscard]] static Scalar ratio(Scalar change, Scalar size) {
            return change == 0 ? 0 : change / size;
        }

        /// J at the present stages; false when it is singular.
        template <class Coupled>
        [[nodiscard]] bool factorise(const Coupled& coupled) {
            jacobian_.setIdentity();
            Index row = 0;
            for (const std::size_t j : Coupled::unknown_q) { velocity_rows(coupled, j, row++); }
            for (const std::size_t i : Coupled::unknown_p) { force_rows(coupled, i, row++); }
            factored_ = jacobian_.allFinite();
            if (!factored_) { return false; }
            factors_.compute(jacobian_);
            const auto pivots = factors_.matrixLU().diagonal();
            factored_ = pivots.allFinite() && pivots.cwiseAbs().minCoeff() > 0;
            return factored_;
        }

        /// Derivatives of Lq_j - h b_j dH/dp(Q_j, P_j).
        template <class Coupled>
        void velocity_rows(const Coupled& coupled, std::size_t j, Index row) {
            const auto& s = coupled.s;
            Hpp_.setZero();
            if constexpr (Coupled::separable) {
                coupled.system.d2Hdp2(s.P[j], Hpp_);
            } else {
                Hqp_.setZero();
                coupled.system.d2Hdp2(s.Q[j], s.P[j], Hpp_);
                coupled.system.d2Hdqdp(s.Q[j], s.P[j], Hqp_);
            }
            const Scalar hb = s.h * coupled.weight_q(j);
            Index column = 0;
            for (const std::size_t i : Coupled::unknown_q) {
                if constexpr (!Coupled::separable) {
                    block(row, column) -= (hb * coupled.coefficient_q(j, i)) * Hqp_.transpose();
                }
                static_cast<void>(i);
                ++column;
            }
            for (const std::size_t i : Coupled::unknown_p) {
                block(row, column++) -= (hb * coupled.coefficient_p(j, i)) * Hpp_;
            }
        }

        /// Derivatives of Lp_i + h b_i dH/dq(Q_i, P_i).
        template <class Coupled>
        void force_rows(const Coupled& coupled, std::size_t i, Index row) {
            const auto& s = coupled.s;
            Hqq_.setZero();
            if constexpr (Coupled::separable) {
                coupled.system.d2Hdq2(s.Q[i], Hqq_);
            } else {
                Hqp_.setZero();
                coupled.system.d2Hdq2(s.Q[i], s.P[i], Hqq_);
                coupled.system.d2Hdqdp(s.Q[i], s.P[i], Hqp_);
            }
            const Scalar hb = s.h * coupled.weight_p(i);
            Index column = 0;
            for (const std::size_t j : Coupled::unknown_q) {
                block(row, column++) += (hb * coupled.coefficient_q(i, j)) * Hqq_;
            }
            for (const std::size_t j : Coupled::unknown_p) {
                if constexpr (!Coupled::separable) {
                    block(row, column) += (hb * coupled.coefficient_p(i, j)) * Hqp_;
                }
                static_cast<void>(j);
                ++column;
            }
        }

        [[nodiscard]] auto block(Index row, Index column) {
            return jacobian_.block(row * n_, column * n_, n_, n_);
        }

        [[nodiscard]] Status failed(int iteration) {
            factored_ = false;
            return Status(iteration == 1 ? Status::Code::not_finite : Status::Code::not_converged,
                          iteration);
        }

        template <class Coupled>
        void gather(const Coupled& coupled, Column& slopes) const {
            Index offset = 0;
            const auto take = [&](const Vector& slope) {
                for (Index k = 0; k < n_; ++k) { slopes[offset++] = at(slope, k); }
            };
            for (const std::size_t j : Coupled::unknown_q) { take(coupled.s.Lq[j]); }
            for (const std::size_t i : Coupled::unknown_p) { take(coupled.s.Lp[i]); }
        }

        template <class Coupled>
        void scatter(Coupled& coupled) const {
            Index offset = 0;
            const auto put = [&](Vector& slope) {
                for (Index k = 0; k < n_; ++k) { at(slope, k) = slopes_[offset++]; }
            };
            for (const std::size_t j : Coupled::unknown_q) { put(coupled.s.Lq[j]); }
            for (const std::size_t i : Coupled::unknown_p) { put(coupled.s.Lp[i]); }
        }

        template <class AnyVector>
        [[nodiscard]] static decltype(auto) at(AnyVector& v, Index k) {
            return v[static_cast<detail::IndexOf<std::decay_t<AnyVector>>>(k)];
        }

        detail::RoundOff<Vector> round_off_{rounding};
        Matrix jacobian_, Hqq_, Hqp_, Hpp_;
        Eigen::PartialPivLU<Matrix> factors_;
        Column slopes_, residual_, correction_;
        Index n_ = 0;
        bool factored_ = false;
    };
};

}  // namespace hvi

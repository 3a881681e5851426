// Newton's method for coupled stages: for h that is not small against the fastest period.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include <Eigen/Dense>
#include <hvi/detail/solvers/newton_loop.hpp>
#include <hvi/detail/solvers/newton_pairs.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

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

/// Matrices and factors of Eigen for PairEquations.
template <class Vector>
class AlgebraOfEigen {
public:
    using Index = Eigen::Index;
    using Scalar = ScalarOf<Vector>;
    using Matrix = MatrixOf<Vector>;

    Matrix Hqq, Hqp, Hpp;

    void resize(std::size_t n, std::size_t unknowns) {
        for (Matrix* block : {&Hqq, &Hqp, &Hpp}) {
            block->resize(static_cast<Index>(n), static_cast<Index>(n));
        }
        jacobian_.resize(static_cast<Index>(unknowns), static_cast<Index>(unknowns));
        factors_ = Eigen::PartialPivLU<Matrix>(static_cast<Index>(unknowns));
    }

    void clear() {
        for (Matrix* block : {&Hqq, &Hqp, &Hpp}) { block->setZero(); }
    }

    void set_identity() { jacobian_.setIdentity(); }

    [[nodiscard]] Scalar& jacobian(std::size_t i, std::size_t j) {
        return jacobian_(static_cast<Index>(i), static_cast<Index>(j));
    }

    [[nodiscard]] bool is_finite() const { return jacobian_.allFinite(); }

    /// Factors the Jacobian. Returns false where it is singular, or not finite.
    [[nodiscard]] bool factorise() {
        if (!is_finite()) { return false; }
        factors_.compute(jacobian_);
        const auto pivots = factors_.matrixLU().diagonal();
        return pivots.allFinite() && pivots.cwiseAbs().minCoeff() > 0;
    }

    void solve(Scalar* b) const {
        Eigen::Map<Eigen::Matrix<Scalar, Eigen::Dynamic, 1>> x(b, jacobian_.rows());
        x = factors_.solve(x).eval();
    }

private:
    Matrix jacobian_;
    Eigen::PartialPivLU<Matrix> factors_;
};

}  // namespace detail

/// Solver policy of generated steppers: Newton's method with the exact Hessian, which the system
/// offers besides its gradient:
///
///     void d2Hdq2(const Vector& q, const Vector& p, Matrix& out) const;
///     void d2Hdqdp(const Vector& q, const Vector& p, Matrix& out) const;
///     void d2Hdp2(const Vector& q, const Vector& p, Matrix& out) const;
///
/// The type Matrix is Eigen::MatrixXd where the vectors hold doubles, else Eigen::MatrixX<float> or
/// Eigen::MatrixX<long double>. In d2Hdqdp, out(i, j) is the derivative by q_i and p_j. For
/// separable H the functions are d2Hdq2(q, out) and d2Hdp2(p, out). `out` comes as a zero matrix of
/// the right size.
///
/// The factors of the Jacobian are kept over iterations and steps while the iteration contracts
/// well. They are dropped when h changes, and when a step does not begin where the last one ended.
/// # Use
/// Newton is the second argument of a stepper's class, for float, double and long double. It needs
/// Eigen. The Jacobian has a row for each unknown component of the stages: s n rows for s stages
/// and n degrees of freedom, or twice as many. Factoring it costs the cube of that number. A step
/// ends at round-off, without a tolerance. Else its status is singular, not_finite, or
/// not_converged after 60 iterations.
/// ```cpp
/// #include <array>
/// #include <cmath>
///
/// #include <hvi/generated/gauss_2_separable.hpp>
/// #include <hvi/newton.hpp>
///
/// struct StiffSpring {  // H = p^2/2 + omega^2 q^2/2
///     using Vector = std::array<double, 1>;
///     static constexpr double omega = 100;
///     void dHdq(const Vector& q, Vector& out) const { out[0] = omega * omega * q[0]; }
///     void dHdp(const Vector& p, Vector& out) const { out = p; }
///     void d2Hdq2(const Vector&, Eigen::MatrixXd& out) const { out(0, 0) = omega * omega; }
///     void d2Hdp2(const Vector&, Eigen::MatrixXd& out) const { out(0, 0) = 1; }
/// };
///
/// int main() {
///     const double h = 0.1;  // more than a period of the spring
///     hvi::State<StiffSpring::Vector> x{{0.01}, {0.0}};
///     hvi::generated::Gauss2Separable<StiffSpring> by_fixed_points;
///     if (by_fixed_points.step(x, h).code() != hvi::Status::Code::not_converged) { return 1; }
///
///     hvi::generated::Gauss2Separable<StiffSpring, hvi::Newton> stepper;
///     for (int step = 0; step < 1000; ++step) {
///         if (!stepper.step(x, h).ok()) { return 1; }
///     }
///     // Gauss' methods conserve what is quadratic: the energy 1/2 of this spring.
///     const double omega_q = StiffSpring::omega * x.q[0];
///     return std::abs(x.p[0] * x.p[0] + omega_q * omega_q - 1) < 1e-12 ? 0 : 1;
/// }
/// ```
struct Newton {
    static constexpr bool takes_starting_values = false;

    template <class Vector>
    class Iteration {
    public:
        template <class Coupled>
        [[nodiscard]] Status solve(Coupled coupled) {
            check<Coupled>();
            return loop_.solve(coupled);
        }

    private:
        static_assert(detail::is_standard<detail::ScalarOf<Vector>>,
                      "hvi::Newton: Eigen does not compute in these numbers: use hvi::FixedPoint");

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

        detail::NewtonLoop<Vector, detail::PairEquations<Vector, detail::AlgebraOfEigen<Vector>>>
            loop_;
    };
};

}  // namespace hvi

// The method (4.18) straight from a table: slow and obvious, to check generated steppers against.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/state.hpp>

namespace hvi {

/// Coefficients of an s-stage symplectic partitioned Runge-Kutta method.
template <class Scalar>
struct Coefficients {
    std::vector<Scalar> b;
    std::vector<std::vector<Scalar>> A;
    std::vector<std::vector<Scalar>> A_tilde;
};

/// Applies any tableau to any Hamiltonian, both known at run time only. The formulas stand as the
/// paper prints them, solved by Jacobi's fixed-point iteration: no scaled form, no remembered
/// values, no compensated sums. GenericStepper is for tests; steppers that hvi-gen writes are
/// faster and lose less to rounding.
/// # Use
/// For s stages, b has s entries, and A and A_tilde have s rows of s entries. q and p are
/// std::vector of one size. A gradient writes all components of `out`, which has that size already.
/// h is a time in the units of H and may be negative. The status of a step is not_finite where a
/// value is not finite, and not_converged where h is so large that 1000 iterations do not end it.
/// Steps allocate, and may throw std::bad_alloc.
/// ```cpp
/// #include <cmath>
/// #include <vector>
///
/// #include <hvi/generic_stepper.hpp>
///
/// int main() {  // H = (p^2 + q^2)/2
///     using Stepper = hvi::GenericStepper<double>;
///     const hvi::Coefficients<double> midpoint{{1.0}, {{0.5}}, {{0.5}}};
///     const auto dHdq = [](const auto& q, const auto&, auto& out) { out = q; };
///     const auto dHdp = [](const auto&, const auto& p, auto& out) { out = p; };
///     const Stepper stepper(midpoint, dHdq, dHdp);
///
///     Stepper::State x{{1.0}, {0.0}};
///     const double h = 0.1;
///     for (int step = 0; step < 100; ++step) {
///         if (!stepper.step(x, h).ok()) { return 1; }
///     }
///     // Each step of the midpoint rule turns (q, p) by 2 arctan(h/2).
///     const double angle = 100 * 2 * std::atan(h / 2);
///     return std::hypot(x.q[0] - std::cos(angle), x.p[0] + std::sin(angle)) < 1e-13 ? 0 : 1;
/// }
/// ```
template <class Scalar>
class GenericStepper {
public:
    using Vector = std::vector<Scalar>;
    using State = hvi::State<Vector>;
    using Gradient = std::function<void(const Vector& q, const Vector& p, Vector& out)>;

    /// Precondition: A and A_tilde are square, of the size of b.
    GenericStepper(Coefficients<Scalar> coefficients, Gradient dHdq, Gradient dHdp)
        : method_(std::move(coefficients)), dHdq_(std::move(dHdq)), dHdp_(std::move(dHdp)) {}

    /// Advances x by a step of size h. Unless the status is ok, x has kept its bits.
    [[nodiscard]] Status step(State& x, Scalar h) const {
        const std::size_t s = method_.b.size();
        std::vector<Vector> Q(s, x.q), P(s, x.p), velocity(s, x.q), slope(s, x.p);
        Scalar smallest = detail::infinity<Scalar>;
        for (int iteration = 1; iteration <= most_iterations; ++iteration) {
            for (std::size_t i = 0; i < s; ++i) {
                dHdp_(Q[i], P[i], velocity[i]);
                dHdq_(Q[i], P[i], slope[i]);
            }
            Scalar change = 0;
            for (std::size_t i = 0; i < s; ++i) {
                change += replace(Q[i], sum(x.q, h, method_.A[i], velocity));      // (4.18c)
                change += replace(P[i], sum(x.p, -h, method_.A_tilde[i], slope));  // (4.18d)
            }
            if (!detail::is_finite(change)) { return Status(Status::Code::not_finite, iteration); }
            const bool settled = change >= smallest && change <= tolerance * size(Q, P);
            if (change == 0 || settled) {
                x.q = sum(x.q, h, method_.b, velocity);  // (4.18a)
                x.p = sum(x.p, -h, method_.b, slope);    // (4.18b)
                return Status(Status::Code::ok, iteration);
            }
            if (change < smallest) { smallest = change; }
        }
        return Status(Status::Code::not_converged, most_iterations);
    }

private:
    static constexpr int most_iterations = 1000;
    static constexpr Scalar tolerance = 32 * detail::epsilon<Scalar>;

    /// Returns y + h sum_j a_j f_j.
    [[nodiscard]] static Vector sum(const Vector& y, Scalar h, const Vector& a,
                                    const std::vector<Vector>& f) {
        Vector result = y;
        for (std::size_t k = 0; k < y.size(); ++k) {
            Scalar increment = 0;
            for (std::size_t j = 0; j < a.size(); ++j) { increment += a[j] * f[j][k]; }
            result[k] = y[k] + h * increment;
        }
        return result;
    }

    /// Sets the value to `by`, and returns how much it changes.
    static Scalar replace(Vector& value, const Vector& by) {
        Scalar change = 0;
        for (std::size_t k = 0; k < value.size(); ++k) { change += detail::abs(by[k] - value[k]); }
        value = by;
        return change;
    }

    [[nodiscard]] static Scalar size(const std::vector<Vector>& Q, const std::vector<Vector>& P) {
        Scalar result = 0;
        for (const auto* stages : {&Q, &P}) {
            for (const Vector& v : *stages) {
                for (std::size_t k = 0; k < v.size(); ++k) { result += detail::abs(v[k]); }
            }
        }
        return result;
    }

    Coefficients<Scalar> method_;
    Gradient dHdq_, dHdp_;
};

}  // namespace hvi

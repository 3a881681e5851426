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

/// The coefficients of an s-stage symplectic partitioned Runge-Kutta method.
template <class Scalar>
struct Coefficients {
    std::vector<Scalar> b;
    std::vector<std::vector<Scalar>> A;
    std::vector<std::vector<Scalar>> A_tilde;
};

/// Applies any tableau to any Hamiltonian, both known at run time only, by the formulas as the
/// paper prints them and Jacobi's fixed-point iteration: no scaled form, no remembered values, no
/// compensated sums. For tests; what hvi-gen writes is faster and loses less to rounding.
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

    /// y + h sum_j a_j f_j.
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

    /// Returns how much the value changes.
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

// The canonical equations of a scene, as libraries for any dy/dt = f(y, t) take them.
// SPDX-License-Identifier: MIT
//
// For `Problem` see main.hpp. Its Stepper is one with Newton's method, whose System has the second
// derivatives.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>

namespace hvi::driver {

/// dq/dt = dH/dp, dp/dt = -dH/dq, by the code that steppers evaluate; y is q, and then p.
template <class Problem>
class Equations {
public:
    using System = typename Problem::Stepper::System;
    using Vector = typename System::Vector;
    static constexpr std::size_t n = std::tuple_size<Vector>::value;
    using Values = std::array<double, 2 * n>;

    [[nodiscard]] static Values initial() {
        const auto x = Problem::initial();
        Values y{};
        std::copy(x.q.begin(), x.q.end(), y.begin());
        std::copy(x.p.begin(), x.p.end(), y.begin() + n);
        return y;
    }

    void slope(const double* y, double* dydt, double t) const {
        const auto [q, p] = parts(y);
        Vector by_q{}, by_p{};
        if constexpr (Problem::has_joint_gradient) {
            of_q([&](const auto&... x) { system_.gradient(x..., by_q, by_p); }, q, p, t);
        } else {
            of_q([&](const auto&... x) { system_.dHdq(x..., by_q); }, q, p, t);
            of_p([&](const auto&... x) { system_.dHdp(x..., by_p); }, q, p, t);
        }
        for (std::size_t k = 0; k < n; ++k) {
            dydt[k] = by_p[k];
            dydt[n + k] = -by_q[k];
        }
    }

    /// The two halves of slope(), for H = T(p) + U(q).
    void velocity(const Vector& p, Vector& dqdt) const { system_.dHdp(p, dqdt); }
    void force(const Vector& q, Vector& dpdt) const {
        system_.dHdq(q, dpdt);
        for (double& value : dpdt) { value = -value; }
    }

    /// The derivatives of slope() by y, row by row.
    void jacobian(const double* y, double* rows, double t) const {
        const auto [q, p] = parts(y);
        Matrix qq, qp, pp;
        of_q([&](const auto&... x) { system_.d2Hdq2(x..., qq); }, q, p, t);
        if constexpr (Problem::kinetic_is_quadratic) {
            inverse_mass(pp);
        } else {
            of_p([&](const auto&... x) { system_.d2Hdp2(x..., pp); }, q, p, t);
        }
        if constexpr (!Problem::is_separable) {
            of_q([&](const auto&... x) { system_.d2Hdqdp(x..., qp); }, q, p, t);
        }
        for (std::size_t i = 0; i < n; ++i) {
            double* const of_dqdt = rows + 2 * n * i;
            double* const of_dpdt = rows + 2 * n * (n + i);
            for (std::size_t j = 0; j < n; ++j) {
                of_dqdt[j] = qp(j, i);
                of_dqdt[n + j] = pp(i, j);
                of_dpdt[j] = -qq(i, j);
                of_dpdt[n + j] = -qp(i, j);
            }
        }
    }

    /// Of dH/dq, so far.
    [[nodiscard]] std::int64_t evaluations() const { return system_.evaluations; }

private:
    /// Entries that are not written are zero.
    class Matrix {
    public:
        double& operator()(std::size_t i, std::size_t j) { return entries_[n * i + j]; }

    private:
        std::array<double, n * n> entries_{};
    };

    static std::pair<Vector, Vector> parts(const double* y) {
        std::pair<Vector, Vector> x;
        std::copy(y, y + n, x.first.begin());
        std::copy(y + n, y + 2 * n, x.second.begin());
        return x;
    }

    /// Calls f with the arguments that the derivatives by q have.
    template <class Function>
    static void of_q(Function f, const Vector& q, [[maybe_unused]] const Vector& p,
                     [[maybe_unused]] double t) {
        if constexpr (Problem::is_separable && Problem::depends_on_time) {
            f(q, t);
        } else if constexpr (Problem::is_separable) {
            f(q);
        } else if constexpr (Problem::depends_on_time) {
            f(q, p, t);
        } else {
            f(q, p);
        }
    }

    /// The same, by p alone.
    template <class Function>
    static void of_p(Function f, [[maybe_unused]] const Vector& q, const Vector& p,
                     [[maybe_unused]] double t) {
        if constexpr (Problem::is_separable) {
            f(p);
        } else {
            of_q(f, q, p, t);
        }
    }

    /// Column by column.
    void inverse_mass(Matrix& pp) const {
        for (std::size_t j = 0; j < n; ++j) {
            Vector unit{}, column{};
            unit[j] = 1;
            system_.inverse_mass(unit, column);
            for (std::size_t i = 0; i < n; ++i) { pp(i, j) = column[i]; }
        }
    }

    System system_{typename Problem::Stepper::Parameters{}};
};

}  // namespace hvi::driver

// Canonical equations of a scene, for libraries that solve dy/dt = f(y, t).
// SPDX-License-Identifier: MIT
//
// For `Problem` see departure.hpp. Its Stepper is one with Newton's method, whose System has the
// second derivatives of H, or of L.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

#include <hvi/detail/linear/frozen_matrix.hpp>
#include <hvi/detail/stages/lagrangian_stages.hpp>

namespace hvi::driver {

/// Common part of the canonical equations of H and of L; y is q, and then p.
template <class Problem>
class CanonicalEquations {
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

    /// Returns the number of evaluations of dH/dq, or of dL/dq, so far.
    [[nodiscard]] std::int64_t evaluations() const { return system_.evaluations; }

protected:
    /// A square matrix. Entries that are not written are zero.
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

    /// Calls f with x, followed by the time where the scene depends on it.
    template <class Function, class... Vectors>
    static void at_time([[maybe_unused]] double t, Function f, const Vectors&... x) {
        if constexpr (Problem::depends_on_time) {
            f(x..., t);
        } else {
            f(x...);
        }
    }

    System system_{typename Problem::Stepper::Parameters{}};
};

/// Equations dq/dt = dH/dp, dp/dt = -dH/dq, by the code that steppers evaluate.
template <class Problem>
class EquationsOfHamiltonian : public CanonicalEquations<Problem> {
public:
    using Base = CanonicalEquations<Problem>;
    using Base::n;
    using typename Base::Vector;

    void slope(const double* y, double* dydt, double t) const {
        const auto [q, p] = Base::parts(y);
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

    /// Compute the two halves of slope(), for H = T(p) + U(q).
    void velocity(const Vector& p, Vector& dqdt) const { system_.dHdp(p, dqdt); }
    void force(const Vector& q, Vector& dpdt) const {
        system_.dHdq(q, dpdt);
        for (double& value : dpdt) { value = -value; }
    }

    /// Computes the derivatives of slope() by y, row by row.
    void jacobian(const double* y, double* rows, double t) const {
        const auto [q, p] = Base::parts(y);
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

private:
    using Base::system_;
    using typename Base::Matrix;

    /// Calls f with the arguments of the derivatives of H by q.
    template <class Function>
    static void of_q(Function f, const Vector& q, [[maybe_unused]] const Vector& p, double t) {
        if constexpr (Problem::is_separable) {
            Base::at_time(t, f, q);
        } else {
            Base::at_time(t, f, q, p);
        }
    }

    /// Calls f with the arguments of the derivatives of H by p alone.
    template <class Function>
    static void of_p(Function f, [[maybe_unused]] const Vector& q, const Vector& p,
                     [[maybe_unused]] double t) {
        if constexpr (Problem::is_separable) {
            f(p);
        } else {
            of_q(f, q, p, t);
        }
    }

    /// Sets pp to the inverse mass matrix, column by column.
    void inverse_mass(Matrix& pp) const {
        for (std::size_t j = 0; j < n; ++j) {
            Vector unit{}, column{};
            unit[j] = 1;
            system_.inverse_mass(unit, column);
            for (std::size_t i = 0; i < n; ++i) { pp(i, j) = column[i]; }
        }
    }
};

/// Equations p = dL/dv(q, v), dq/dt = v, dp/dt = dL/dq(q, v).
template <class Problem>
class EquationsOfLagrangian : public CanonicalEquations<Problem> {
public:
    using Base = CanonicalEquations<Problem>;
    using Base::n;
    using typename Base::Vector;

    void slope(const double* y, double* dydt, double t) const {
        const auto [q, p] = Base::parts(y);
        at_time(t, [&, &q = q, &p = p](const auto&... time) {
            const Vector v = detail::velocity_of(system_, q, p, time...);
            Vector by_q{}, by_v{};
            system_.gradient(q, v, time..., by_q, by_v);
            std::copy(v.begin(), v.end(), dydt);
            std::copy(by_q.begin(), by_q.end(), dydt + n);
        });
    }

    /// Computes the derivatives of slope() by y, row by row. With M = d2L/dv2 and C = d2L/dqdv, the
    /// derivatives of v by q and p are -M^-1 C^T and M^-1. The chain rule with d2L/dq2 and C then
    /// gives those of dL/dq.
    void jacobian(const double* y, double* rows, double t) const {
        const auto [q, p] = Base::parts(y);
        Matrix qq, C;
        detail::FrozenMatrix<Vector> M;
        at_time(t, [&, &q = q, &p = p](const auto&... time) {
            const Vector v = detail::velocity_of(system_, q, p, time...);
            system_.d2Ldq2(q, v, time..., qq);
            system_.d2Ldqdv(q, v, time..., C);
            static_cast<void>(M.compute([&](auto& out) { system_.d2Ldv2(q, v, time..., out); }));
        });
        for (std::size_t j = 0; j < n; ++j) {
            Vector by_q{}, by_p{};  // columns of the derivatives of v
            for (std::size_t i = 0; i < n; ++i) {
                by_q[i] = -C(j, i);
                by_p[i] = i == j ? 1 : 0;
            }
            by_q = M.inverse_times(by_q);
            by_p = M.inverse_times(by_p);
            for (std::size_t i = 0; i < n; ++i) {
                double of_q = qq(i, j), of_p = 0;
                for (std::size_t k = 0; k < n; ++k) {
                    of_q += C(i, k) * by_q[k];
                    of_p += C(i, k) * by_p[k];
                }
                rows[2 * n * i + j] = by_q[i];
                rows[2 * n * i + n + j] = by_p[i];
                rows[2 * n * (n + i) + j] = of_q;
                rows[2 * n * (n + i) + n + j] = of_p;
            }
        }
    }

private:
    using Base::at_time;
    using Base::system_;
    using typename Base::Matrix;
};

template <class Problem>
using Equations = std::conditional_t<Problem::has_lagrangian, EquationsOfLagrangian<Problem>,
                                     EquationsOfHamiltonian<Problem>>;

}  // namespace hvi::driver

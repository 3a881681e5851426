// Newton's method for the slopes of positions and momenta, by products of second derivatives.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <hvi/detail/linear/gmres.hpp>
#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/solvers/newton_loop.hpp>
#include <hvi/detail/solvers/slope_unknowns.hpp>
#include <hvi/detail/stages/system.hpp>

namespace hvi {
namespace detail {

/// Equations of a NewtonLoop whose unknowns are the slopes Lq and Lp, for any number of degrees of
/// freedom: no matrix is kept. With the second derivatives of each stage at its present place, J x
/// consists of
///
///     x_q,j - h b_j (d2H/dpdq dQ_j + d2H/dp2 dP_j),    dQ_j = sum_i m_ji x_q,i,
///     x_p,i + h b_i (d2H/dq2 dQ_i + d2H/dqdp dP_i),    dP_j = sum_i mt_ji x_p,i,
///
/// GMRES solves for x. An inexact solution is enough for a correction, as the next one corrects it.
template <class Vector>
class PairProductEquations : SlopeUnknowns<Vector> {
public:
    /// Makes room. NOTE: always true, as there are no factors to go on with.
    template <class Coupled>
    [[nodiscard]] bool fit(const Coupled& coupled) {
        static_cast<void>(this->make_room(coupled));
        for (Vector* v : {&dQ_, &dP_, &product_}) { detail::fit(*v, coupled.s.n); }
        return true;
    }

    template <class Coupled>
    void begin(Coupled& coupled) {
        this->begin_at_rest(coupled);
    }

    template <class Coupled>
    [[nodiscard]] bool factorise_start(const Coupled&) {
        return true;
    }
    template <class Coupled>
    [[nodiscard]] bool factorise(const Coupled&) {
        return true;
    }

    /// NOTE: a value that is not finite shows in the stages.
    [[nodiscard]] bool is_finite() const { return true; }
    [[nodiscard]] bool rounds_with_largest() const { return true; }

    /// Corrects the slopes; see SlopeUnknowns.
    template <class Coupled>
    void correct(Coupled& coupled) {
        this->correct_by(coupled, [&](std::vector<Scalar>& b) {
            set_unit(coupled, b);
            const std::size_t first_p = Coupled::unknown_q.size() * n_;
            for (std::size_t i = first_p; i < b.size(); ++i) { b[i] /= unit_; }
            is_solved_ = gmres_.solve(
                b, power_of_two<Scalar>(-12),
                [&](const std::vector<Scalar>& x, std::vector<Scalar>& out) {
                    multiply(coupled, x, out);
                },
                [](const std::vector<Scalar>&) {});
            for (std::size_t i = first_p; i < b.size(); ++i) { b[i] *= unit_; }
        });
        if (!is_solved_) { count_as_unknown(coupled); }
    }

private:
    using typename SlopeUnknowns<Vector>::Scalar;
    using SlopeUnknowns<Vector>::n_;

    /// Sets the unit of p. NOTE: GMRES makes the residual of all components small as a whole, so
    /// that p is measured in a unit in which it is as large as q.
    template <class Coupled>
    void set_unit(const Coupled& coupled, const std::vector<Scalar>& b) {
        const std::size_t first_p = Coupled::unknown_q.size() * n_;
        Scalar q = 0, p = 0;
        for (std::size_t i = 0; i < b.size(); ++i) {
            Scalar& largest = i < first_p ? q : p;
            largest = larger(largest, abs(b[i]));
        }
        for (IndexOf<Vector> k = 0; k < coupled.s.n; ++k) {
            q = larger(q, coupled.size_q(k));
            p = larger(p, coupled.size_p(k));
        }
        unit_ = q > 0 && p > 0 ? p / q : Scalar(1);
        if (!(unit_ > 0) || unit_ - unit_ != 0) { unit_ = 1; }
    }

    /// Counts the change as large as the values. NOTE: where GMRES does not converge, its
    /// correction may be next to nothing, far from the solution. Such a correction must not pass
    /// for rounding.
    template <class Coupled>
    static void count_as_unknown(Coupled& coupled) {
        auto& change = coupled.s.change;
        for (IndexOf<Vector> k = 0; k < coupled.s.n; ++k) {
            change.q[k] = coupled.size_q(k);
            change.p[k] = coupled.size_p(k);
        }
    }

    template <class Coupled>
    void multiply(const Coupled& coupled, const std::vector<Scalar>& x, std::vector<Scalar>& out) {
        out = x;
        std::size_t row = 0;
        for (const std::size_t j : Coupled::unknown_q) {
            multiply_by_p(coupled, j, x);
            const Scalar hb = coupled.s.h * coupled.weight_q(j);
            for (std::size_t k = 0; k < n_; ++k) { out[row++] -= hb * at(product_, k); }
        }
        for (const std::size_t i : Coupled::unknown_p) {
            multiply_by_q(coupled, i, x);
            const Scalar hb = coupled.s.h * coupled.weight_p(i) / unit_;
            for (std::size_t k = 0; k < n_; ++k) { out[row++] += hb * at(product_, k); }
        }
    }

    /// NOTE: where H = T(p) + U(q) stage j may have momenta alone, or positions alone.
    template <class Coupled>
    void multiply_by_p(const Coupled& coupled, std::size_t j, const std::vector<Scalar>& x) {
        set_dP(coupled, j, x);
        const auto& s = coupled.s;
        if constexpr (Coupled::separable) {
            coupled.system.d2Hdp(s.momentum(j), dP_, product_);
        } else {
            set_dQ(coupled, j, x);
            this->with_time(coupled, j, [&](const auto&... t) {
                coupled.system.d2Hdp(s.position(j), s.momentum(j), dQ_, dP_, t..., product_);
            });
        }
    }

    template <class Coupled>
    void multiply_by_q(const Coupled& coupled, std::size_t i, const std::vector<Scalar>& x) {
        set_dQ(coupled, i, x);
        const auto& s = coupled.s;
        if constexpr (!Coupled::separable) { set_dP(coupled, i, x); }
        this->with_time(coupled, i, [&](const auto&... t) {
            if constexpr (Coupled::separable) {
                coupled.system.d2Hdq(s.position(i), dQ_, t..., product_);
            } else {
                coupled.system.d2Hdq(s.position(i), s.momentum(i), dQ_, dP_, t..., product_);
            }
        });
    }

    template <class Coupled>
    void set_dQ(const Coupled& coupled, std::size_t i, const std::vector<Scalar>& x) {
        dQ_.assign(n_, Scalar(0));
        const Scalar* slope = x.data();
        for (const std::size_t j : Coupled::unknown_q) {
            const Scalar m = coupled.coefficient_q(i, j);
            for (std::size_t k = 0; k < n_; ++k) { dQ_[k] += m * *slope++; }
        }
    }

    template <class Coupled>
    void set_dP(const Coupled& coupled, std::size_t j, const std::vector<Scalar>& x) {
        dP_.assign(n_, Scalar(0));
        const Scalar* slope = x.data() + Coupled::unknown_q.size() * n_;
        for (const std::size_t i : Coupled::unknown_p) {
            const Scalar mt = coupled.coefficient_p(j, i) * unit_;
            for (std::size_t k = 0; k < n_; ++k) { dP_[k] += mt * *slope++; }
        }
    }

    Gmres<Scalar> gmres_;
    Vector dQ_{}, dP_{}, product_{};
    Scalar unit_ = 1;         ///< unit of p
    bool is_solved_ = false;  ///< whether the last correction is J^-1 residual
};

}  // namespace detail

/// Solver policy of steppers of systems with many degrees of freedom whose stages have positions
/// and momenta.
struct NewtonOfPairProducts {
    static constexpr bool takes_starting_values = false;

    template <class Vector>
    using Iteration = detail::NewtonLoop<Vector, detail::PairProductEquations<Vector>>;
};

}  // namespace hvi

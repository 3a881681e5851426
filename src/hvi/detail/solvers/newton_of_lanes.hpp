// Newton's method for stages in lanes, for steps that one Hessian for all stages does not solve.
// SPDX-License-Identifier: MIT
//
// NOTE: stage by stage and in loops, as few steps need it, and every header of lanes compiles it.
#pragma once

#include <cstddef>
#include <vector>

#include <hvi/detail/linear/dense.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/solvers/corrected_sweeps.hpp>
#include <hvi/detail/solvers/stiffness.hpp>
#include <hvi/state.hpp>

namespace hvi {
namespace detail {

/// Jacobian of the slopes of all stages, J_ji = 1_ji + h b_j C_ji R_j. R_j has the second
/// derivatives at stage j. C has the coefficients of the method in this form of the equations: n
/// for positions, m for pairs.
template <class Scalar>
class JacobianOfStages {
public:
    /// Computes and factors J; `set_R(j)` sets R to that of stage j. Returns false where J is
    /// singular, or not finite.
    template <class Coupled, class Set>
    [[nodiscard, gnu::cold]] bool compute(const Coupled& coupled, std::size_t rows, Set set_R) {
        R.set_zero(rows);
        J_.set_zero(Coupled::stages * rows);
        for (std::size_t j = 0; j < Coupled::stages; ++j) {
            set_R(j);
            for (std::size_t i = 0; i < Coupled::stages; ++i) {
                add(j * rows, i * rows, coupled.s.hb[j] * Coupled::coefficient(j, i), i == j);
            }
        }
        return J_.is_finite() && factors_.compute(J_);
    }

    void solve(std::vector<Scalar>& x) const { factors_.solve(x.data()); }

    /// Returns whether J is, or would have been, finite.
    [[nodiscard]] bool is_finite() const { return J_.is_finite(); }

    SquareMatrix<Scalar> R;

private:
    [[gnu::cold]] void add(std::size_t row, std::size_t column, Scalar factor, bool is_diagonal) {
        for (std::size_t k = 0; k < R.size(); ++k) {
            for (std::size_t l = 0; l < R.size(); ++l) {
                J_(row + k, column + l) = factor * R(k, l);
            }
            if (is_diagonal) { J_(row + k, column + k) += 1; }
        }
    }

    SquareMatrix<Scalar> J_;
    Factors<Scalar> factors_;
};

/// Common part of PositionsOfLanes and PairsOfLanes.
template <class Vector>
class SlopesOfLanes {
public:
    template <class Coupled>
    void rest(Coupled& coupled) {
        n_ = static_cast<std::size_t>(coupled.s.n);
        coupled.s.rest();
        coupled.begin_corrections();
    }

    /// Returns whether J is, or would have been, finite.
    [[nodiscard]] bool is_finite() const { return jacobian_.is_finite(); }

protected:
    using Scalar = ScalarOf<Vector>;

    /// Sets L -= J^-1 (L - slopes at the stages of L). `get` copies the slopes, `put` replaces
    /// them.
    template <class Get, class Evaluate, class Put>
    [[gnu::cold]] void correct_by(Get get, Evaluate evaluate, Put put) {
        get(L_);
        evaluate();
        get(residual_);
        for (std::size_t i = 0; i < L_.size(); ++i) { residual_[i] = L_[i] - residual_[i]; }
        jacobian_.solve(residual_);
        for (std::size_t i = 0; i < L_.size(); ++i) { L_[i] -= residual_[i]; }
        put(L_);
    }

    std::size_t n_ = 0;
    JacobianOfStages<Scalar> jacobian_;

private:
    std::vector<Scalar> L_, residual_;
};

/// Unknowns of VelocityLanes: the Lp_j of PositionUnknowns, component k at j n + k.
template <class Vector>
class PositionsOfLanes : public SlopesOfLanes<Vector> {
public:
    /// Factors J with the second derivatives at the start of the step at all stages.
    template <class Coupled>
    [[nodiscard]] bool factorise_start(const Coupled& coupled) {
        set_G([&](auto& G) { coupled.hessian_at_start(G); });
        return jacobian_.compute(coupled, n_, [&](std::size_t) { set_R(coupled); });
    }

    template <class Coupled>
    [[nodiscard]] bool factorise(const Coupled& coupled) {
        return jacobian_.compute(coupled, n_, [&](std::size_t j) {
            set_G([&](auto& G) { coupled.hessian(j, G); });
            set_R(coupled);
        });
    }

    /// Sets the slopes to those that dH/dq = g + G (Q - q) of the start leads to from rest.
    ///
    /// NOTE: where h is not small against the fastest period, H need not be defined at q + h c v.
    template <class Coupled>
    [[gnu::cold]] void begin(Coupled& coupled) {
        auto& s = coupled.s;
        set_G([&](auto& G) { coupled.hessian_at_start(G); });
        coupled.force_at_start(s.slope);
        std::vector<Scalar> Lp(Coupled::stages * n_);
        for (std::size_t j = 0; j < Coupled::stages; ++j) {
            for (std::size_t k = 0; k < n_; ++k) {
                Scalar slope = at(s.slope, k);
                for (std::size_t l = 0; l < n_; ++l) {
                    slope += G_(k, l) * (s.Q[l][j] - at(s.at.q, l));
                }
                Lp[j * n_ + k] = -s.hb[j] * slope;
            }
        }
        jacobian_.solve(Lp);
        put(Lp, coupled);
    }

    /// Sets Lp -= J^-1 (Lp + h b dH/dq).
    template <class Coupled>
    [[gnu::noinline, gnu::cold]] void correct(Coupled& coupled) {
        this->correct_by([&](auto& Lp) { get(coupled, Lp); }, [&] { coupled.slopes_of_momenta(); },
                         [&](const auto& Lp) { put(Lp, coupled); });
    }

private:
    using typename SlopesOfLanes<Vector>::Scalar;
    using SlopesOfLanes<Vector>::n_;
    using SlopesOfLanes<Vector>::jacobian_;

    template <class Set>
    void set_G(Set set) {
        G_.set_zero(n_);
        set(G_);
    }

    /// Sets R = h G K.
    template <class Coupled>
    void set_R(const Coupled& coupled) {
        set_hGK(coupled, G_, jacobian_.R);
    }

    template <class Coupled>
    void get(const Coupled& coupled, std::vector<Scalar>& Lp) const {
        Lp.resize(Coupled::stages * n_);
        for (std::size_t j = 0; j < Coupled::stages; ++j) {
            for (std::size_t k = 0; k < n_; ++k) { Lp[j * n_ + k] = coupled.s.Lp[k][j]; }
        }
    }

    template <class Coupled>
    void put(const std::vector<Scalar>& Lp, Coupled& coupled) const {
        for (std::size_t j = 0; j < Coupled::stages; ++j) {
            for (std::size_t k = 0; k < n_; ++k) { coupled.s.Lp[k].set(j, Lp[j * n_ + k]); }
        }
        coupled.s.drifts(coupled.system);
    }

    SquareMatrix<Scalar> G_;
};

/// Unknowns of StageLanes: component k of Lq_j at 2 j n + k, and of Lp_j at n places further on.
/// Precondition: m == mt.
template <class Vector>
class PairsOfLanes : public SlopesOfLanes<Vector> {
public:
    template <class Coupled>
    [[nodiscard]] bool factorise_start(const Coupled& coupled) {
        return factorise(coupled);
    }
    template <class Coupled>
    void begin(Coupled&) {}

    /// Factors J with R = -(Hpq Hpp; -Hqq -Hqp) of each stage.
    template <class Coupled>
    [[nodiscard]] bool factorise(const Coupled& coupled) {
        auto& R = jacobian_.R;
        return jacobian_.compute(coupled, 2 * n_, [&](std::size_t j) {
            for (SquareMatrix<Scalar>* block : {&Hqq_, &Hqp_, &Hpp_}) { block->set_zero(n_); }
            coupled.hessian(j, Hqq_, Hqp_, Hpp_);
            for (std::size_t k = 0; k < n_; ++k) {
                for (std::size_t l = 0; l < n_; ++l) {
                    R(k, l) = -Hqp_(l, k);
                    R(k, n_ + l) = -Hpp_(k, l);
                    R(n_ + k, l) = Hqq_(k, l);
                    R(n_ + k, n_ + l) = Hqp_(k, l);
                }
            }
        });
    }

    template <class Coupled>
    [[gnu::noinline, gnu::cold]] void correct(Coupled& coupled) {
        this->correct_by([&](auto& L) { get(coupled, L); }, [&] { coupled.all_slopes(); },
                         [&](const auto& L) { put(L, coupled); });
    }

private:
    using typename SlopesOfLanes<Vector>::Scalar;
    using SlopesOfLanes<Vector>::n_;
    using SlopesOfLanes<Vector>::jacobian_;

    template <class Coupled>
    void get(const Coupled& coupled, std::vector<Scalar>& L) const {
        L.resize(2 * Coupled::stages * n_);
        for (std::size_t j = 0; j < Coupled::stages; ++j) {
            Scalar* const of_stage = L.data() + 2 * j * n_;
            for (std::size_t k = 0; k < n_; ++k) {
                of_stage[k] = coupled.s.Lq[k][j];
                of_stage[n_ + k] = coupled.s.Lp[k][j];
            }
        }
    }

    template <class Coupled>
    void put(const std::vector<Scalar>& L, Coupled& coupled) const {
        for (std::size_t j = 0; j < Coupled::stages; ++j) {
            const Scalar* const of_stage = L.data() + 2 * j * n_;
            for (std::size_t k = 0; k < n_; ++k) {
                coupled.s.Lq[k].set(j, of_stage[k]);
                coupled.s.Lp[k].set(j, of_stage[n_ + k]);
            }
        }
    }

    SquareMatrix<Scalar> Hqq_, Hqp_, Hpp_;
};

/// Newton's method. The factors are kept from step to step while h stays. Where the iteration does
/// not contract with them it begins anew, and then with factors of the present stages.
///
/// NOTE: an iteration that goes on from where old factors have led, or that uses the factors at
/// rest, may come to another solution, far away.
template <class Vector, class Unknowns>
class NewtonOfLanes {
public:
    template <class Coupled>
    [[nodiscard]] Status solve(Coupled& coupled) {
        if (coupled.s.h != coupled.s.h_before) { has_factors_ = false; }
        Status status(Status::Code::singular);
        if (has_factors_) { status = correct(coupled); }
        if (!status.ok()) {
            has_factors_ = false;
            status = correct(coupled);
        }
        has_factors_ = status.ok();
        const bool has_none = status.code() == Status::Code::singular && !unknowns_.is_finite();
        return has_none ? Status(Status::Code::not_finite, status.iterations) : status;
    }

private:
    using Renewal = typename CorrectedSweeps<Vector>::Renewal;

    template <class Coupled>
    [[nodiscard]] Status correct(Coupled& coupled) {
        constexpr int most_iterations = 60;
        unknowns_.rest(coupled);
        if (!has_factors_ && !unknowns_.factorise_start(coupled)) {
            return Status(Status::Code::singular);
        }
        unknowns_.begin(coupled);
        sweeps_.assume_factors(coupled.s.h);
        const Renewal renewal = has_factors_ ? Renewal::never : Renewal::eager;
        return sweeps_.template solve<true>(coupled, unknowns_, {1, 0, most_iterations, renewal});
    }

    Unknowns unknowns_;
    CorrectedSweeps<Vector> sweeps_;
    bool has_factors_ = false;
};

}  // namespace detail

/// Policies for AutomaticOfLanes: Newton's method as the last resort, and the corrections before
/// it.
struct NewtonOfPositionLanes {
    template <class Vector>
    using Iteration = detail::NewtonOfLanes<Vector, detail::PositionsOfLanes<Vector>>;
    template <class Vector>
    using Corrected = detail::CorrectedSweeps<Vector>;
};
struct NewtonOfPairLanes {
    template <class Vector>
    using Iteration = detail::NewtonOfLanes<Vector, detail::PairsOfLanes<Vector>>;
    template <class Vector>
    using Corrected = detail::CorrectedSweeps<Vector>;
};

}  // namespace hvi

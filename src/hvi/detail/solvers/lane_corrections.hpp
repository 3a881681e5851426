// Corrections of the slopes of all stages in lanes, with one Hessian for all of them.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/lanes/lane_products.hpp>
#include <hvi/detail/lanes/lane_tables.hpp>
#include <hvi/detail/lanes/lanes.hpp>
#include <hvi/detail/lanes/mode_lanes.hpp>
#include <hvi/detail/linear/dense.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/solvers/stiffness.hpp>
#include <hvi/detail/stages/system.hpp>

namespace hvi::detail {

/// Hessian of corrections taken between the middle stages, which is nearer to the Hessians of all
/// stages than the one at the start.
struct HessianInTheMiddle {
    template <class Coupled, class... Blocks>
    static void evaluate(const Coupled& coupled, Blocks&... blocks) {
        coupled.hessian_in_the_middle(blocks...);
    }
};

/// Constant terms of all Hessians. Corrections with them solve the linear part of the equations,
/// such as the motion of linear springs. The sweeps lead to the same solution, and their rate does
/// not depend on how stiff the linear part is.
struct ConstantHessian {
    template <class Coupled, class... Blocks>
    static void evaluate(const Coupled& coupled, Blocks&... blocks) {
        coupled.constant_hessian(blocks...);
    }
};

/// Corrections whose factors depend on h alone.
template <class Corrections>
class OfStepSize : public Corrections {
public:
    template <class Coupled>
    [[nodiscard]] bool factorise(const Coupled& coupled) {
        if (has_factors_ && coupled.s.h == h_) { return true; }
        h_ = coupled.s.h;
        has_factors_ = Corrections::factorise(coupled);
        return has_factors_;
    }

private:
    typename Corrections::Scalar h_ = 0;  ///< step size of the factors
    bool has_factors_ = false;
};

/// Simplified Newton for VelocityLanes: Lp -= J^-1 (Lp + h b dH/dq), with J = 1 + h^2 (C x G K) and
/// C_ij = b_i n_ij, where all stages have the G of one state.
///
/// NOTE: the corrected slopes are what the step adds up, as in PairEquations.
template <class Vector, class Hessian, std::size_t stages, class Modes, std::size_t most = widest>
class PositionCorrections {
public:
    using Scalar = ScalarOf<Vector>;

    /// Computes the factors. Returns false where J is singular, nearly so, or not finite.
    template <class Coupled>
    [[nodiscard]] bool factorise(const Coupled& coupled) {
        G_.set_zero(dimension);
        hGK_.set_zero(dimension);
        Hessian::evaluate(coupled, G_);
        set_hGK(coupled, G_, hGK_);
        return modes_.compute(
            [&](std::size_t k, std::size_t l) { return coupled.s.h * hGK_(k, l); });
    }

    /// Sets the slopes at the present stages, and corrects them.
    template <class Coupled>
    void correct(Coupled& coupled) {
        auto& s = coupled.s;
        copy<Lane>(s.Lp, before_);
        coupled.slopes_of_momenta();
        for (std::size_t k = 0; k < dimension; ++k) {
            subtract<Lane>(before_[k], s.Lp[k], residual_[k]);
        }
        modes_.solve(residual_);
        for (std::size_t k = 0; k < dimension; ++k) {
            subtract<Lane>(before_[k], residual_[k], s.Lp[k]);
        }
        s.drifts(coupled.system);
    }

private:
    static constexpr std::size_t dimension = fixed_size<Vector>();
    using Lane = Lanes<Scalar, stages, most>;
    using Slopes = LaneRows<Scalar, stages, dimension>;

    SquareMatrix<Scalar> G_, hGK_;
    ModeLanes<Scalar, stages, dimension, Modes, most> modes_;
    Slopes before_{}, residual_{};
};

/// Simplified Newton for VelocityLanes on the components Coupled::stiff alone. The constant part of
/// their stiffness and the matrix of T are diagonal, so that each component is corrected by itself:
/// Lp_k -= (1 + h^2 omega_k^2 C)^-1 (Lp_k + h b dH/dq_k). The other components are set to -h b
/// dH/dq_k.
template <class Vector, std::size_t stages, std::size_t count, class Modes,
          std::size_t most = widest>
class ComponentCorrections {
public:
    using Scalar = ScalarOf<Vector>;

    /// Computes the matrices for h. Returns false where one is singular, nearly so, or not finite.
    template <class Coupled>
    [[nodiscard]] bool factorise(const Coupled& coupled) {
        std::array<Scalar, count> stiffness;
        coupled.system.stiffness(stiffness);
        for (std::size_t i = 0; i < count; ++i) {
            const Scalar square = coupled.s.h * (coupled.s.h * stiffness[i]);
            if (!one_.compute([&](std::size_t, std::size_t) { return square; })) { return false; }
            for (std::size_t j = 0; j < stages; ++j) {
                LaneRows<Scalar, stages, 1> column{};
                column[0].set(j, Scalar(1));
                one_.solve(column);
                inverse_[i][j] = column[0];
            }
        }
        return true;
    }

    /// Sets the slopes at the present stages, and corrects them.
    template <class Coupled>
    void correct(Coupled& coupled) {
        auto& s = coupled.s;
        for (std::size_t i = 0; i < count; ++i) { Lane(s.Lp[Coupled::stiff[i]]).store(before_[i]); }
        coupled.slopes_of_momenta();
        for (std::size_t i = 0; i < count; ++i) {
            Row& Lp = s.Lp[Coupled::stiff[i]];
            Row residual;
            const Lane before(before_[i]);
            (before - Lane(Lp)).store(residual);
            (before - product(inverse_[i], residual, Lane(Scalar(0)))).store(Lp);
        }
        s.drifts(coupled.system);
    }

private:
    using Lane = Lanes<Scalar, stages, most>;
    using Row = typename Lane::Row;

    ModeLanes<Scalar, stages, 1, Modes, most> one_;
    std::array<LaneMatrix<Scalar, stages>, count> inverse_;
    std::array<Row, count> before_{};
};

/// Simplified Newton for StageLanes: L -= J^-1 (L - slopes), L being Lq and then Lp, J = 1 - h (C x
/// S) with C = diag(b) m, and S = (Hpq Hpp; -Hqq -Hqp) of one state. Precondition: m == mt.
template <class Vector, class Hessian, std::size_t stages, class Modes, std::size_t most = widest>
class PairCorrections {
public:
    using Scalar = ScalarOf<Vector>;

    /// Computes the factors; see PositionCorrections.
    template <class Coupled>
    [[nodiscard]] bool factorise(const Coupled& coupled) {
        for (SquareMatrix<Scalar>* block : {&Hqq_, &Hqp_, &Hpp_}) { block->set_zero(dimension); }
        Hessian::evaluate(coupled, Hqq_, Hqp_, Hpp_);
        const Scalar h = coupled.s.h;
        return modes_.compute([&](std::size_t k, std::size_t l) {
            const bool by_q = l < dimension;
            const std::size_t column = by_q ? l : l - dimension;
            if (k < dimension) { return -(h * (by_q ? Hqp_(column, k) : Hpp_(k, column))); }
            const std::size_t row = k - dimension;
            return h * (by_q ? Hqq_(row, column) : Hqp_(row, column));
        });
    }

    /// Corrects the slopes; see PositionCorrections.
    template <class Coupled>
    void correct(Coupled& coupled) {
        auto& s = coupled.s;
        copy<Lane>(s.Lq, before_q_);
        copy<Lane>(s.Lp, before_p_);
        coupled.all_slopes();
        for (std::size_t k = 0; k < dimension; ++k) {
            subtract<Lane>(before_q_[k], s.Lq[k], residual_[k]);
            subtract<Lane>(before_p_[k], s.Lp[k], residual_[dimension + k]);
        }
        modes_.solve(residual_);
        for (std::size_t k = 0; k < dimension; ++k) {
            subtract<Lane>(before_q_[k], residual_[k], s.Lq[k]);
            subtract<Lane>(before_p_[k], residual_[dimension + k], s.Lp[k]);
        }
    }

private:
    static constexpr std::size_t dimension = fixed_size<Vector>();
    using Lane = Lanes<Scalar, stages, most>;
    using Slopes = LaneRows<Scalar, stages, dimension>;

    SquareMatrix<Scalar> Hqq_, Hqp_, Hpp_;
    ModeLanes<Scalar, stages, 2 * dimension, Modes, most> modes_;
    Slopes before_q_{}, before_p_{};
    LaneRows<Scalar, stages, 2 * dimension> residual_{};
};

}  // namespace hvi::detail

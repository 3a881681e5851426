// What a stepper does and what it leaves out: every decision between a tableau and a header.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "generator/exact/algebra/modes.hpp"
#include "generator/exact/functions/parametric.hpp"
#include "generator/exact/methods/tableau.hpp"
#include "generator/exact/numbers/number.hpp"
#include "generator/stages/stage_node.hpp"

namespace hvi::gen {

/// A stage value, Q or P. Stages with the same value are one: their weights add up.
struct StageValue {
    enum class Place {
        start,  ///< the state that the step begins with: a row of zeros
        inner,
        end,  ///< the state that the step ends with: the row b
    };
    Place place = Place::inner;
    std::vector<std::size_t> stages;  ///< of the tableau, 0-based, that have this value
    Number weight;                    ///< of the slope that is evaluated here
};

/// Nodes that depend on each other and are solved for at once, or a single one that is evaluated.
struct Block {
    bool coupled = false;
    /// By kind, then by index: of Scheme::positions for Q and Lp, of Scheme::momenta for P and Lq.
    std::vector<StageNode> nodes;

    /// The indices of the nodes of one kind, ascending.
    [[nodiscard]] std::vector<std::size_t> of(StageNode::Kind kind) const;
};

/// What is proved of A and A~.
enum class Partner {
    same,       ///< A == A~: then mt == m
    different,  ///< A != A~
    undecided,  ///< neither: enclosures do not tell them apart
};

/// The stages of H = p^T K p/2 + U(q) without their momenta, for v = K p and W_j = h K Lp_j:
///
///     Q_i = q + h c_i v + sum_j n_ij W_j,    n_ij - n_ji = c_i - c_j,
///     q at the end = q + h v + sum_j (1 - c_j) W_j.
///
/// Put (4.18d) into Lq_j = h b_j K P_j and that into (4.18c); with S = m diag(b) m^T there comes
/// c_i = sum_j m_ij b_j and n_ij = c_i - S_ij, and S is symmetric. That condition makes a Nystrom
/// method symplectic, whatever its weights (Hairer, Lubich & Wanner, Geometric Numerical
/// Integration, Theorem IV.2.5 divided by the weights).
struct VelocityForm {
    NumberVector c;  ///< of the positions
    NumberMatrix n;  ///< positions x positions
};

/// How the constructor of a stepper computes the coefficients that depend on a parameter. Places
/// are those in `numbers`; they are empty where there is a constant.
struct FromParameter {
    ParametricNumbers numbers;                          ///< the weights are those of the tableau
    std::vector<std::optional<std::size_t>> positions;  ///< weights of equal stages, in `others`
    std::vector<std::optional<std::size_t>> momenta;
    /// m_ij = others[a] / weights[b].
    struct Ratio {
        std::size_t a;
        std::size_t b;
    };
    std::vector<std::vector<std::optional<Ratio>>> m;
    std::vector<std::optional<std::size_t>> c;  ///< of Scheme::c, in `others`
};

/// Who solves the stage equations.
enum class Solver {
    of_user,        ///< an argument of the class
    fixed_point,    ///< hvi::FixedPoint
    newton,         ///< hvi::NewtonOfPositions where momenta are eliminated, else NewtonOfPairs
    newton_taylor,  ///< hvi::NewtonTaylor
    automatic,      ///< hvi::Automatic: fixed points while they contract, else Newton's method
};

/// What is computed side by side, where a scene says what H is.
enum class Lanes {
    automatic,  ///< stages, where they can be
    stages,     ///< the stages of a step
    ensemble,   ///< trajectories of the same parameters and steps
    none,
};

/// A choice, and why.
struct Decision {
    std::string what;
    std::string why;
};

/// The stages of (4.18) in scaled form,
///
///     Q_i = q + sum_j m_ij Lq_j,    P_j = p + sum_i mt_ji Lp_i,    m_ij + mt_ji = 1,
///
/// with i over `positions`, j over `momenta`, and the order in which they are computed.
struct Scheme {
    bool separable = false;        ///< H = T(p) + U(q): Lq_j needs P_j alone, Lp_i needs Q_i
    bool depends_on_time = false;  ///< so does dH/dq, and where it is not separable dH/dp
    Partner partner = Partner::undecided;
    std::vector<StageValue> positions;
    std::vector<StageValue> momenta;
    NumberVector c;             ///< where H depends on time: T_i = t + c_i h of the positions
    NumberMatrix m;             ///< positions x momenta
    std::vector<Block> blocks;  ///< each needs only what stands before it
    /// Where the momenta are eliminated: the blocks then have no P and no Lq.
    std::optional<VelocityForm> velocity_form;
    Solver solver = Solver::of_user;
    bool has_joint_slopes = false;  ///< one function evaluates dH/dq and dH/dp, for both slopes
    /// Of diag(b) n over the positions that are solved for, for Newton's method; see RealModes.
    std::optional<RealModes> modes;
    bool has_stage_lanes = false;       ///< all stages are computed side by side: see hvi::Lanes
    bool has_trajectory_lanes = false;  ///< trajectories are: see hvi::Trajectories
    bool is_tabulated = false;          ///< a step is one linear map, and nothing is solved
    bool is_sheared = false;            ///< and that is a product of shears where these exist
    bool keeps_force = false;           ///< the last force of a step is the first of the next
    bool keeps_velocity = false;        ///< the same of dH/dp
    /// An explicit step sums its increments apart, and keeps what rounding cuts off from the state.
    bool keeps_remainder = false;
    /// Slopes of the next step from those of this one, for unchanged h: L_i = sum_j N_ij L_j; where
    /// there is `extrapolation_before`, that times those of the step before this one is added.
    std::optional<NumberMatrix> extrapolation;
    std::optional<NumberMatrix> extrapolation_before;
    std::optional<FromParameter> from_parameter;  ///< where a parameter is free
    std::vector<Decision> decisions;

    /// One table of coefficients serves for Q and for P.
    [[nodiscard]] bool one_tableau() const { return partner == Partner::same; }
    /// H is evaluated for several states at once.
    [[nodiscard]] bool has_lanes() const { return has_stage_lanes || has_trajectory_lanes; }
    /// Newton's method may be called for.
    [[nodiscard]] bool takes_newton() const;
    /// No equations to solve: kicks and drifts in turn.
    [[nodiscard]] bool is_explicit() const;
    [[nodiscard]] std::size_t coupled_blocks() const;
    /// Evaluations of dH/dq and of dH/dp in a step that needs no solver, kept ones not counted.
    [[nodiscard]] std::size_t forces_evaluated() const;
    [[nodiscard]] std::size_t velocities_evaluated() const;
};

/// The scheme as stable text, for people and tests.
[[nodiscard]] std::string dump(const Scheme& scheme);

}  // namespace hvi::gen

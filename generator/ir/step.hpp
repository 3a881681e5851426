// The work of a step, and what it leaves out: every decision between a method and a header.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "generator/exact/algebra/modes.hpp"
#include "generator/exact/methods/galerkin_form.hpp"
#include "generator/exact/numbers/formats.hpp"
#include "generator/exact/numbers/number.hpp"
#include "generator/exact/parameters/parametric.hpp"
#include "generator/ir/properties.hpp"
#include "generator/stages/stage_node.hpp"

namespace hvi::gen {

// ---- stages ----

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
    /// Sorted by kind, then by index: of Step::positions for Q and Lp, of Step::momenta for P and
    /// Lq.
    std::vector<StageNode> nodes;

    /// The indices of the nodes of one kind, ascending.
    [[nodiscard]] std::vector<std::size_t> of(StageNode::Kind kind) const;

    friend bool operator==(const Block&, const Block&) = default;
};

/// The proof about A and A~.
enum class Partner {
    same,       ///< A == A~: then mt == m
    different,  ///< A != A~
    undecided,  ///< neither: enclosures do not tell them apart
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
    std::vector<std::optional<std::size_t>> c;  ///< of Step::c, in `others`
};

/// Which functions of H give its slopes.
enum class Slopes {
    of_parts,    ///< dH/dq(q) and dH/dp(p): H = T(p) + U(q)
    one_by_one,  ///< dH/dq(q, p) and dH/dp(q, p)
    joint,       ///< both at once, for both slopes of a stage
};

/// The last slopes of a step that are the first ones of the next.
struct KeptSlopes {
    bool force = false;     ///< dH/dq
    bool velocity = false;  ///< dH/dp

    [[nodiscard]] bool any() const { return force || velocity; }
};

// ---- forms ----

/// The tables m and mt of a step, with m[i][j] + mt[j][i] == 1 without rounding, in each format.
/// Empty where m_ij depends on a parameter.
struct RoundedCoefficients {
    RoundedMatrix m;
    RoundedMatrix mt;
};

/// X, A, D and B of a step with
///
///     Q_i = q + sum_j A_ij W_j,          sum_j X_ij W_j = h b_i dH/dp(Q_i, P_i),
///     sum_i X_ij P_i = B_j p + sum_i D_ij Lp_i,
///
/// rounded so that A_ij + D_ij == B_j and the sum of X_ij over i is B_j, in each format.
struct RoundedGalerkinForm {
    RoundedMatrix X;  ///< nodes x functions, b_i phi_ij
    RoundedMatrix A, D;
    std::vector<Rounded> B;
};

/// How an explicit step sums its increments.
enum class Sums {
    plain,
    compensated,  ///< apart, and what rounding cuts off from the state is kept
};

/// Kicks and drifts in turn; nothing is solved.
struct ExplicitStep {
    Sums sums = Sums::plain;
};

/// Flows of parts of H in turn, each exact; nothing is solved.
struct FlowStep {
    /// Things that the flows move.
    enum class Moving {
        numbers,
        bodies,  ///< these, and bodies that turn
    };
    /// The flow of a part over a fraction of h.
    struct Move {
        std::size_t part;
        std::size_t fraction;  ///< among the fractions of its part
    };
    /// Moves in a row, and that so many times.
    struct Round {
        std::vector<Move> moves;
        std::size_t times = 1;
    };
    std::vector<NumberVector> fractions;  ///< of each part, each value once
    std::vector<Round> rounds;
    Moving moving = Moving::numbers;
    /// Fraction, among those of its part, of the last flow of a step and the first one of the next
    /// at once, where both are of one part.
    std::optional<std::size_t> joined = {};
    std::optional<std::size_t> clock = {};  ///< part with whose flow the time goes on

    /// Returns the rounds without the first flow and the last one. Precondition: these are joined.
    [[nodiscard]] std::vector<Round> between() const;
    /// Returns how many flows of each part there are in a step.
    [[nodiscard]] std::vector<std::size_t> counts() const;
    /// Returns how many flows there are in a step.
    [[nodiscard]] std::size_t flows() const;
};

/// The general Galerkin form, of one step or of several in a row.
struct TabulatedCurve {
    GalerkinForm form;
    RoundedGalerkinForm rounded;
    NumberVector steps;  ///< of a composition: gamma_1, ..., gamma_k; else empty
};

/// One linear map, computed when h changes.
struct TabulatedStep {
    enum class As { shears, matrix } as = As::shears;  ///< a product of shears where these exist
    /// Tables that the map is computed from. For a curve the blocks of the step are one, and there
    /// are no `momenta`.
    std::variant<RoundedCoefficients, TabulatedCurve> tables = {};
};

/// Who solves the stage equations.
enum class Solver {
    of_user,        ///< an argument of the class
    fixed_point,    ///< hvi::FixedPoint
    newton,         ///< hvi::NewtonOfPositions where momenta are eliminated, NewtonOfCurves for the
                    ///< general Galerkin form, NewtonOfCharts for rotations, else NewtonOfPairs
    newton_taylor,  ///< hvi::NewtonTaylor
    automatic,      ///< hvi::Automatic: fixed points while they contract, else Newton's method
    sweeps,         ///< hvi::FixedSweeps: so many sweeps of fixed points, see Iteration::sweeps
};

inline constexpr int most_sweeps = 100;

/// Slopes of a step from those of the last one: L_i = sum_j N_ij L_j, with N in `last`; where there
/// is `before`, that times those of the step before the last one is added. Of h unchanged.
struct Extrapolation {
    NumberMatrix last;
    std::optional<NumberMatrix> before;
};

/// How stage equations are solved.
struct Iteration {
    Solver solver = Solver::of_user;
    int sweeps = 0;  ///< of Solver::sweeps; else 0
    /// Starting values of each of the steps in a row, or of the one step; empty: it begins with
    /// slopes at the start.
    std::vector<Extrapolation> extrapolation;

    /// Newton's method may be called for.
    [[nodiscard]] bool takes_newton() const;
    /// Fixed points are iterated, and nothing else.
    [[nodiscard]] bool only_sweeps() const;
    /// Sweeps are counted, not ended at round-off: steps are symplectic up to the last change.
    [[nodiscard]] bool counts_sweeps() const { return solver == Solver::sweeps; }
    /// Slopes are extrapolated to steps of several sizes.
    [[nodiscard]] bool takes_parts() const { return extrapolation.size() > 1; }
};

/// Slopes of all stages, of positions and momenta, are computed and kept through the step.
struct PairStep {
    std::optional<Iteration> iteration;  ///< none where no stage depends on itself
    RoundedCoefficients coefficients = {};
};

/// The stages of H = p^T K p/2 + U(q) without their momenta, for v = K p and W_j = h K Lp_j:
///
///     Q_i = q + h c_i v + sum_j n_ij W_j,    n_ij - n_ji = c_i - c_j,
///     q at the end = q + h v + sum_j (1 - c_j) W_j.
///
/// Put (4.18d) into Lq_j = h b_j K P_j and that into (4.18c); with S = m diag(b) m^T there comes
/// c_i = sum_j m_ij b_j and n_ij = c_i - S_ij, and S is symmetric. That condition makes a Nystrom
/// method symplectic, whatever its weights (Hairer, Lubich & Wanner, Geometric Numerical
/// Integration, Theorem IV.2.5 divided by the weights). The general Galerkin form has the same, see
/// GalerkinRule.
struct VelocityForm {
    NumberVector c;  ///< of the positions
    NumberMatrix n;  ///< positions x positions
};

/// c and n with n[i][j] - n[j][i] == c[i] - c[j] without rounding, in each format.
struct RoundedVelocityForm {
    std::vector<Rounded> c;
    RoundedMatrix n;
};

/// Positions alone are solved for: the blocks of the step have no P and no Lq.
struct VelocityStep {
    VelocityForm form;
    RoundedVelocityForm rounded;
    Iteration iteration;
    bool has_diagonal_mass = false;            ///< each momentum moves its own position alone
    HessianForm hessian = HessianForm::dense;  ///< for Newton's method
    /// Modes of diag(b) n over the positions that are solved for, for Newton's method.
    std::optional<RealModes> modes;
};

/// W and P of the next step from those of this one, for unchanged h: W_j = sum_k W_jk W_k, and
/// P_i = sum_k P_ik P_k.
struct CurveExtrapolation {
    NumberMatrix W;                 ///< functions x functions
    std::optional<NumberMatrix> P;  ///< nodes x nodes; none for an L, where no P is solved for
};

/// The general Galerkin form (4.6) for any H, or (4.14) for an L, where the W_j alone are solved
/// for and P_i = dL/dv. The blocks of the step are one, and there are no `momenta`, as the P_i are
/// as many as the positions.
struct GalerkinStep {
    Side side = Side::hamiltonian;
    GalerkinForm form;
    RoundedGalerkinForm rounded;
    Iteration iteration;  ///< without extrapolation of slopes
    std::optional<CurveExtrapolation> extrapolation;
    /// Every second one of the steps of a composition is a step of the adjoint, which is another
    /// one: A and D change places, and c_i is 1 - c_i.
    bool has_adjoint = false;
};

/// The stages of (4.18) in the natural chart of SO(3) at the rotations that the step begins with
/// (Section 5.4), and of coordinates as they are; all of them are solved for at once, with the
/// momenta of the charts. See hvi::detail::ChartStages.
struct ChartStep {
    Iteration iteration;
    RoundedCoefficients coefficients = {};
};

/// The content of the lanes of the processor.
enum class Layout {
    one,           ///< nothing: a number is a number
    stages,        ///< all stages of a step: see hvi::Lanes
    trajectories,  ///< trajectories: see hvi::Trajectories
    threads,       ///< nothing: a trajectory is a thread of a GPU, see hvi/device.hpp
    components,    ///< components of vectors of any size
    sites,         ///< sites of a lattice, over which all moves of a step sweep at once
};

inline constexpr std::size_t widest_register = 8;  ///< numbers

/// Costs of the ways to solve for the stages, in operations on registers of four lanes; see
/// SolverCosts of the runtime.
struct SolverCosts {
    int sweep = 0, linear = 0, correction = 0, factors = 0;

    friend bool operator==(const SolverCosts&, const SolverCosts&) = default;
};

/// Newton's corrections of all slopes at once, with one Hessian.
struct StageCorrections {
    RealModes modes;         ///< of diag(b) n, or of diag(b) m; Newton's method has them from here
    LinearPart linear = {};  ///< is solved exactly in each sweep
    SolverCosts costs = {};
};

/// Things that a step moves beside the state.
enum class Carries {
    nothing,
    directions,  ///< any number of them, by its derivative, with the stages of (q, p) or its flows
};

/// A choice, and why.
struct Decision {
    std::string what;
    std::string why;

    friend bool operator==(const Decision&, const Decision&) = default;
};

// ---- the record ----

/// The stages of (4.18) in scaled form,
///
///     Q_i = q + sum_j m_ij Lq_j,    P_j = p + sum_i mt_ji Lp_i,    m_ij + mt_ji = 1,
///
/// with i over `positions`, j over `momenta`, and the order and the form in which they are
/// computed.
struct Step {
    Slopes slopes = Slopes::one_by_one;
    Partner partner = Partner::undecided;
    std::vector<StageValue> positions;
    std::vector<StageValue> momenta;
    NumberVector c;             ///< where H depends on time: T_i = t + c_i h of the positions
    NumberMatrix m;             ///< positions x momenta; empty rows where there are no momenta
    std::vector<Block> blocks;  ///< each needs only what stands before it
    KeptSlopes kept;
    std::optional<FromParameter> from_parameter;  ///< where a parameter is free
    std::variant<ExplicitStep, FlowStep, TabulatedStep, PairStep, VelocityStep, GalerkinStep,
                 ChartStep>
        form;
    /// The sizes gamma_1, ..., gamma_k of a composition whose steps are taken one after the other,
    /// where this is one of them. Else empty: all that a step does is here.
    NumberVector in_a_row;
    Layout layout = Layout::one;
    Container container = Container::of_user;
    /// Corrections of stages in lanes whose solver is automatic; none where the stages do not
    /// decouple.
    std::optional<StageCorrections> corrections = {};
    /// How many numbers go into a register, of stages in lanes.
    std::size_t register_width = widest_register;
    /// How many values dH/dp takes from the dH/dq before it, of stages in lanes.
    std::size_t shared_slopes = 0;
    Carries carries = Carries::nothing;
    /// Derivatives beside each number, where steps are computed in dual numbers, which carry as
    /// many directions along; else 0.
    std::size_t dual_parts = 0;
    std::vector<Decision> decisions;

    [[nodiscard]] bool is_separable() const { return slopes == Slopes::of_parts; }
    /// dH/dq does, and dH/dp where it is not separable.
    [[nodiscard]] bool depends_on_time() const;
    /// No equations to solve.
    [[nodiscard]] bool is_explicit() const { return coupled_blocks() == 0; }
    [[nodiscard]] std::size_t coupled_blocks() const;
    /// Null where no equations are iterated.
    [[nodiscard]] const Iteration* iteration() const;
    [[nodiscard]] bool has_lanes() const {
        return layout == Layout::stages || layout == Layout::trajectories;
    }
    /// Whether a stepper takes several trajectories, which are all iterated alike.
    [[nodiscard]] bool takes_several() const {
        return layout == Layout::trajectories || layout == Layout::threads;
    }
    /// Evaluations of dH/dq and of dH/dp in a step that needs no solver, kept ones not counted.
    [[nodiscard]] std::size_t forces_evaluated() const;
    [[nodiscard]] std::size_t velocities_evaluated() const;
    /// Values that are solved for at once, each of as many components as there are degrees of
    /// freedom.
    [[nodiscard]] std::size_t unknowns() const;
};

/// Stable text, for people and tests.
[[nodiscard]] std::string dump(const Step& step);

/// Stops the program (HVI_CHECK) where the record contradicts itself: tables that do not fit, a
/// block that needs what comes after it, a form without what it is made of.
void verify(const Step& step);

/// Whether the texts are: closed forms of coefficients are compared as they are, numbers without
/// one to 50 digits. Steps of different fields have no common arithmetic.
[[nodiscard]] bool operator==(const Step& left, const Step& right);

}  // namespace hvi::gen

// The forms of stage equations, as parts of one header.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <string>

#include "generator/emit/steps/header.hpp"

namespace hvi::gen {

/// Parts of the header; see templates/implicit.hpp.in.
struct ImplicitParts {
    std::vector<std::string> runtime;  ///< headers of hvi that not every stepper includes
    std::string steps, constants, predict, coupled, members;
    std::string curve;             ///< position(tau) and momentum(tau); empty where not asked for
    std::string action, integral;  ///< members of the action; empty where not asked for
};

/// Returns the parts for stages of positions and momenta, or of positions alone.
[[nodiscard]] ImplicitParts parts(const Step& step, const PairStep& form,
                                  const SceneWishes& wishes);
[[nodiscard]] ImplicitParts parts(const Step& step, const VelocityStep& form,
                                  const SceneWishes& wishes);
/// Returns the parts for a curve and the momenta along it.
[[nodiscard]] ImplicitParts parts(const Step& step, const GalerkinStep& form,
                                  const SceneWishes& wishes);

/// Returns the parts for (4.14). Precondition: the side is the Lagrangian one.
[[nodiscard]] ImplicitParts lagrangian_parts(const Step& step, const GalerkinStep& form,
                                             const SceneWishes& wishes);

/// Returns the parts for stages in lanes.
[[nodiscard]] ImplicitParts lane_parts(const Step& step, const PairStep& form,
                                       const SceneWishes& wishes);
[[nodiscard]] ImplicitParts lane_parts(const Step& step, const VelocityStep& form,
                                       const SceneWishes& wishes);

// ---- texts that the parts are made of ----

/// Returns the lines that include these headers, and those that each header with the runtime
/// includes.
[[nodiscard]] std::string runtime_includes(std::vector<std::string> names);

/// Returns the headers of hvi with the solver of the step.
[[nodiscard]] std::vector<std::string> solver_headers(const Step& step, SeldomSolvers seldom);

/// Writes a table with each entry rounded on its own: for starting values, and for the steps of an
/// iteration.
void rough_table(Writer& writer, std::string_view name, const NumberMatrix& exact);
/// Writes a row of numbers rounded one by one. `formula` names the entries in comments.
void rough_table(Writer& writer, std::string_view name, std::string_view formula,
                 const NumberVector& exact);

/// Returns the table of the parts of a composition; empty where there is none.
[[nodiscard]] std::string gamma_table(const NumberVector& steps);

/// Returns the tables of either form.
[[nodiscard]] std::string constants_text(const Step& step, const PairStep& form,
                                         const SceneWishes& wishes);
[[nodiscard]] std::string constants_text(const Step& step, const VelocityStep& form,
                                         const SceneWishes& wishes);

/// Returns the members for Newton's method beside forces and positions: see
/// hvi::detail::PositionEquations. `drifts` is the body of the function that computes W_j = h K
/// Lp_j of the unknown.
[[nodiscard]] std::string newton_of_positions(const Step& step, const VelocityStep& form,
                                              const std::vector<std::size_t>& unknown,
                                              std::string_view drifts);

/// Returns the members with dH/dq at the start of the step, and d2H/dq2 there and at stages.
[[nodiscard]] std::string linearised(const Step& step);

/// Returns `true` or `false`.
[[nodiscard]] constexpr std::string_view truth(bool value) { return value ? "true" : "false"; }

/// Returns whether the slope is kept in `force_` or `velocity_`.
[[nodiscard]] bool is_kept(const Step& step, const StageNode& slope);

/// Returns the arguments that a struct of stage equations takes before s_: `system_, `.
[[nodiscard]] std::string coupled_arguments(const Step& step);

/// Returns the last expression of step(): the status.
[[nodiscard]] std::string end_of_step(const Step& step, std::string_view iterations);

/// Returns entries of a matrix as constants of a table.
[[nodiscard]] std::vector<std::vector<Constant>>
constants(std::string_view name, const NumberMatrix& exact, const RoundedMatrix& values);

/// Returns the weights and the tables m and mt, as lines of the class.
[[nodiscard]] std::string coefficients_text(const Step& step,
                                            const RoundedCoefficients& coefficients);

/// Returns the table `curve`, the distance of the curve from its chord for each of the slopes that
/// the step keeps, and `curve_p` for momenta, except those of rotations. Empty for a straight line.
/// Functions are those of the namespace `library`.
[[nodiscard]] std::string curve_table(const Step& step, const Curve& curve,
                                      std::string_view library);

/// Returns the members position(tau) and momentum(tau). `chord` is the increment of q, `slopes` has
/// component k of each slope in the table, and `kicks` component k of each Lp_i, which add up to
/// the increment of p.
[[nodiscard]] std::string curve_text(const Step& step, const Curve& curve, std::string_view chord,
                                     const std::vector<std::string>& slopes,
                                     const std::vector<std::string>& kicks);

/// Return `s_.Lp[0][k]` and so on, and in lanes `s_.Lp[static_cast<std::size_t>(k)][0]`.
[[nodiscard]] std::vector<std::string> slopes_in_rows(std::string_view slope, std::size_t count);
[[nodiscard]] std::vector<std::string> slopes_in_lanes(std::string_view slope, std::size_t count);

/// Adds the members generating_function() and action(), and the private member integral_over_step()
/// behind them: p dq - H dt, summed over the stages. For pairs it takes x, which the step has not
/// moved yet.
void add_action(ImplicitParts& parts, const Step& step, const PairStep& form);
void add_action(ImplicitParts& parts, const Step& step, const GalerkinStep& form);

/// Returns the last lines of step() with an action: `integral` is the call, `end` the status.
[[nodiscard]] std::string end_with_action(std::string_view integral, std::string_view end);

/// Returns the struct `name` of the equations of Newton's method, for a matrix C, given as text.
[[nodiscard]] std::string modes_text(const std::optional<RealModes>& modes, std::string_view name,
                                     std::string_view C, std::size_t indent);

/// Returns "The stage equations of Q_1, P_1, which are solved at once."
[[nodiscard]] std::string unknowns(const Block& block);

}  // namespace hvi::gen

// The two forms of stage equations, as parts of one header.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <string>

#include "generator/emit/steps/header.hpp"

namespace hvi::gen {

/// See templates/implicit.hpp.in.
struct ImplicitParts {
    std::vector<std::string> runtime;  ///< headers of hvi that not every one includes
    std::string steps, constants, predict, coupled, members;
    std::string curve;             ///< empty where none is asked for
    std::string action, integral;  ///< the same
};

/// Positions and momenta, and positions alone.
[[nodiscard]] ImplicitParts parts(const Step& step, const PairStep& form,
                                  const SceneWishes& wishes);
[[nodiscard]] ImplicitParts parts(const Step& step, const VelocityStep& form,
                                  const SceneWishes& wishes);
/// A curve and the momenta along it.
[[nodiscard]] ImplicitParts parts(const Step& step, const GalerkinStep& form,
                                  const SceneWishes& wishes);

/// (4.14). Precondition: the side is the Lagrangian one.
[[nodiscard]] ImplicitParts lagrangian_parts(const Step& step, const GalerkinStep& form,
                                             const SceneWishes& wishes);

/// The same, with the stages in lanes.
[[nodiscard]] ImplicitParts lane_parts(const Step& step, const PairStep& form,
                                       const SceneWishes& wishes);
[[nodiscard]] ImplicitParts lane_parts(const Step& step, const VelocityStep& form,
                                       const SceneWishes& wishes);

// ---- what they are made of ----

/// The lines that include what every header that needs the runtime includes, and these.
[[nodiscard]] std::string runtime_includes(std::vector<std::string> names);

/// The headers of hvi with the solver of the step.
[[nodiscard]] std::vector<std::string> solver_headers(const Step& step, SeldomSolvers seldom);

/// Each entry rounded on its own: for starting values, and for the way to a solution.
void rough_table(Writer& writer, std::string_view name, const NumberMatrix& exact);
/// `formula` is what comments call the entries.
void rough_table(Writer& writer, std::string_view name, std::string_view formula,
                 const NumberVector& exact);

/// The parts of a composition; empty where there is none.
[[nodiscard]] std::string gamma_table(const NumberVector& steps);

/// The tables of either form.
[[nodiscard]] std::string constants_text(const Step& step, const PairStep& form,
                                         const SceneWishes& wishes);
[[nodiscard]] std::string constants_text(const Step& step, const VelocityStep& form,
                                         const SceneWishes& wishes);

/// What Newton's method asks for beside forces and positions: see hvi::detail::PositionEquations.
/// `drifts` is the body of the function that computes W_j = h K Lp_j of the unknown.
[[nodiscard]] std::string newton_of_positions(const Step& step, const VelocityStep& form,
                                              const std::vector<std::size_t>& unknown,
                                              std::string_view drifts);

/// Of these dH/dq at the start of the step, and d2H/dq2 there and at stages.
[[nodiscard]] std::string linearised(const Step& step);

/// Whether it is `true` or `false`, as C++ says it.
[[nodiscard]] constexpr std::string_view truth(bool value) { return value ? "true" : "false"; }

/// Whether the slope is at hand in `force_` or `velocity_`.
[[nodiscard]] bool is_kept(const Step& step, const StageNode& slope);

/// What a struct of stage equations is made with, before s_: `system_, `.
[[nodiscard]] std::string coupled_arguments(const Step& step);

/// The last expression of step(): the status.
[[nodiscard]] std::string end_of_step(const Step& step, std::string_view iterations);

/// Entries of a matrix as constants of a table.
[[nodiscard]] std::vector<std::vector<Constant>>
constants(std::string_view name, const NumberMatrix& exact, const RoundedMatrix& values);

/// The weights and the tables m and mt, as lines of the class.
[[nodiscard]] std::string coefficients_text(const Step& step,
                                            const RoundedCoefficients& coefficients);

/// The table `curve`: by how much the curve departs from its chord, for each of the slopes that the
/// step keeps; and `curve_p` for momenta, but of rotations. Empty for a straight line. Functions
/// are those of the namespace `library`.
[[nodiscard]] std::string curve_table(const Step& step, const Curve& curve,
                                      std::string_view library);

/// The members position(tau) and momentum(tau). `chord` is the increment of q, `slopes` component k
/// of those that the table is for, and `kicks` that of each Lp_i, which add up to the increment of
/// p.
[[nodiscard]] std::string curve_text(const Step& step, const Curve& curve, std::string_view chord,
                                     const std::vector<std::string>& slopes,
                                     const std::vector<std::string>& kicks);

/// `s_.Lp[0][k]` and so on, and in lanes `s_.Lp[static_cast<std::size_t>(k)][0]`.
[[nodiscard]] std::vector<std::string> slopes_in_rows(std::string_view slope, std::size_t count);
[[nodiscard]] std::vector<std::string> slopes_in_lanes(std::string_view slope, std::size_t count);

/// Adds the members generating_function() and action(), and the private one that they are made of,
/// integral_over_step(): p dq - H dt, summed over the stages. That of pairs takes x, which the step
/// has not moved yet.
void add_action(ImplicitParts& parts, const Step& step, const PairStep& form);
void add_action(ImplicitParts& parts, const Step& step, const GalerkinStep& form);

/// The last lines of step() with an action: `integral` is the call, `end` the status.
[[nodiscard]] std::string end_with_action(std::string_view integral, std::string_view end);

/// The struct `name` of the equations of Newton's method, of a matrix C, given as text.
[[nodiscard]] std::string modes_text(const std::optional<RealModes>& modes, std::string_view name,
                                     std::string_view C, std::size_t indent);

/// "The stage equations of Q_1, P_1, which are solved at once."
[[nodiscard]] std::string unknowns(const Block& block);

}  // namespace hvi::gen

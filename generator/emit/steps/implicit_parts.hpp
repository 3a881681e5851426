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
    std::string curve;  ///< empty where none is asked for
};

/// Positions and momenta.
[[nodiscard]] ImplicitParts pair_parts(const Scheme& scheme, const SceneWishes& wishes);

/// Positions alone. Precondition: scheme.velocity_form.
[[nodiscard]] ImplicitParts velocity_parts(const Scheme& scheme, const SceneWishes& wishes);

/// One of these, with the stages in lanes. Precondition: scheme.has_stage_lanes.
[[nodiscard]] ImplicitParts lane_parts(const Scheme& scheme, const SceneWishes& wishes);

// ---- what they are made of ----

/// The lines that include what every header that needs the runtime includes, and these.
[[nodiscard]] std::string runtime_includes(std::vector<std::string> names);

/// The tables of either form.
[[nodiscard]] std::string pair_constants(const Scheme& scheme, const SceneWishes& wishes);
[[nodiscard]] std::string velocity_constants(const Scheme& scheme, const SceneWishes& wishes);

/// What Newton's method asks for beside forces and positions: see hvi::detail::PositionEquations.
/// `drifts` is the body of the function that computes W_j = h K Lp_j of the unknown.
[[nodiscard]] std::string newton_of_positions(const Scheme& scheme,
                                              const std::vector<std::size_t>& unknown,
                                              std::string_view drifts);

/// Whether it is `true` or `false`, as C++ says it.
[[nodiscard]] constexpr std::string_view truth(bool value) { return value ? "true" : "false"; }

/// Whether the slope is at hand in `force_` or `velocity_`.
[[nodiscard]] bool is_kept(const Scheme& scheme, const StageNode& slope);

/// What a struct of stage equations is made with, before s_: `system_, `.
[[nodiscard]] std::string coupled_arguments(const Scheme& scheme);

/// The last expression of step(): the status.
[[nodiscard]] std::string end_of_step(const Scheme& scheme, std::string_view iterations);

/// Entries of a matrix as constants of a table.
[[nodiscard]] std::vector<std::vector<Constant>>
constants(std::string_view name, const NumberMatrix& exact, const RoundedMatrix& values);

/// The weights and the tables m and mt, as lines of the class.
[[nodiscard]] std::string coefficients_text(const Scheme& scheme);

/// The table `curve`: by how much the curve departs from its chord, for each of the slopes that the
/// step keeps. Empty for a straight line. Functions are those of the namespace `library`.
[[nodiscard]] std::string curve_table(const Scheme& scheme, const Curve& curve,
                                      std::string_view library);

/// The member position(tau). `chord` is the increment of the step, and `slope(i)` component k of
/// slope i of those that the table is for.
[[nodiscard]] std::string curve_text(const Scheme& scheme, const Curve& curve,
                                     std::string_view chord,
                                     const std::function<std::string(std::size_t)>& slope);

/// `struct Modes` of the equations of Newton's method.
[[nodiscard]] std::string modes_text(const Scheme& scheme);

/// "The stage equations of Q_1, P_1, which are solved at once."
[[nodiscard]] std::string unknowns(const Block& block);

}  // namespace hvi::gen

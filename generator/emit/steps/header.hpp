// The kinds of headers, and the pieces that they share.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/emit/steps/emit.hpp"
#include "generator/emit/text/constants.hpp"
#include "generator/emit/text/text.hpp"

namespace hvi::gen {

// Headers for one trajectory. Precondition of each: step.form is `form`.
[[nodiscard]] std::string emit_one(const OneStepMethod& method, const Step& step,
                                   const ExplicitStep& form, const EmitOptions& options);
[[nodiscard]] std::string emit_one(const OneStepMethod& method, const Step& step,
                                   const FlowStep& form, const EmitOptions& options);
[[nodiscard]] std::string emit_one(const OneStepMethod& method, const Step& step,
                                   const TabulatedStep& form, const EmitOptions& options);
[[nodiscard]] std::string emit_one(const OneStepMethod& method, const Step& step,
                                   const PairStep& form, const EmitOptions& options);
[[nodiscard]] std::string emit_one(const OneStepMethod& method, const Step& step,
                                   const VelocityStep& form, const EmitOptions& options);
[[nodiscard]] std::string emit_one(const OneStepMethod& method, const Step& step,
                                   const GalerkinStep& form, const EmitOptions& options);

[[nodiscard]] std::string emit_one(const OneStepMethod& method, const Step& step,
                                   const ChartStep& form, const EmitOptions& options);

/// Class of Newton's method for a step that solves equations, and its header in detail/solvers.
struct NewtonPolicy {
    std::string header, type;
};
[[nodiscard]] NewtonPolicy newton_policy(const Step& step);

/// Returns the header for trajectories side by side.
[[nodiscard]] std::string emit_ensemble(const OneStepMethod& method, const Step& step,
                                        const EmitOptions& options);

/// Returns the header for trajectories that are threads of a GPU.
[[nodiscard]] std::string emit_threads(const OneStepMethod& method, const Step& step,
                                       const EmitOptions& options);

/// Returns the header for kicks and drifts that sweep over the sites of a lattice.
[[nodiscard]] std::string emit_sites(const OneStepMethod& method, const Step& step,
                                     const EmitOptions& options);

/// Returns the tables of the weights b_p of kicks and b_q of drifts; see Move.
[[nodiscard]] std::string weights_text(const Step& step);

/// Return the weights of slopes, named after the stages of the tableau: b_1, or b_1+b_2 for merged
/// ones. Precondition: no free parameter.
[[nodiscard]] Constant weight(const StageValue& value);
[[nodiscard]] std::vector<Constant> weights(const std::vector<StageValue>& values);

/// Returns a struct with the stage equations of a block; see templates/coupled.hpp.in.
[[nodiscard]] std::string coupled(const Step& step, const Block& block, std::string_view name);

/// Returns whether stages with the same Q or P were made one.
[[nodiscard]] bool is_merged(const Step& step);

/// Return the tables of the weights of Lq and of Lp: one table `b` when no stages were merged.
[[nodiscard]] std::string weights_q(const Step& step);
[[nodiscard]] std::string weights_p(const Step& step);
/// Returns the table of the coefficients of P: m where A == A~.
[[nodiscard]] std::string_view table_mt(const Step& step);

/// Returns the prefix of a table's name: empty, or the object that holds the coefficients of one
/// value of a parameter, in the stepper (`s` is s_) and in its structs.
[[nodiscard]] std::string_view owner(const Step& step, std::string_view s);

/// Returns the struct Coefficients of one value of a parameter, and access to one. This text and
/// the next ones are empty where no parameter is free.
[[nodiscard]] std::string parameter_text(const Step& step);
/// Return the line that declares the member of type Coefficients, and the line of a reference to
/// it.
[[nodiscard]] std::string coefficients_member(const Step& step);
[[nodiscard]] std::string coefficients_reference(const Step& step);
/// Returns `coefficients_, ` among the arguments of a struct of stage equations.
[[nodiscard]] std::string_view coefficients_argument(const Step& step);
/// Returns the struct Functions, whose quotients are the coefficients. Precondition:
/// from_parameter.
[[nodiscard]] std::string functions_of_parameter(const Step& step);
/// Returns the first lines of step(): there may be no method, or no system of the size of x.
[[nodiscard]] std::string begins(const Step& step);

/// Return Q_i[k], and P_j[k], as sums of the slopes in `s`.
[[nodiscard]] std::string moved_position(const Step& step, std::size_t i, std::string_view s);
[[nodiscard]] std::string moved_momentum(const Step& step, std::size_t j, std::string_view s);

/// Return the call of the system, without its name, that puts the slope without its factor into
/// `slope`.
[[nodiscard]] std::string evaluate_velocity(const Step& step, std::size_t j, std::string_view s);
[[nodiscard]] std::string evaluate_force(const Step& step, std::size_t i, std::string_view s);

/// Return the factor h b_j of Lq_j, and -h b_i of Lp_i; without b where the weight is 1.
[[nodiscard]] std::string velocity_factor(const Step& step, std::size_t j, std::string_view s);
[[nodiscard]] std::string force_factor(const Step& step, std::size_t i, std::string_view s);

/// Returns whether the products of h and the weights are rounded, together; see
/// src/hvi/detail/coefficients/weights.hpp.
[[nodiscard]] bool rounds_weights(const Step& step);

}  // namespace hvi::gen

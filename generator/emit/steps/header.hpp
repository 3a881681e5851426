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

[[nodiscard]] std::string emit_explicit(const Tableau& tableau, const Scheme& scheme,
                                        const EmitOptions& options);
[[nodiscard]] std::string emit_linear(const Tableau& tableau, const Scheme& scheme,
                                      const EmitOptions& options);
[[nodiscard]] std::string emit_implicit(const Tableau& tableau, const Scheme& scheme,
                                        const EmitOptions& options);

[[nodiscard]] std::string emit_ensemble(const Tableau& tableau, const Scheme& scheme,
                                        const EmitOptions& options);

/// The weights b_p of kicks and b_q of drifts, as tables; see Move.
[[nodiscard]] std::string weights_text(const Scheme& scheme);

/// The weights of slopes, named after the stages of the tableau: b_1, or b_1+b_2 of merged ones.
/// Precondition: no free parameter.
[[nodiscard]] Constant weight(const StageValue& value);
[[nodiscard]] std::vector<Constant> weights(const std::vector<StageValue>& values);

/// One struct with the stage equations of a block; see templates/coupled.hpp.in.
[[nodiscard]] std::string coupled(const Scheme& scheme, const Block& block, std::string_view name);

/// Where the weights of the slopes Lq and Lp stand: one table `b` when no stages were merged.
[[nodiscard]] std::string weights_q(const Scheme& scheme);
[[nodiscard]] std::string weights_p(const Scheme& scheme);
/// Where the coefficients of P stand: m serves for both where A == A~.
[[nodiscard]] std::string_view table_mt(const Scheme& scheme);

/// What stands before the name of a table: nothing, or the object that holds the coefficients of
/// one value of a parameter, in the stepper (`s` is s_) and in its structs.
[[nodiscard]] std::string_view owner(const Scheme& scheme, std::string_view s);

/// The struct Coefficients of one value of a parameter, and how to look at one. These are empty
/// where no parameter is free.
[[nodiscard]] std::string parameter_text(const Scheme& scheme);
/// The struct Functions, of which coefficients are quotients. Precondition: from_parameter.
[[nodiscard]] std::string functions_of_parameter(const Scheme& scheme);
/// What step() does first: there may be no method.
[[nodiscard]] std::string begins(const Scheme& scheme);

/// Q_i[k] = ... without the leading name: q + (e + (...)), of the slopes in `s`.
[[nodiscard]] std::string position_sum(const Scheme& scheme, std::size_t i, std::string_view s);
[[nodiscard]] std::string momentum_sum(const Scheme& scheme, std::size_t j, std::string_view s);

/// The time as the first argument behind (q, p), `clock_.t[0], `, of the position or stage i; empty
/// where H does not depend on it. And the same at the start of the step.
[[nodiscard]] std::string stage_time(const Scheme& scheme, std::size_t i, std::string_view s);
[[nodiscard]] std::string_view start_time(const Scheme& scheme);

/// The type of the stepper's clock.
[[nodiscard]] std::string clock_type(const Scheme& scheme);

/// What step() does with it before anything else.
[[nodiscard]] std::string clock_begins(const Scheme& scheme);

/// The table of the c_i of scheme.c.
[[nodiscard]] std::string times_text(const Scheme& scheme);

/// The call of the system, without its name, that puts the slope without its factor into `slope`.
[[nodiscard]] std::string evaluate_velocity(const Scheme& scheme, std::size_t j,
                                            std::string_view s);
[[nodiscard]] std::string evaluate_force(const Scheme& scheme, std::size_t i, std::string_view s);

/// h b_j of Lq_j, -h b_i of Lp_i; without the factor where the weight is 1.
[[nodiscard]] std::string velocity_factor(const Scheme& scheme, std::size_t j, std::string_view s);
[[nodiscard]] std::string force_factor(const Scheme& scheme, std::size_t i, std::string_view s);

/// Whether the products of h and the weights are rounded, together; see
/// src/hvi/detail/coefficients/weights.hpp.
[[nodiscard]] bool rounds_weights(const Scheme& scheme);

}  // namespace hvi::gen

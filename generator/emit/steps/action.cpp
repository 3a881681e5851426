// The discrete Hamiltonian of the last step, and the action of the steps.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <utility>

#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

/// Returns the C++ name of a stage value when the step is taken, before x is moved.
std::string value_of(const Step& step, const StageValue& value, std::size_t i, bool is_q) {
    // NOTE: a separable step keeps no copy of the state as a stage.
    const auto place = step.is_separable() ? value.place : StageValue::Place::inner;
    switch (place) {
    case StageValue::Place::start: return is_q ? "x.q" : "x.p";
    case StageValue::Place::inner: return fmt::format("s_.{}[{}]", is_q ? "Q" : "P", i);
    case StageValue::Place::end: return is_q ? "s_.at.q" : "s_.at.p";
    }
    HVI_CHECK(false);
    return {};
}

std::string position(const Step& step, std::size_t i) {
    return value_of(step, step.positions[i], i, true);
}

std::string momentum(const Step& step, std::size_t j) {
    return value_of(step, step.momenta[j], j, false);
}

/// Returns the call of H(q, p) or L(q, v), the `function` of the system.
std::string value_at(std::string_view function, const std::string& q, const std::string& p,
                     const std::string& time) {
    return fmt::format("system_.{}({}, {}{}{})", function, q, p, time.empty() ? "" : ", ", time);
}

std::string energy(const std::string& q, const std::string& p, const std::string& time) {
    return value_at("energy", q, p, time);
}

std::string energy_of_stage(const Step& step, std::size_t i, const std::string& p) {
    return energy(position(step, i), p, time_of_stage(step, std::to_string(i), "s_"));
}

/// Adds up H at the stages.
void take_energies(Writer& writer, const Step& step) {
    for (std::size_t i = 0; i < step.positions.size(); ++i) {
        writer.line("sum += {} * {};", force_factor(step, i, "s_"),
                    energy_of_stage(step, i, momentum(step, i)));
    }
}

/// Adds up H at the stages where H = T(p) + U(q) and several stages may have one position or one
/// momentum, so that there are no pairs.
void take_energies_of_merged(Writer& writer, const Step& step) {
    writer.comment("NOTE: H = T(p) + U(q), of stages with positions or momenta in common. With p "
                   "at the end H(Q_i, p) is U(Q_i) + T(p); then T(P_j) - T(p) is added for each "
                   "P_j, the weights of which add up to those of the Q_i.");
    for (std::size_t i = 0; i < step.positions.size(); ++i) {
        writer.line("sum += {} * {};", force_factor(step, i, "s_"),
                    energy_of_stage(step, i, "s_.at.p"));
    }
    const std::string start = time_of_start(step, "s_");
    writer.line("const Scalar at_end = {};", energy("s_.at.q", "s_.at.p", start));
    for (std::size_t j = 0; j < step.momenta.size(); ++j) {
        if (step.momenta[j].place == StageValue::Place::end) { continue; }
        writer.line("sum -= {} * ({} - at_end);", velocity_factor(step, j, "s_"),
                    energy("s_.at.q", momentum(step, j), start));
    }
}

/// Returns the members for the discrete Hamiltonian of the equation with that number.
std::string action_text(std::string_view equation) {
    Writer writer(1);
    writer
        .comment(fmt::format(
                     "H_d^+(q_0, p_1), {} of the paper, of the last step, from (q_0, p_0) to "
                     "(q_1, p_1): the generating function of type II with q_1 = D_2 H_d^+ and "
                     "p_0 = D_1 H_d^+, (3.10). A step of size 0 or that failed leaves that of the "
                     "one before. Before any step and after reset() it is NaN.",
                     equation),
                 "/// ")
        .line("[[nodiscard]] Scalar generating_function() const {{ return action_.of_step(); }}")
        .blank();
    writer
        .comment("S_d^k, (3.11), of the k steps so far: p_k q_k less the sum over them of "
                 "p_{l+1} q_{l+1} - H_d^+(q_l, p_{l+1}), which keeps what rounding cuts off. It "
                 "begins anew with a step that does not begin, bit for bit, where the last one "
                 "ended. It stays, or is NaN, where generating_function() does and is.",
                 "/// ")
        .line("[[nodiscard]] Scalar action() const {{ return action_.of_steps(); }}");
    return writer.str();
}

/// Returns the member integral_over_step() of (4.19).
std::string integral_text(const Step& step, const PairStep&) {
    Writer writer(1);
    writer
        .comment("The sum over stages of h b_i (P_i . dH/dp(Q_i, P_i) - H(Q_i, P_i)): see (4.19). "
                 "The step from x has been taken, and x not moved.",
                 "/// ")
        .open("[[nodiscard]] Scalar integral_over_step([[maybe_unused]] const State& x) const {{")
        .line("Scalar sum = 0;");
    for (std::size_t j = 0; j < step.momenta.size(); ++j) {
        writer.line("sum += hvi::detail::dot({}, s_.Lq[{}]);", momentum(step, j), j);
    }
    if (is_merged(step)) {
        take_energies_of_merged(writer, step);
    } else {
        take_energies(writer, step);
    }
    return writer.line("return sum;").close().str();
}

/// Returns the member integral_over_step() of (4.2).
std::string integral_text(const Step& step, const GalerkinStep& form) {
    const bool has_H = form.side == Side::hamiltonian;
    const std::string time = time_of_stage(step, "i", "s_");
    Writer writer(1);
    writer.comment(has_H ? "The sum over nodes of P_i . (sum_j X_ij W_j) - h b_i H(Q_i, P_i): see "
                           "(4.2). The last step has made its curve."
                         : "The sum over nodes of h b_i L(Q_i, U_i), U_i being the velocity there, "
                           "for which p dq - H dt stands in (4.2). The last step has made its "
                           "curve.",
                   "/// ");
    writer.open("[[nodiscard]] Scalar integral_over_step() const {{").line("Scalar sum = 0;");
    writer.open("for (std::size_t i = 0; i < {}; ++i) {{", form.form.nodes());
    if (has_H) {
        writer.line("sum += hvi::detail::dot(s_.P[i], s_.way(i, X)) - s_.hb[i] * {};",
                    energy("s_.Q[i]", "s_.P[i]", time));
    } else {
        writer.line("sum += s_.hb[i] * {};",
                    value_at("lagrangian", "s_.Q[i]", "s_.velocity(i, X)", time));
    }
    return writer.close().line("return sum;").close().str();
}

void add_action(ImplicitParts& parts, std::string_view equation, std::string integral) {
    parts.runtime.push_back("detail/stages/action");
    parts.action = action_text(equation);
    parts.integral = std::move(integral);
    Writer writer(1);
    writer.line("hvi::detail::ActionSum<State> action_;");
    parts.members += "\n" + writer.str();
}

}  // namespace

void add_action(ImplicitParts& parts, const Step& step, const PairStep& form) {
    add_action(parts, "(4.19)", integral_text(step, form));
}

void add_action(ImplicitParts& parts, const Step& step, const GalerkinStep& form) {
    add_action(parts, "(4.2)", integral_text(step, form));
}

std::string end_with_action(std::string_view integral, std::string_view end) {
    Writer writer(2);
    writer.line("action_.begin(x, {});", integral);
    return writer.line("return action_.end(x, {});", end).str();
}

}  // namespace hvi::gen

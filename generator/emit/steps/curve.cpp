// The curve of the last step.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

// ---- the table ----

/// Returns F with the rows of equal stages, which have one slope, added up.
NumberMatrix of_stages(const std::vector<StageValue>& values, const Curve& curve) {
    NumberMatrix result;
    for (const StageValue& value : values) {
        NumberVector sum(curve.F.front().size());
        for (const std::size_t stage : value.stages) {
            for (std::size_t k = 0; k < sum.size(); ++k) { sum[k] = sum[k] + curve.F[stage][k]; }
        }
        result.push_back(std::move(sum));
    }
    return result;
}

NumberMatrix without_weights(NumberMatrix F, const std::vector<StageValue>& values) {
    for (std::size_t j = 0; j < F.size(); ++j) {
        for (Number& entry : F[j]) { entry = entry / values[j].weight; }
    }
    return F;
}

/// Returns the table for the slopes Lq_j = h b_j dH/dp(Q_j, P_j): F_jk/b_j.
NumberMatrix of_velocities(const Step& step, const Curve& curve) {
    return without_weights(of_stages(step.momenta, curve), step.momenta);
}

/// Returns the table for the slopes Lp_i = -h b_i dH/dq(Q_i, P_i): F_ik/b_i. NOTE: with more nodes
/// than functions F has a row for each node with a weight, as there is a position for each.
NumberMatrix of_kicks(const Step& step, const Curve& curve) {
    const bool is_general =
        curve.of_forces.has_value() || std::holds_alternative<GalerkinStep>(step.form);
    return without_weights(is_general ? curve.F : of_stages(step.positions, curve), step.positions);
}

/// Returns the table for the W_i, sum_j mt_ji F_jk, as h dH/dp(P_j) = h v + sum_i mt_ji W_i. NOTE:
/// h v has the factor sum_j F_jk = 0, as the phi_j add up to 1, whose curve is its chord.
NumberMatrix of_forces(const Step& step, const Curve& curve) {
    const NumberMatrix F = of_stages(step.momenta, curve);
    NumberMatrix result(step.positions.size(), NumberVector(F.front().size()));
    for (std::size_t i = 0; i < result.size(); ++i) {
        for (std::size_t j = 0; j < F.size(); ++j) {
            const Number mt_ji = Number(1) - step.m[i][j];
            for (std::size_t k = 0; k < F[j].size(); ++k) {
                result[i][k] = result[i][k] + mt_ji * F[j][k];
            }
        }
    }
    return result;
}

/// Returns the table for the W_i of the general form.
NumberMatrix of_nodes(const Step& step, const NumberMatrix& F) {
    NumberMatrix result;
    for (const StageValue& value : step.positions) { result.push_back(F[value.stages.front()]); }
    return result;
}

/// Returns the table for the W_j of the curve, as h U_i = sum_j phi_ij W_j.
NumberMatrix of_curve(const GalerkinForm& form, const Curve& curve) {
    NumberMatrix result(form.functions(), NumberVector(curve.F.front().size()));
    for (std::size_t j = 0; j < form.functions(); ++j) {
        for (std::size_t i = 0; i < form.nodes(); ++i) {
            for (std::size_t k = 0; k < curve.F[i].size(); ++k) {
                result[j][k] = result[j][k] + form.phi[i][j] * curve.F[i][k];
            }
        }
    }
    return result;
}

NumberMatrix of_slopes(const Step& step, const Curve& curve) {
    if (const auto* galerkin = std::get_if<GalerkinStep>(&step.form)) {
        return of_curve(galerkin->form, curve);
    }
    if (std::holds_alternative<PairStep>(step.form) ||
        std::holds_alternative<ChartStep>(step.form)) {
        return of_velocities(step, curve);
    }
    return curve.of_forces ? of_nodes(step, *curve.of_forces) : of_forces(step, curve);
}

/// Returns whether momenta are in a vector space. NOTE: angular momenta of bodies that turn are
/// not.
bool has_momenta(const Step& step) { return !std::holds_alternative<ChartStep>(step.form); }

bool is_straight(const Curve& curve) { return curve.F.front().empty(); }

// ---- functions that are not polynomials ----

std::vector<Constant> rates(const Curve& curve) {
    std::vector<Constant> result;
    for (const Antiderivative& A : curve.A) {
        if (A.kind == Antiderivative::Kind::power) { continue; }
        result.push_back(constant(fmt::format("rate_{}", result.size() + 1), A.rate));
    }
    return result;
}

/// Returns `tau * tau * tau`, a power of tau.
std::string power(unsigned exponent) {
    std::string text = "tau";
    for (unsigned i = 1; i < exponent; ++i) { text += " * tau"; }
    return text;
}

std::string value(const Antiderivative& A, std::size_t rate, std::string_view library) {
    switch (A.kind) {
    case Antiderivative::Kind::power: return power(A.power);
    case Antiderivative::Kind::exponential:
        return fmt::format("{}::expm1(curve_rates[{}] * tau)", library, rate);
    case Antiderivative::Kind::sine:
        return fmt::format("{}::sin(curve_rates[{}] * tau)", library, rate);
    case Antiderivative::Kind::cosine:
        return fmt::format("{}::cos(curve_rates[{}] * tau) - 1", library, rate);
    }
    HVI_CHECK(false);
    return {};
}

std::string antiderivatives(const Curve& curve, std::string_view library) {
    Writer writer(1);
    const std::vector<Constant> all = rates(curve);
    if (!all.empty()) {
        table(writer, "curve_rates", all);
        refuse_float(writer, all);
    }
    writer.open("[[nodiscard]] static std::array<Scalar, {}> curve_terms(Scalar tau) {{",
                curve.A.size());
    writer.line("std::array<Scalar, {}> terms{{}};", curve.A.size());
    std::size_t rate = 0;
    for (std::size_t k = 0; k < curve.A.size(); ++k) {
        writer.line("terms[{}] = {};", k, value(curve.A[k], rate, library));
        if (curve.A[k].kind != Antiderivative::Kind::power) { ++rate; }
    }
    return writer.line("return terms;").close().str();
}

// ---- position(tau) and momentum(tau) ----

std::string comment(const Curve& curve) {
    return fmt::format(
        "The position q_d(tau h) within the last step, on the curve of the method (Section 4.1 of "
        "the paper): where the step began at tau = 0, where it ended at 1. From the exact solution "
        "through its beginning it is O(h^{}) away for all tau in [0, 1]. A step of size 0, or of "
        "one that is not finite, leaves the curve of the one before. After any other step that "
        "failed, after reset() and before any step the position is NaN.",
        curve.order + 1);
}

std::string comment_on_momenta(const Step& step, const Curve& curve) {
    const auto* form = std::get_if<GalerkinStep>(&step.form);
    const bool is_of_L = form != nullptr && form->side == Side::lagrangian;
    return fmt::format(
        "The momentum at tau h within the last step: that at its beginning and the integral of {} "
        "at the nodes, put together in the functions that the velocity of the curve is made of. "
        "From the exact solution it is O(h^{}) away, as the position is; there is one where there "
        "is a position.",
        is_of_L ? "dL/dq" : "-dH/dq", curve.order + 1);
}

void write_table(Writer& writer, std::string_view name, const NumberMatrix& exact) {
    std::vector<std::vector<Constant>> rows(exact.size());
    for (std::size_t i = 0; i < exact.size(); ++i) {
        for (std::size_t k = 0; k < exact[i].size(); ++k) {
            rows[i].push_back(constant(fmt::format("{}_{},{}", name, i + 1, k + 1), exact[i][k]));
        }
    }
    table(writer, name, rows);
}

/// A member of the class: the letter of a variable, the distance of its curve from the chord for
/// each slope, and the increment of the step.
struct CurveMember {
    std::string_view name;   ///< `position`
    char letter;             ///< q or p
    std::string_view table;  ///< `curve`
    std::string chord;
    std::vector<std::string> slopes;  ///< component k of each slope
    std::string_view remainder;       ///< remainder at the end; empty where it is left out
};

void write_member(Writer& writer, const Step& step, const Curve& curve, const CurveMember& member) {
    const bool is_any_size = step.container == Container::vectors;
    const bool bends = !is_straight(curve);
    writer.open("[[nodiscard]] Vector {}(Scalar tau) const {{", member.name);
    writer.line("if (!s_.has_ended()) {{ return hvi::detail::nowhere{}; }}",
                is_any_size ? "(Vector(system_.size()))" : "<Vector>()");
    if (bends) {
        writer.line("const auto bend = hvi::detail::departures({}, {});", member.table,
                    curve.A.empty() ? "tau" : "tau, curve_terms(tau), curve_terms(1)");
    }
    writer.line("Vector {}{};", member.letter,
                is_any_size ? fmt::format(" = s_.at.{}", member.letter) : "{}");
    writer.open("for (Index k = 0; k < s_.at.q.size(); ++k) {{");
    writer.line("const Scalar to_end = (1 - tau) * ({});", member.chord);
    std::string sum = "-to_end";
    for (std::size_t i = 0; i < member.slopes.size() && bends; ++i) {
        sum += fmt::format(" + bend[{}] * {}", i, member.slopes[i]);
    }
    if (!member.remainder.empty()) { sum = fmt::format("{} + ({})", member.remainder, sum); }
    writer.line("{0}[k] = s_.at.{0}[k] + ({1});", member.letter, sum).close();
    writer.line("return {};", member.letter).close();
}

}  // namespace

std::string curve_table(const Step& step, const Curve& curve, std::string_view library) {
    if (is_straight(curve)) { return {}; }
    Writer writer(1);
    writer.blank().comment(
        fmt::format("q_d(tau h) is on the chord but for sum_k curve_ik g_k(tau) times slope i, "
                    "with g_k(tau) = {}.",
                    curve.A.empty() ? "(P_{k+1}-P_{k-1})(2*tau-1)/2 of Legendre's polynomials P_k"
                                    : "A_k(tau)-tau*A_k(1) of the antiderivatives A_k"));
    write_table(writer, "curve", of_slopes(step, curve));
    if (has_momenta(step)) {
        writer.comment("As much of p, times Lp_i.");
        write_table(writer, "curve_p", of_kicks(step, curve));
    }
    if (!curve.A.empty()) { writer.insert(antiderivatives(curve, library)); }
    return writer.str();
}

std::string curve_text(const Step& step, const Curve& curve, std::string_view chord,
                       const std::vector<std::string>& slopes,
                       const std::vector<std::string>& kicks) {
    Writer writer(1);
    writer.comment(comment(curve), "/// ");
    write_member(writer, step, curve,
                 {"position", 'q', "curve", std::string(chord), slopes, "s_.remainder.q[k]"});
    writer.blank().comment(comment_on_momenta(step, curve), "/// ");
    // NOTE: a remainder of p may be more than half a unit in its last place (move_by_kick()), and
    // the curve ends where the step does.
    write_member(
        writer, step, curve,
        {"momentum", 'p', "curve_p", fmt::format("{}", fmt::join(kicks, " + ")), kicks, ""});
    return writer.str();
}

std::vector<std::string> slopes_in_rows(std::string_view slope, std::size_t count) {
    std::vector<std::string> result;
    for (std::size_t i = 0; i < count; ++i) {
        result.push_back(fmt::format("s_.{}[{}][k]", slope, i));
    }
    return result;
}

std::vector<std::string> slopes_in_lanes(std::string_view slope, std::size_t count) {
    std::vector<std::string> result;
    for (std::size_t i = 0; i < count; ++i) {
        result.push_back(fmt::format("s_.{}[static_cast<std::size_t>(k)][{}]", slope, i));
    }
    return result;
}

}  // namespace hvi::gen

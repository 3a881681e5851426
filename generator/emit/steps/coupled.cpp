// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/header.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/slope_calls.hpp"

namespace hvi::gen {
namespace {

using Kind = StageNode::Kind;

constexpr auto& loop_of_struct = "for (Index k = 0; k < s.at.q.size(); ++k) {{";

std::string index_list(std::string_view name, const std::vector<std::size_t>& indices) {
    std::string list;
    for (const std::size_t i : indices) {
        list += fmt::format("{}{}", list.empty() ? "" : ", ", i);
    }
    Writer writer(2);
    writer.line("static constexpr std::array<std::size_t, {}> {}{{{}}};", indices.size(), name,
                list);
    return writer.str();
}

/// Returns the lines that set Q, or P, and how much they change.
std::string stage_values(const std::vector<std::size_t>& indices, std::string_view letter,
                         std::string_view y, bool measured, const auto& sum) {
    if (indices.empty()) { return {}; }
    Writer writer(3);
    writer.open(loop_of_struct);
    writer.line("const Scalar {0} = s.at.{0}[k];", y);
    writer.line("const Scalar e_{0} = s.remainder.{0}[k];", y);
    std::string change;
    for (const std::size_t i : indices) {
        writer.line("const Scalar {}_{} = {};", letter, i + 1, sum(i));
        change += fmt::format("{0}hvi::detail::abs({1}_{2} - s.{1}[{3}][k])",
                              change.empty() ? "" : " + ", letter, i + 1, i);
    }
    if (measured) { writer.line("s.change.{}[k] = {};", y, change); }
    for (const std::size_t i : indices) {
        writer.line("s.{0}[{1}][k] = {0}_{2};", letter, i, i + 1);
    }
    return writer.close().str();
}

std::string slopes(const std::vector<std::size_t>& indices, std::string_view letter,
                   const auto& evaluate, const auto& factor) {
    if (indices.empty()) { return {}; }
    Writer writer(3);
    writer.line("auto&& slope = hvi::detail::scratch(s.slope);");
    for (const std::size_t i : indices) {
        writer.line("system.{}", evaluate(i));
        writer.open(loop_of_struct)
            .line("s.{}[{}][k] = {} * slope[k];", letter, i, factor(i))
            .close();
    }
    return writer.str();
}

std::string joint_slopes(const Step& step, const std::vector<std::size_t>& indices) {
    Writer writer(3);
    writer.line("Vector dHdq, dHdp;");
    for (const std::size_t i : indices) {
        const SlopePoint at{fmt::format("s.Q[{}]", i), fmt::format("s.P[{}]", i),
                            time_of_stage(step, std::to_string(i), "s")};
        writer.line("system.{};", gradient_call(at, "dHdq", "dHdp"));
        writer.open(loop_of_struct);
        writer.line("s.Lp[{}][k] = {} * dHdq[k];", i, force_factor(step, i, "s"));
        writer.line("s.Lq[{}][k] = {} * dHdp[k];", i, velocity_factor(step, i, "s"));
        writer.close();
    }
    return writer.str();
}

/// Returns the members that evaluate H.
std::string slopes(const Step& step, const Block& block) {
    Writer writer(2);
    if (step.slopes == Slopes::joint) {
        writer.line("/// Lp_i = -h b_i dH/dq and Lq_i = h b_i dH/dp.");
        writer.open("void slopes() {{").insert(joint_slopes(step, block.of(Kind::Lq)));
        return writer.close().str();
    }
    writer.line("/// Lq_j = h b_j dH/dp.").open("void velocities() {{");
    writer.insert(slopes(
        block.of(Kind::Lq), "Lq", [&](std::size_t j) { return evaluate_velocity(step, j, "s"); },
        [&](std::size_t j) { return velocity_factor(step, j, "s"); }));
    writer.close().blank().line("/// Lp_i = -h b_i dH/dq.").open("void forces() {{");
    writer.insert(slopes(
        block.of(Kind::Lp), "Lp", [&](std::size_t i) { return evaluate_force(step, i, "s"); },
        [&](std::size_t i) { return force_factor(step, i, "s"); }));
    return writer.close().str();
}

/// Returns the size that the rounding of Q, or P, is compared with. NOTE: it includes q, or p,
/// since a stage may be near 0 where q or p is not.
std::string size(const std::vector<std::size_t>& values, std::string_view letter,
                 const std::vector<std::size_t>& slopes, std::string_view slope_letter) {
    if (values.empty()) { return "return 0;"; }
    std::string sum = fmt::format("hvi::detail::abs(s.at.{}[k])", letter == "Q" ? "q" : "p");
    for (const auto& [indices, name] :
         {std::pair{values, letter}, std::pair{slopes, slope_letter}}) {
        for (const std::size_t i : indices) {
            sum += fmt::format(" + hvi::detail::abs(s.{}[{}][k])", name, i);
        }
    }
    return Writer(3).line("return {};", sum).str();
}

/// Returns the members besides the system and the stages.
std::string members(const Step& step) {
    return Writer(2).insert(coefficients_reference(step)).insert(clock_reference(step)).str();
}

}  // namespace

std::string unknowns(const Block& block) {
    std::string names;
    for (const auto& [kind, letter] : {std::pair{Kind::Q, "Q"}, std::pair{Kind::P, "P"}}) {
        for (const std::size_t i : block.of(kind)) {
            names += fmt::format("{}{}_{}", names.empty() ? "" : ", ", letter, i + 1);
        }
    }
    Writer writer(1);
    writer.comment(fmt::format("The stage equations of {}, which are solved at once.", names),
                   "/// ");
    return writer.str();
}

std::string coupled(const Step& step, const Block& block, std::string_view name) {
    const auto Q = block.of(Kind::Q);
    const auto P = block.of(Kind::P);
    const auto Lq = block.of(Kind::Lq);
    const auto Lp = block.of(Kind::Lp);
    const bool varies = step.from_parameter.has_value();
    const bool measures_p = !step.is_separable() || Q.empty();
    return fill_part(
        "coupled.hpp.in",
        {{"unknowns", unknowns(block)},
         {"name", std::string(name)},
         {"types", fmt::format("{}, {}", step.positions.size(), step.momenta.size())},
         {"separable", std::string(truth(step.is_separable()))},
         {"has_q", std::string(truth(!Q.empty()))},
         {"has_p", std::string(truth(!P.empty()))},
         {"unknown_q", index_list("unknown_q", Lq)},
         {"unknown_p", index_list("unknown_p", Lp)},
         {"member", members(step)},
         {"static", varies ? "" : "static constexpr "},
         {"const", varies ? " const" : ""},
         {"m", fmt::format("{}m", owner(step, "s"))},
         {"mt", fmt::format("{}{}", owner(step, "s"), table_mt(step))},
         {"b_q", fmt::format("{}{}", owner(step, "s"), weights_q(step))},
         {"b_p", fmt::format("{}{}", owner(step, "s"), weights_p(step))},
         {"momenta", stage_values(P, "P", "p", measures_p,
                                  [&](std::size_t j) { return moved_momentum(step, j, "s"); })},
         {"positions", stage_values(Q, "Q", "q", true,
                                    [&](std::size_t i) { return moved_position(step, i, "s"); })},
         {"slopes", slopes(step, block)},
         {"size_q", size(Q, "Q", Lq, "Lq")},
         {"size_p", size(P, "P", Lp, "Lp")}});
}

}  // namespace hvi::gen

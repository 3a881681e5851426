// Stage equations of positions and momenta.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/along.hpp"
#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/increments.hpp"
#include "generator/emit/steps/slope_calls.hpp"
#include "generator/emit/steps/starting_values.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

using Kind = StageNode::Kind;

constexpr auto& loop_of_step = "for (Index k = 0; k < s_.at.q.size(); ++k) {{";

std::string coupled_name(const Step& step, std::size_t number) {
    return step.coupled_blocks() == 1 ? "Coupled" : fmt::format("Coupled{}", number + 1);
}

// ---- step() ----

std::string sum_of_slopes(std::string_view slope, std::size_t count) {
    std::string sum;
    for (std::size_t i = 0; i < count; ++i) {
        sum += fmt::format("{}s_.{}[{}][k]", i == 0 ? "" : " + ", slope, i);
    }
    return sum;
}

/// The sums that end the step, each of which may be needed before all slopes are known.
class Updates {
public:
    Updates(Writer& writer, const Step& step) : writer_(writer), step_(step) {}

    void q() {
        write([&] { q_line(); });
        q_done_ = true;
    }
    void p() {
        write([&] { p_line(); });
        p_done_ = true;
    }
    void rest() {
        if (q_done_ && p_done_) { return; }
        write([&] {
            if (!q_done_) { q_line(); }
            if (!p_done_) { p_line(); }
        });
    }

private:
    void write(const auto& lines) {
        writer_.open(loop_of_step);
        lines();
        writer_.close();
    }
    void q_line() { line("q", "Lq", step_.momenta.size()); }
    void p_line() { line("p", "Lp", step_.positions.size()); }
    void line(std::string_view y, std::string_view slope, std::size_t count) {
        writer_.line("{};", move_to_end(y, sum_of_slopes(slope, count)));
    }

    Writer& writer_;
    const Step& step_;
    bool q_done_ = false;
    bool p_done_ = false;
};

void evaluate_stage(Writer& writer, const Step& step, const StageNode& node, Updates& updates) {
    const bool is_q = node.kind == Kind::Q;
    const StageValue& value = (is_q ? step.positions : step.momenta)[node.index];
    const std::string_view letter = is_q ? "Q" : "P";
    const std::string_view y = is_q ? "q" : "p";
    switch (value.place) {
    case StageValue::Place::start:
        if (!step.is_separable()) { writer.line("s_.{}[{}] = s_.at.{};", letter, node.index, y); }
        return;
    case StageValue::Place::end:
        if (is_q) {
            updates.q();
        } else {
            updates.p();
        }
        return;
    case StageValue::Place::inner:
        writer.open(loop_of_step);
        writer.line("const Scalar {0} = s_.at.{0}[k];", y);
        writer.line("const Scalar e_{0} = s_.remainder.{0}[k];", y);
        writer.line("s_.{}[{}][k] = {};", letter, node.index,
                    is_q ? moved_position(step, node.index, "s_")
                         : moved_momentum(step, node.index, "s_"));
        writer.close();
        return;
    }
}

void evaluate_slope(Writer& writer, const Step& step, const StageNode& node) {
    const bool is_force = node.kind == Kind::Lp;
    const StageValue& value = (is_force ? step.positions : step.momenta)[node.index];
    const std::string_view letter = is_force ? "Lp" : "Lq";
    const std::string factor =
        is_force ? force_factor(step, node.index, "s_") : velocity_factor(step, node.index, "s_");
    if (!is_kept(step, node)) {
        writer.line("system_.{}", is_force ? evaluate_force(step, node.index, "s_")
                                           : evaluate_velocity(step, node.index, "s_"));
        writer.open(loop_of_step)
            .line("s_.{}[{}][k] = {} * slope[k];", letter, node.index, factor)
            .close();
        return;
    }
    const std::string_view slope = is_force ? "force_" : "velocity_";
    if (value.place == StageValue::Place::end) {
        const SlopePoint at{"s_.at.q", "s_.at.p",
                            time_of_stage(step, std::to_string(node.index), "s_")};
        writer.line("system_.{};",
                    is_force ? force_call(step, at, slope) : velocity_call(step, at, slope));
    }
    writer.open(loop_of_step)
        .line("s_.{}[{}][k] = {} * {}[k];", letter, node.index, factor, slope)
        .close();
}

/// Slopes that the step before has kept are evaluated where there is no such step.
void begin_kept(Writer& writer, const Step& step) {
    const auto begin = [&](std::string_view slope, const std::string& call) {
        writer.open("if (!s_.continues) {{")
            .line("hvi::detail::fit({}, s_.n);", slope)
            .line("system_.{};", call)
            .close();
    };
    const SlopePoint start = start_of_step(step);
    if (step.kept.force) { begin("force_", force_call(step, start, "force_")); }
    if (step.kept.velocity) { begin("velocity_", velocity_call(step, start, "velocity_")); }
}

/// Whether a slope is evaluated outside the coupled blocks and not kept.
bool evaluates_slopes(const Step& step) {
    for (const Block& block : step.blocks) {
        const StageNode& node = block.nodes.front();
        if (!block.coupled && node.kind == Kind::Lp && !is_kept(step, node)) { return true; }
        if (!block.coupled && node.kind == Kind::Lq && !is_kept(step, node)) { return true; }
    }
    return false;
}

std::string steps_of_pairs(const Step& step, const SceneWishes& wishes) {
    Writer writer(2);
    Updates updates(writer, step);
    if (rounds_weights(step)) {
        writer.line("s_.weigh({0}{1}, {0}{2});", owner(step, "s_"), weights_q(step),
                    weights_p(step));
    }
    begin_kept(writer, step);
    if (!step.is_explicit()) {
        writer.line("if constexpr (Solver::takes_starting_values) {{ predict(); }}");
    }
    writer.blank();
    if (evaluates_slopes(step)) { writer.line("auto&& slope = hvi::detail::scratch(s_.slope);"); }
    const bool several = step.coupled_blocks() > 1;
    if (several) { writer.line("int iterations = 0;"); }
    std::size_t number = 0;
    for (const Block& block : step.blocks) {
        if (block.coupled) {
            const std::string solver = several ? fmt::format("solver_[{}]", number) : "solver_";
            writer.line("status = {}.solve({}{{{}s_}});", solver, coupled_name(step, number++),
                        coupled_arguments(step));
            writer.line("if (!status.ok()) {{ return status; }}");
            if (several) { writer.line("iterations += status.iterations;"); }
            continue;
        }
        const StageNode& node = block.nodes.front();
        if (node.kind == Kind::Q || node.kind == Kind::P) {
            evaluate_stage(writer, step, node, updates);
        } else {
            evaluate_slope(writer, step, node);
        }
    }
    writer.blank();
    writer.insert(call_of_carry(step));
    updates.rest();
    const std::string end = end_of_step(step, several ? "iterations" : "status.iterations");
    if (wishes.action) {
        writer.insert(end_with_action("integral_over_step(x)", end));
    } else {
        writer.line("return {};", end);
    }
    return writer.str();
}

// ---- starting values ----

struct Slope {
    std::string_view letter;
    std::size_t index;
};

/// The slopes that the solvers iterate on: for separable H those of p are enough.
std::vector<Slope> predicted(const Step& step) {
    std::vector<Slope> result;
    for (const Block& block : step.blocks) {
        if (!block.coupled) { continue; }
        if (!step.is_separable()) {
            for (const std::size_t j : block.of(Kind::Lq)) { result.push_back({"Lq", j}); }
        }
        for (const std::size_t i : block.of(Kind::Lp)) { result.push_back({"Lp", i}); }
    }
    return result;
}

void extrapolate(Writer& writer, const Step& step, const Extrapolation& from,
                 const std::vector<Slope>& slopes) {
    const std::vector<std::string_view> letters = predicted_slopes(step);
    open_extrapolation(writer, from);
    writer.open(loop_of_step);
    for (const std::string_view letter : letters) { recall_slopes(writer, from, letter); }
    for (const Slope& slope : slopes) {
        writer.line("s_.{}[{}][k] = {};", slope.letter, slope.index,
                    extrapolated(from, slope.index, slope.letter));
    }
    writer.close();
    close_extrapolation(writer, from, letters);
}

/// The indices of the slopes of that letter.
std::vector<std::size_t> indices_of(const std::vector<Slope>& slopes, std::string_view letter) {
    std::vector<std::size_t> indices;
    for (const Slope& slope : slopes) {
        if (slope.letter == letter) { indices.push_back(slope.index); }
    }
    return indices;
}

/// Sets both slopes of all stages to those at the step's start.
void constant_jointly(Writer& writer, const Step& step, const std::vector<Slope>& slopes) {
    writer.line("Vector dHdq, dHdp;");
    writer.line("system_.{};", gradient_call(start_of_step(step), "dHdq", "dHdp"));
    writer.open(loop_of_step);
    for (const std::size_t i : indices_of(slopes, "Lp")) {
        writer.line("s_.Lp[{}][k] = {} * dHdq[k];", i, force_factor(step, i, "s_"));
    }
    for (const std::size_t j : indices_of(slopes, "Lq")) {
        writer.line("s_.Lq[{}][k] = {} * dHdp[k];", j, velocity_factor(step, j, "s_"));
    }
    writer.close();
}

/// All slopes as at the step's start. `kept` is where that slope is at hand.
void constant(Writer& writer, const Step& step, const std::vector<Slope>& slopes,
              std::string_view letter) {
    const std::vector<std::size_t> indices = indices_of(slopes, letter);
    if (indices.empty()) { return; }
    const bool is_force = letter == "Lp";
    const bool kept = is_force && step.kept.force;
    if (!kept) {
        const SlopePoint start = start_of_step(step);
        writer.line("system_.{};", is_force ? force_call(step, start, "slope")
                                            : velocity_call(step, start, "slope"));
    }
    writer.open(loop_of_step);
    for (const std::size_t i : indices) {
        writer.line("s_.{}[{}][k] = {} * {}[k];", letter, i,
                    is_force ? force_factor(step, i, "s_") : velocity_factor(step, i, "s_"),
                    kept ? "force_" : "slope");
    }
    writer.close();
}

std::string prediction_of_pairs(const Step& step, const Iteration& iteration) {
    const std::vector<Slope> slopes = predicted(step);
    Writer writer(1);
    open_predict(writer, iteration, "slopes");
    if (!iteration.extrapolation.empty()) {
        extrapolate(writer, step, iteration.extrapolation.front(), slopes);
    }
    if (step.slopes == Slopes::joint) {
        constant_jointly(writer, step, slopes);
        return writer.close().str();
    }
    if (!step.kept.force) { writer.line("auto&& slope = hvi::detail::scratch(s_.slope);"); }
    constant(writer, step, slopes, "Lq");
    constant(writer, step, slopes, "Lp");
    return writer.close().str();
}

// ---- constants, members ----

std::string coupled_pairs(const Step& step) {
    std::string text;
    std::size_t number = 0;
    for (const Block& block : step.blocks) {
        if (!block.coupled) { continue; }
        if (number > 0) { text += "\n\n"; }
        text += coupled(step, block, coupled_name(step, number++));
    }
    return text;
}

std::string members_of_pairs(const Step& step) {
    Writer writer(1);
    writer.line("System system_;");
    writer.insert(coefficients_member(step)).insert(clock_member(step));
    writer.line("hvi::detail::Stages<Vector, {}, {}> s_;", step.positions.size(),
                step.momenta.size());
    constexpr std::string_view solver = "typename Solver::template Iteration<Vector>";
    if (step.coupled_blocks() == 1) {
        writer.line("{} solver_;", solver);
    } else if (!step.is_explicit()) {
        writer.line("std::array<{}, {}> solver_;", solver, step.coupled_blocks());
    }
    if (step.kept.force) {
        writer.line("Vector force_{{}};  // dH/dq at s_.at.q, where the last step ended");
    }
    if (step.kept.velocity) {
        writer.line("Vector velocity_{{}};  // dH/dp at s_.at.p, where the last step ended");
    }
    declare_slopes_before(writer, step);
    return writer.str();
}

}  // namespace

std::string constants_text(const Step& step, const PairStep& form, const SceneWishes& wishes) {
    if (step.from_parameter) { return functions_of_parameter(step); }
    Writer writer(1);
    writer.insert(coefficients_text(step, form.coefficients));
    if (const std::string times = times_text(step); !times.empty()) {
        writer.blank().insert(times);
    }
    if (form.iteration) { writer.insert(extrapolation_text(*form.iteration)); }
    if (wishes.curve) { writer.insert(curve_table(step, *wishes.curve, library(wishes))); }
    writer.insert(gamma_table(step.in_a_row));
    return with_rounding(writer.str());
}

ImplicitParts parts(const Step& step, const PairStep& form, const SceneWishes& wishes) {
    ImplicitParts parts;
    parts.runtime = {"detail/stages/stages"};
    if (step.from_parameter) { parts.runtime.push_back("detail/coefficients/parameter"); }
    parts.steps = steps_of_pairs(step, wishes);
    parts.constants = constants_text(step, form, wishes);
    if (form.iteration) { parts.predict = prediction_of_pairs(step, *form.iteration); }
    parts.coupled = coupled_pairs(step);
    parts.members = members_of_pairs(step);
    if (wishes.curve) {
        parts.curve = curve_text(step, *wishes.curve, sum_of_slopes("Lq", step.momenta.size()),
                                 slopes_in_rows("Lq", step.momenta.size()),
                                 slopes_in_rows("Lp", step.positions.size()));
    }
    if (wishes.action) { add_action(parts, step, form); }
    return parts;
}

}  // namespace hvi::gen

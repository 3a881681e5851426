// Stage equations of positions and momenta.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/starting_values.hpp"
#include "generator/plan/lattice.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

using Kind = StageNode::Kind;

constexpr auto& loop_of_step = "for (Index k = 0; k < s_.at.q.size(); ++k) {{";

std::string coupled_name(const Scheme& scheme, std::size_t number) {
    return scheme.coupled_blocks() == 1 ? "Coupled" : fmt::format("Coupled{}", number + 1);
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
    Updates(Writer& writer, const Scheme& scheme) : writer_(writer), scheme_(scheme) {}

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
    void q_line() { line("q", "Lq", scheme_.momenta.size()); }
    void p_line() { line("p", "Lp", scheme_.positions.size()); }
    void line(std::string_view y, std::string_view slope, std::size_t count) {
        writer_.line("s_.add(s_.at.{0}[k], s_.remainder.{0}[k], {1});", y,
                     sum_of_slopes(slope, count));
    }

    Writer& writer_;
    const Scheme& scheme_;
    bool q_done_ = false;
    bool p_done_ = false;
};

void evaluate_stage(Writer& writer, const Scheme& scheme, const StageNode& node, Updates& updates) {
    const bool is_q = node.kind == Kind::Q;
    const StageValue& value = (is_q ? scheme.positions : scheme.momenta)[node.index];
    const std::string_view letter = is_q ? "Q" : "P";
    const std::string_view y = is_q ? "q" : "p";
    switch (value.place) {
    case StageValue::Place::start:
        if (!scheme.separable) { writer.line("s_.{}[{}] = s_.at.{};", letter, node.index, y); }
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
                    is_q ? position_sum(scheme, node.index, "s_")
                         : momentum_sum(scheme, node.index, "s_"));
        writer.close();
        return;
    }
}

void evaluate_slope(Writer& writer, const Scheme& scheme, const StageNode& node) {
    const bool is_force = node.kind == Kind::Lp;
    const StageValue& value = (is_force ? scheme.positions : scheme.momenta)[node.index];
    const std::string_view letter = is_force ? "Lp" : "Lq";
    const std::string factor = is_force ? force_factor(scheme, node.index, "s_")
                                        : velocity_factor(scheme, node.index, "s_");
    if (!is_kept(scheme, node)) {
        writer.line("system_.{}", is_force ? evaluate_force(scheme, node.index, "s_")
                                           : evaluate_velocity(scheme, node.index, "s_"));
        writer.open(loop_of_step)
            .line("s_.{}[{}][k] = {} * slope[k];", letter, node.index, factor)
            .close();
        return;
    }
    const std::string_view slope = is_force ? "force_" : "velocity_";
    if (value.place == StageValue::Place::end) {
        writer.line("system_.{}(s_.at.{}, {}{});", is_force ? "dHdq" : "dHdp", is_force ? "q" : "p",
                    is_force ? stage_time(scheme, node.index, "s_") : "", slope);
    }
    writer.open(loop_of_step)
        .line("s_.{}[{}][k] = {} * {}[k];", letter, node.index, factor, slope)
        .close();
}

void begin_kept(Writer& writer, bool keeps, std::string_view gradient, std::string_view y,
                std::string_view time, std::string_view slope) {
    if (!keeps) { return; }
    writer.open("if (!s_.continues) {{")
        .line("hvi::detail::fit({}, s_.n);", slope)
        .line("system_.{}(s_.at.{}, {}{});", gradient, y, time, slope)
        .close();
}

/// Whether a slope is evaluated outside the coupled blocks and not kept.
bool evaluates_slopes(const Scheme& scheme) {
    for (const Block& block : scheme.blocks) {
        const StageNode& node = block.nodes.front();
        if (!block.coupled && node.kind == Kind::Lp && !is_kept(scheme, node)) { return true; }
        if (!block.coupled && node.kind == Kind::Lq && !is_kept(scheme, node)) { return true; }
    }
    return false;
}

std::string steps_of_pairs(const Scheme& scheme) {
    Writer writer(2);
    Updates updates(writer, scheme);
    if (rounds_weights(scheme)) {
        writer.line("s_.weigh({0}{1}, {0}{2});", owner(scheme, "s_"), weights_q(scheme),
                    weights_p(scheme));
    }
    begin_kept(writer, scheme.keeps_force, "dHdq", "q", start_time(scheme), "force_");
    begin_kept(writer, scheme.keeps_velocity, "dHdp", "p", "", "velocity_");
    if (!scheme.is_explicit()) {
        writer.line("if constexpr (Solver::takes_starting_values) {{ predict(); }}");
    }
    writer.blank();
    if (evaluates_slopes(scheme)) { writer.line("auto&& slope = hvi::detail::scratch(s_.slope);"); }
    const bool several = scheme.coupled_blocks() > 1;
    if (several) { writer.line("int iterations = 0;"); }
    std::size_t number = 0;
    for (const Block& block : scheme.blocks) {
        if (block.coupled) {
            const std::string solver = several ? fmt::format("solver_[{}]", number) : "solver_";
            writer.line("status = {}.solve({}{{{}s_}});", solver, coupled_name(scheme, number++),
                        coupled_arguments(scheme));
            writer.line("if (!status.ok()) {{ return status; }}");
            if (several) { writer.line("iterations += status.iterations;"); }
            continue;
        }
        const StageNode& node = block.nodes.front();
        if (node.kind == Kind::Q || node.kind == Kind::P) {
            evaluate_stage(writer, scheme, node, updates);
        } else {
            evaluate_slope(writer, scheme, node);
        }
    }
    writer.blank();
    updates.rest();
    writer.line("return {};", end_of_step(scheme, several ? "iterations" : "status.iterations"));
    return writer.str();
}

// ---- starting values ----

struct Slope {
    std::string_view letter;
    std::size_t index;
};

/// The slopes that the solvers iterate on: for separable H those of p are enough.
std::vector<Slope> predicted(const Scheme& scheme) {
    std::vector<Slope> result;
    for (const Block& block : scheme.blocks) {
        if (!block.coupled) { continue; }
        if (!scheme.separable) {
            for (const std::size_t j : block.of(Kind::Lq)) { result.push_back({"Lq", j}); }
        }
        for (const std::size_t i : block.of(Kind::Lp)) { result.push_back({"Lp", i}); }
    }
    return result;
}

void extrapolate(Writer& writer, const Scheme& scheme, const std::vector<Slope>& slopes) {
    open_extrapolation(writer, scheme);
    writer.open(loop_of_step);
    for (const std::string_view letter : predicted_slopes(scheme)) {
        recall_slopes(writer, scheme, letter);
    }
    for (const Slope& slope : slopes) {
        writer.line("s_.{}[{}][k] = {};", slope.letter, slope.index,
                    extrapolated(scheme, slope.index, slope.letter));
    }
    writer.close();
    close_extrapolation(writer, scheme);
}

/// The indices of the slopes of that letter.
std::vector<std::size_t> indices_of(const std::vector<Slope>& slopes, std::string_view letter) {
    std::vector<std::size_t> indices;
    for (const Slope& slope : slopes) {
        if (slope.letter == letter) { indices.push_back(slope.index); }
    }
    return indices;
}

/// Both slopes of all stages as at the step's start.
void constant_jointly(Writer& writer, const Scheme& scheme, const std::vector<Slope>& slopes) {
    writer.line("Vector dHdq, dHdp;");
    writer.line("system_.gradient(s_.at.q, s_.at.p, {}dHdq, dHdp);", start_time(scheme));
    writer.open(loop_of_step);
    for (const std::size_t i : indices_of(slopes, "Lp")) {
        writer.line("s_.Lp[{}][k] = {} * dHdq[k];", i, force_factor(scheme, i, "s_"));
    }
    for (const std::size_t j : indices_of(slopes, "Lq")) {
        writer.line("s_.Lq[{}][k] = {} * dHdp[k];", j, velocity_factor(scheme, j, "s_"));
    }
    writer.close();
}

/// All slopes as at the step's start. `kept` is where that slope is at hand.
void constant(Writer& writer, const Scheme& scheme, const std::vector<Slope>& slopes,
              std::string_view letter) {
    const std::vector<std::size_t> indices = indices_of(slopes, letter);
    if (indices.empty()) { return; }
    const bool is_force = letter == "Lp";
    const bool kept = is_force && scheme.keeps_force;
    if (!kept) {
        writer.line("system_.{}({}, {}slope);", is_force ? "dHdq" : "dHdp",
                    scheme.separable ? "s_.at.q" : "s_.at.q, s_.at.p", start_time(scheme));
    }
    writer.open(loop_of_step);
    for (const std::size_t i : indices) {
        writer.line("s_.{}[{}][k] = {} * {}[k];", letter, i,
                    is_force ? force_factor(scheme, i, "s_") : velocity_factor(scheme, i, "s_"),
                    kept ? "force_" : "slope");
    }
    writer.close();
}

std::string prediction_of_pairs(const Scheme& scheme) {
    if (scheme.is_explicit()) { return {}; }
    const std::vector<Slope> slopes = predicted(scheme);
    Writer writer(1);
    open_predict(writer, scheme, "slopes");
    if (scheme.extrapolation) { extrapolate(writer, scheme, slopes); }
    if (scheme.has_joint_slopes) {
        constant_jointly(writer, scheme, slopes);
        return writer.close().str();
    }
    if (!scheme.keeps_force) { writer.line("auto&& slope = hvi::detail::scratch(s_.slope);"); }
    constant(writer, scheme, slopes, "Lq");
    constant(writer, scheme, slopes, "Lp");
    return writer.close().str();
}

// ---- constants, members ----

std::string coupled_pairs(const Scheme& scheme) {
    std::string text;
    std::size_t number = 0;
    for (const Block& block : scheme.blocks) {
        if (!block.coupled) { continue; }
        if (number > 0) { text += "\n\n"; }
        text += coupled(scheme, block, coupled_name(scheme, number++));
    }
    return text;
}

std::string members_of_pairs(const Scheme& scheme) {
    Writer writer(1);
    writer.line("System system_;");
    if (scheme.from_parameter) { writer.line("Coefficients coefficients_;"); }
    if (scheme.depends_on_time) { writer.line("{} clock_;", clock_type(scheme)); }
    writer.line("hvi::detail::Stages<Vector, {}, {}> s_;", scheme.positions.size(),
                scheme.momenta.size());
    constexpr std::string_view solver = "typename Solver::template Iteration<Vector>";
    if (scheme.coupled_blocks() == 1) {
        writer.line("{} solver_;", solver);
    } else if (!scheme.is_explicit()) {
        writer.line("std::array<{}, {}> solver_;", solver, scheme.coupled_blocks());
    }
    if (scheme.keeps_force) {
        writer.line("Vector force_{{}};  // dH/dq at s_.at.q, where the last step ended");
    }
    if (scheme.keeps_velocity) {
        writer.line("Vector velocity_{{}};  // dH/dp at s_.at.p, where the last step ended");
    }
    declare_slopes_before(writer, scheme);
    return writer.str();
}

}  // namespace

std::string pair_constants(const Scheme& scheme, const SceneWishes& wishes) {
    if (scheme.from_parameter) { return functions_of_parameter(scheme); }
    Writer writer(1);
    writer.insert(coefficients_text(scheme));
    if (scheme.depends_on_time) { writer.blank().insert(times_text(scheme)); }
    if (scheme.extrapolation) { writer.blank().insert(extrapolation_text(scheme)); }
    if (wishes.curve) { writer.insert(curve_table(scheme, *wishes.curve, library(wishes))); }
    return with_rounding(writer.str());
}

ImplicitParts pair_parts(const Scheme& scheme, const SceneWishes& wishes) {
    ImplicitParts parts;
    parts.runtime = {"detail/stages/stages"};
    if (scheme.from_parameter) { parts.runtime.push_back("detail/coefficients/parameter"); }
    parts.steps = steps_of_pairs(scheme);
    parts.constants = pair_constants(scheme, wishes);
    parts.predict = prediction_of_pairs(scheme);
    parts.coupled = coupled_pairs(scheme);
    parts.members = members_of_pairs(scheme);
    if (wishes.curve) {
        parts.curve = curve_text(scheme, *wishes.curve, sum_of_slopes("Lq", scheme.momenta.size()),
                                 [](std::size_t i) { return fmt::format("s_.Lq[{}][k]", i); });
    }
    return parts;
}

}  // namespace hvi::gen

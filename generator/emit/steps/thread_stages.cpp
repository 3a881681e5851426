// Stages of steppers whose trajectories are threads of a GPU.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/header.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/slope_calls.hpp"
#include "generator/emit/steps/threads.hpp"

namespace hvi::gen {
namespace {

std::string thread_stages_type(const Step& step, std::size_t dimension) {
    return fmt::format("hvi::device::Stages<Number, {}, {}>", dimension, step.positions.size());
}

/// Returns whether slopes of one step are starting values of the next, and which.
std::vector<std::string_view> slopes_for_next(const Step& step) {
    if (step.iteration()->extrapolation.empty()) { return {}; }
    if (step.is_separable()) { return {"p"}; }
    return {"q", "p"};
}

std::string state_of_stages(const Step& step, std::size_t dimension) {
    Writer writer(2);
    write_state(writer, step, dimension);
    writer.line("int iterations = 0;  // of the last step");
    write_remainder_of_time(writer, step);
    writer.line("hvi::device::Vector<Number, {}> remainder_q{{}}, remainder_p{{}};", dimension);
    for (const std::string_view of : slopes_for_next(step)) {
        writer.line("hvi::device::Vector<Number, {}> slopes_{}[{}]{{}};", dimension, of,
                    step.positions.size());
    }
    if (!slopes_for_next(step).empty()) {
        writer.line("Number size_of_step = 0;  // of these slopes");
    }
    return writer.str();
}

std::string steps_of_stages(const Step& step, std::string_view class_name) {
    const std::size_t stages = step.positions.size();
    Writer writer(2);
    writer.open("explicit Steps(Number size) : h(size) {{")
        .line("hvi::device::weigh(h, {}, hb);", weights_p(step));
    if (step.depends_on_time()) { writer.line("hvi::device::scale(h, c, t);"); }
    writer.close().blank().line("Number h;");
    writer.line("hvi::device::Vector<Number, {}> hb{{}};", stages);
    if (step.depends_on_time()) { writer.line("hvi::device::Vector<Number, {}> t{{}};", stages); }
    const auto table = [&](std::string_view name) {
        writer.line("hvi::device::Table<Number, {}> {} = hvi::device::table_of({}::{});", stages,
                    name, class_name, name);
    };
    table("m");
    if (table_mt(step) != "m") { table(table_mt(step)); }
    if (!slopes_for_next(step).empty()) { table("N"); }
    return writer.str();
}

/// Writes the loop over the stages that sets slopes at `at`, the start or stage i, and the loop's
/// end.
class SlopesOfStages {
public:
    SlopesOfStages(Writer& writer, const Step& step) : writer_(writer), step_(step) {}

    /// Writes the evaluations and the lines that set the slopes of q, of p, or of both.
    void write(const SlopePoint& at, bool is_of_start, bool of_q, bool of_p) {
        const bool is_joint = step_.slopes == Slopes::joint;
        if (!is_of_start) { open(); }
        if (is_joint) {
            writer_.line("Values dHdq, dHdp;");
            writer_.line("system.{};", gradient_call(at, "dHdq", "dHdp"));
        } else {
            writer_.line("Values {};", of_q && of_p ? "dHdq, dHdp" : of_q ? "dHdp" : "dHdq");
            if (of_q) { writer_.line("system.{};", velocity_call(step_, at, "dHdp")); }
            if (of_p) { writer_.line("system.{};", force_call(step_, at, "dHdq")); }
        }
        if (is_of_start) { open(); }
        if (of_p) { writer_.line("s.set(s.Lp[i], -by.hb[i], dHdq);"); }
        if (of_q) { writer_.line("s.set(s.Lq[i], by.hb[i], dHdp);"); }
        writer_.close();
    }

private:
    void open() { writer_.open("for (std::size_t i = 0; i < {}; ++i) {{", step_.positions.size()); }

    Writer& writer_;
    const Step& step_;
};

std::string slopes_of_thread(const Step& step) {
    const bool is_joint = step.slopes == Slopes::joint;
    const SlopePoint start{"s.q", "s.p", step.depends_on_time() ? "x.t" : ""};
    const SlopePoint inner{"s.Q[i]", "s.P[i]", time_of_thread(step, "i")};
    Writer writer(2);
    SlopesOfStages slopes(writer, step);
    writer.line("/// Sets starting values: slopes as at the start of the step.");
    writer.open("HVI_DEVICE void begin() {{");
    slopes.write(start, true, !step.is_separable(), true);
    writer.close().blank();
    writer.open("HVI_DEVICE void sweep() {{").line("s.momenta(by.{});", table_mt(step));
    if (!is_joint) { slopes.write(inner, false, true, false); }
    writer.line("positions();").close().blank();
    writer.open("HVI_DEVICE void evaluate() {{");
    slopes.write(inner, false, is_joint, true);
    return writer.close().str();
}

std::string solve_text(const Step& step) {
    Writer writer(2);
    const std::vector<std::string_view> kept = slopes_for_next(step);
    begin_step(writer);
    writer.line("Stages s(x);");
    writer.line("Coupled coupled{{system_, by, {}s}};", step.depends_on_time() ? "x, " : "");
    if (kept.empty()) {
        writer.line("coupled.begin();");
    } else {
        writer.line("const bool extrapolates = x.size_of_step == by.h;");
        writer.line("if (!extrapolates) {{ coupled.begin(); }}").open("if (extrapolates) {{");
        for (const std::string_view of : kept) {
            writer.line("s.extrapolate(by.N, x.slopes_{0}, s.L{0});", of);
        }
        writer.close();
    }
    writer.blank()
        .line("x.status = hvi::device::solve(coupled, x.iterations);")
        .line("if (x.status != hvi::Status::Code::ok) {{ return; }}")
        .line("s.advance();");
    end_step(writer, step, "s.q", "s.p");
    writer.line("hvi::device::store(s.remainder_q, x.remainder_q);")
        .line("hvi::device::store(s.remainder_p, x.remainder_p);");
    if (kept.empty()) { return writer.str(); }
    writer.open("for (std::size_t i = 0; i < {}; ++i) {{", step.positions.size());
    for (const std::string_view of : kept) {
        writer.line("hvi::device::store(s.L{0}[i], x.slopes_{0}[i]);", of);
    }
    return writer.close().line("x.size_of_step = by.h;").str();
}

}  // namespace

ThreadParts thread_parts(const Step& step, const PairStep& form, const ThreadSizes& sizes) {
    const auto& [dimension, class_name] = sizes;
    ThreadParts parts;
    parts.runtime = {"detail/device/math", "detail/device/stages"};
    parts.constants = constants_text(step, form, {});
    parts.state = state_of_stages(step, dimension);
    parts.steps = steps_of_stages(step, class_name);
    parts.step = solve_text(step);
    parts.coupled =
        fill_part("thread_stages.hpp.in",
                  {{"unknowns", unknowns(step.blocks.front())},
                   {"stages", thread_stages_type(step, dimension)},
                   {"time", step.depends_on_time() ? "const State& x;" : ""},
                   {"watch", fmt::format("hvi::device::RoundOff<Number, {}>", dimension)},
                   {"separable", std::string(truth(step.is_separable()))},
                   {"joint", std::string(truth(step.slopes == Slopes::joint))},
                   {"slopes", slopes_of_thread(step)}});
    return parts;
}

}  // namespace hvi::gen

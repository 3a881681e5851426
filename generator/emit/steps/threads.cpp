// Headers of steppers whose trajectories are threads of a GPU.
// SPDX-License-Identifier: GPL-2.0-or-later

#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/explicit_moves.hpp"
#include "generator/emit/steps/header.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/slope_calls.hpp"
#include "generator/emit/steps/system_part.hpp"
#include "generator/emit/system/class_values.hpp"
#include "generator/support/error.hpp"
#include "src/hvi/version.hpp"

namespace hvi::gen {
namespace {

/// Parts of the header; see templates/threads.hpp.in.
struct ThreadParts {
    std::vector<std::string> runtime;
    std::string state, steps, step, constants, coupled;
};

/// Degrees of freedom, and the name of the class.
struct ThreadSizes {
    std::size_t dimension;
    std::string_view class_name;
};

// ---- what every form has ----

/// Writes the members of a state that each step moves.
void write_state(Writer& writer, const Step& step, std::size_t dimension) {
    writer.line("hvi::device::Vector<Number, {}> q{{}}, p{{}};", dimension);
    if (step.depends_on_time()) { writer.line("Number t = 0;"); }
    writer.line("hvi::Status::Code status = hvi::Status::Code::ok;  // of the last step");
    writer.line("std::int64_t steps = 0;                            // how many went well").blank();
}

/// Writes what rounding has cut off from the time.
void write_remainder_of_time(Writer& writer, const Step& step) {
    if (step.depends_on_time()) { writer.line("Number remainder_t = 0;"); }
}

/// Returns the lines that begin a step, before anything is computed.
void begin(Writer& writer) {
    writer.line("if (by.h == 0 || x.status != hvi::Status::Code::ok) {{ return; }}");
}

/// Writes the check of the end, where `q` and `p` are the values there, and what moves x.
void end(Writer& writer, const Step& step, std::string_view q, std::string_view p) {
    std::string finite = fmt::format("hvi::device::are_finite({}, {})", q, p);
    if (step.depends_on_time()) {
        writer.line("const hvi::device::Sum<Number> time = hvi::device::time_after(x, by.h);");
        finite += " && hvi::device::is_finite(time.value)";
    }
    writer.open("if (!({})) {{", finite)
        .line("x.status = hvi::Status::Code::not_finite;")
        .line("return;")
        .close();
    writer.line("hvi::device::store({}, x.q);", q).line("hvi::device::store({}, x.p);", p);
    if (step.depends_on_time()) {
        writer.line("x.t = time.value.value;").line("x.remainder_t = time.remainder.value;");
    }
    writer.line("++x.steps;");
}

// ---- explicit ----

/// Returns whether any move takes its size from a table of these weights.
bool has_sizes(std::string_view table, const std::string& constants) {
    return constants.find(fmt::format(" {}[", table)) != std::string::npos;
}

std::string state_of_moves(const Step& step, Sums sums, std::size_t dimension) {
    Writer writer(2);
    write_state(writer, step, dimension);
    write_remainder_of_time(writer, step);
    if (sums == Sums::compensated) {
        writer.line("hvi::device::Vector<Number, {}> remainder_q{{}}, remainder_p{{}};", dimension);
    }
    if (step.kept.any()) {
        writer.line("hvi::device::Vector<Number, {}> slope{{}};  // the first of the next step",
                    dimension);
        writer.line("bool knows_slope = false;");
    }
    return writer.str();
}

/// Writes the sizes of moves, and the times of stages.
std::string steps_of_moves(const Step& step, Sums sums, const std::string& constants) {
    Writer body(3), members(2);
    members.line("Number h;");
    const auto add = [&](std::string_view name, std::string_view table, std::size_t count,
                         std::string_view how) {
        if (!has_sizes(table, constants)) { return; }
        body.line("hvi::device::{}(h, {}, {});", how, table, name);
        members.line("hvi::device::Vector<Number, {}> {}{{}};", count, name);
    };
    const std::string_view how = sums == Sums::compensated ? "weigh" : "scale";
    add("p", "b_p", step.positions.size(), how);
    add("q", "b_q", step.momenta.size(), how);
    add("t", "c", step.c.size(), "scale");
    Writer writer(2);
    writer.open("explicit Steps(Number size) : h(size) {{").insert(body.str()).close().blank();
    return writer.insert(members.str()).str();
}

ThreadParts thread_parts(const Step& step, const ExplicitStep& form, const ThreadSizes& sizes) {
    const std::size_t dimension = sizes.dimension;
    ThreadParts parts;
    parts.runtime = {"detail/device/math", "detail/device/steps"};
    parts.constants = weights_text(step);
    parts.state = state_of_moves(step, form.sums, dimension);
    parts.steps = steps_of_moves(step, form.sums, parts.constants);
    const bool is_apart = form.sums == Sums::compensated;
    Writer writer(2);
    begin(writer);
    const auto load = [&](std::string_view name, std::string_view from) {
        writer.line("Values {} = hvi::device::load(x.{});", name, from);
    };
    load("q", "q");
    load("p", "p");
    if (is_apart) {
        load("dq", "remainder_q");
        load("dp", "remainder_p");
    }
    if (!step.kept.force || !step.kept.velocity) { writer.line("Values slope{{}};"); }
    if (step.kept.any()) { load("kept", "slope"); }
    writer.blank().insert(thread_moves_text(step, form.sums, dimension));
    if (is_apart) {
        writer.line("hvi::device::add(x.q, dq, q);").line("hvi::device::add(x.p, dp, p);");
    }
    end(writer, step, "q", "p");
    if (is_apart) {
        writer.line("hvi::device::store(dq, x.remainder_q);");
        writer.line("hvi::device::store(dp, x.remainder_p);");
    }
    if (step.kept.any()) {
        writer.line("hvi::device::store(kept, x.slope);").line("x.knows_slope = true;");
    }
    parts.step = writer.str();
    return parts;
}

// ---- implicit ----

std::string stages_type(const Step& step, std::size_t dimension) {
    return fmt::format("hvi::device::Stages<Number, {}, {}>", dimension, step.positions.size());
}

/// Returns whether slopes of one step are starting values of the next, and which.
std::vector<std::string_view> kept_slopes(const Step& step) {
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
    for (const std::string_view of : kept_slopes(step)) {
        writer.line("hvi::device::Vector<Number, {}> slopes_{}[{}]{{}};", dimension, of,
                    step.positions.size());
    }
    if (!kept_slopes(step).empty()) { writer.line("Number size_of_step = 0;  // of these slopes"); }
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
    if (!kept_slopes(step).empty()) { table("N"); }
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

std::string slopes_text(const Step& step) {
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
    const std::vector<std::string_view> kept = kept_slopes(step);
    begin(writer);
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
    end(writer, step, "s.q", "s.p");
    writer.line("hvi::device::store(s.remainder_q, x.remainder_q);")
        .line("hvi::device::store(s.remainder_p, x.remainder_p);");
    if (kept.empty()) { return writer.str(); }
    writer.open("for (std::size_t i = 0; i < {}; ++i) {{", step.positions.size());
    for (const std::string_view of : kept) {
        writer.line("hvi::device::store(s.L{0}[i], x.slopes_{0}[i]);", of);
    }
    return writer.close().line("x.size_of_step = by.h;").str();
}

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
                   {"stages", stages_type(step, dimension)},
                   {"time", step.depends_on_time() ? "const State& x;" : ""},
                   {"watch", fmt::format("hvi::device::RoundOff<Number, {}>", dimension)},
                   {"separable", std::string(truth(step.is_separable()))},
                   {"joint", std::string(truth(step.slopes == Slopes::joint))},
                   {"slopes", slopes_text(step)}});
    return parts;
}

template <class Form>
ThreadParts thread_parts(const Step&, const Form&, const ThreadSizes&) {
    HVI_CHECK(false && "see obstacle_to_threads()");
    return {};
}

// ---- members of the class ----

/// Writes what takes a state to a value of the system: `system_.energy(q, p, t)`.
void write_value(Writer& writer, const ClassValue& value) {
    writer.comment(value.about, "/// ");
    writer.open("[[nodiscard]] HVI_DEVICE Number {}(const State& x) const {{", value.name)
        .line("return system_.{}(hvi::device::load(x.q), hvi::device::load(x.p){}).value;",
              value.name, value.has_time ? ", x.t" : "")
        .close()
        .blank();
}

std::string members_text(const System& system, const SceneWishes& wishes,
                         std::string_view class_name) {
    Writer writer(1);
    writer.line("HVI_DEVICE explicit {}(const Parameters& parameters) : system_(parameters) {{}}",
                class_name);
    writer.blank();
    if (!system.initial.empty()) {
        writer.line("/// Where the scene begins.")
            .open("[[nodiscard]] HVI_DEVICE static State initial(const Parameters& parameters) {{")
            .line("typename System::Vector q{{}}, p{{}};")
            .line("System::begin(parameters, q, p);")
            .line("State x;")
            .line("hvi::device::store(q, x.q);")
            .line("hvi::device::store(p, x.p);")
            .line("return x;")
            .close()
            .line("[[nodiscard]] static State initial() {{ return initial(Parameters{{}}); }}")
            .blank();
    }
    for (const ClassValue& value : values_of_class(system, wishes)) {
        if (!value.about.empty()) { write_value(writer, value); }
    }
    return writer.str();
}

}  // namespace

std::string emit_threads(const OneStepMethod& method, const Step& step,
                         const EmitOptions& options) {
    HVI_CHECK(options.system != nullptr);
    const SystemPart system = system_part(method, step, options);
    const ThreadSizes sizes{options.system->degrees_of_freedom(), system.class_name};
    ThreadParts parts =
        std::visit([&](const auto& form) { return thread_parts(step, form, sizes); }, step.form);
    Holes holes = holes_of(system);
    holes["construct"] = members_text(*options.system, options.wishes, system.class_name);
    holes.merge(Holes{{"format", std::to_string(hvi::runtime_format)},
                      {"runtime", runtime_includes(std::move(parts.runtime))},
                      {"state", parts.state},
                      {"steps", parts.steps},
                      {"step", parts.step},
                      {"constants", parts.constants},
                      {"coupled", parts.coupled}});
    return fill("threads.hpp.in", holes);
}

}  // namespace hvi::gen

// Headers of steppers whose trajectories are threads of a GPU.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/threads.hpp"

#include "generator/emit/steps/explicit_moves.hpp"
#include "generator/emit/steps/header.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/system_part.hpp"
#include "generator/emit/system/class_values.hpp"
#include "generator/support/error.hpp"
#include "src/hvi/version.hpp"

namespace hvi::gen {

void write_state(Writer& writer, const Step& step, std::size_t dimension) {
    writer.line("hvi::device::Vector<Number, {}> q{{}}, p{{}};", dimension);
    if (step.depends_on_time()) { writer.line("Number t = 0;"); }
    writer.line("hvi::Status::Code status = hvi::Status::Code::ok;  // of the last step");
    writer.line("std::int64_t steps = 0;                            // how many went well").blank();
}

void write_remainder_of_time(Writer& writer, const Step& step) {
    if (step.depends_on_time()) { writer.line("Number remainder_t = 0;"); }
}

void begin_step(Writer& writer) {
    writer.line("if (by.h == 0 || x.status != hvi::Status::Code::ok) {{ return; }}");
}

void end_step(Writer& writer, const Step& step, std::string_view q, std::string_view p) {
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

namespace {

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
    begin_step(writer);
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
    end_step(writer, step, "q", "p");
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

std::string thread_members_text(const System& system, const SceneWishes& wishes,
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
    holes["construct"] = thread_members_text(*options.system, options.wishes, system.class_name);
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

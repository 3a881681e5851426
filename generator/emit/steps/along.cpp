// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/along.hpp"

#include "generator/emit/steps/clock.hpp"

namespace hvi::gen {
namespace {

bool carries_directions(const Step& step) { return step.carries == Carries::directions; }

bool of_pairs(const Step& step) { return std::holds_alternative<PairStep>(step.form); }

/// Returns whether a step is flows, which carry directions by the runtime alone.
bool of_flows(const Step& step) { return std::holds_alternative<FlowStep>(step.form); }

bool takes_parts(const Step& step) { return step.iteration()->takes_parts(); }

/// How directions extrapolate their slopes, as stages in lanes do. NOTE: those of the others have
/// tables for the stages that are solved for alone.
std::string slopes_before(const Step& step) {
    const Iteration& iteration = *step.iteration();
    if (iteration.extrapolation.empty() || step.layout != Layout::stages) { return "{}"; }
    const char* const part = iteration.takes_parts() ? "[part]" : "";
    return iteration.extrapolation.front().before
               ? fmt::format("{{&N_lanes{0}, &N_before_lanes{0}}}", part)
               : fmt::format("{{&N_lanes{}}}", part);
}

/// Stages from their slopes, all at once, and what the system keeps of them.
///
/// NOTE: once more, as those that solvers leave are of slopes before the last.
void keep_of_lanes(Writer& writer, const Step& step) {
    const std::string_view time = step.depends_on_time() ? ", hvi::detail::lane_row(clock_.t)" : "";
    if (of_pairs(step)) {
        writer.line("s_.positions(m_lanes);").line("s_.momenta({}_lanes);", table_mt(step));
        writer.line("auto kept = along.kept();");
        writer.line("system_.keep(along.lanes(s_.Q), along.lanes(s_.P){}, kept);", time);
    } else {
        writer.line("s_.positions(cn_lanes);").line("auto kept = along.kept();");
        writer.line("system_.keep_q(along.lanes(s_.Q){}, kept);", time);
    }
}

/// Stages from their slopes, one by one, with x where the step begins, and what the system keeps of
/// each.
void keep_of_each(Writer& writer, const Step& step) {
    const std::string time = time_of_stage(step, "i", "s_");
    const std::string behind = time.empty() ? time : ", " + time;
    writer.open("along.keep([&](std::size_t i, auto& kept) {{");
    if (of_pairs(step)) {
        writer.line("const Vector q = hvi::detail::stage_value(x.q, m_lanes, i, s_.Lq, "
                    "s_.remainder.q);");
        writer.line("const Vector p = hvi::detail::stage_value(x.p, {}_lanes, i, s_.Lp, "
                    "s_.remainder.p);",
                    table_mt(step));
        writer.line("system_.keep(q, p{}, kept);", behind);
    } else {
        writer.line("const Vector q = hvi::detail::stage_value(x.q, cn_lanes.n, i, s_.W, "
                    "s_.drifted[i]);");
        writer.line("system_.keep_q(q{}, kept);", behind);
    }
    writer.close("});");
}

std::string carry_text(const Step& step) {
    Writer writer(1);
    writer.blank().comment("Carries directions along the step, whose slopes are known.", "/// ");
    writer.open("[[nodiscard]] Status carry({}Along& along{}, int iterations) {{",
                step.layout == Layout::stages ? "" : "const State& x, ",
                takes_parts(step) ? ", [[maybe_unused]] std::size_t part" : "");
    if (step.layout == Layout::stages) {
        keep_of_lanes(writer, step);
    } else {
        keep_of_each(writer, step);
    }
    const std::string table = of_pairs(step) ? fmt::format("{{m_lanes, {}_lanes}}", table_mt(step))
                                             : std::string("cn_lanes");
    writer.line("const Status status = along.carry(system_, s_, {}, {{{}, {}}}, {});", table,
                of_pairs(step) ? weights_q(step) : weights_p(step), weights_p(step),
                slopes_before(step));
    return writer.line("return Status(status.code(), iterations);").close().str();
}

/// Tables in lanes, which stages one by one do not have.
std::string tables_text(const Step& step) {
    Writer writer(1);
    const auto columns = [&](std::string_view name) {
        writer.line("static constexpr auto {0}_lanes = hvi::detail::lane_columns({0});", name);
    };
    writer.blank();
    if (!of_pairs(step)) {
        return writer
            .line("static constexpr hvi::detail::VelocityTable<Scalar, stages> cn_lanes{{c, n}};")
            .str();
    }
    columns("m");
    if (table_mt(step) != "m") { columns(table_mt(step)); }
    return writer.str();
}

}  // namespace

std::string type_of_along(const Step& step, const Evaluations* evaluations) {
    if (!carries_directions(step) || of_flows(step)) { return {}; }
    const DirectionKernels& kernels = *evaluations->directions;
    Writer writer(1);
    writer.blank().line("/// Directions that a step carries along; see hvi/directions.hpp.");
    if (std::holds_alternative<ExplicitStep>(step.form)) {
        return writer
            .line("using Along = hvi::detail::MovesAlong<Vector, {}, {}>;",
                  kernels.by_q.kept.size(), kernels.by_p.kept.size())
            .str();
    }
    const std::string width =
        step.register_width == widest_register ? "" : fmt::format(", {}", step.register_width);
    return writer
        .line("using Along = hvi::detail::StagesAlong<hvi::detail::{}OfDirections, Vector, {}, "
              "{}{}>;",
              of_pairs(step) ? "Pairs" : "Positions", step.positions.size(),
              (of_pairs(step) ? kernels.both : kernels.by_q).kept.size(), width)
        .str();
}

std::string include_of_along(const Step& step) {
    if (!carries_directions(step) || of_flows(step)) { return {}; }
    return fmt::format("#include <hvi/detail/directions/{}_along.hpp>\n\n",
                       std::holds_alternative<ExplicitStep>(step.form) ? "moves" : "stages");
}

std::string along_argument(const Step& step, StepFunction function) {
    if (!carries_directions(step)) { return {}; }
    return function == StepFunction::whole ? ", Along* along = nullptr" : ", Along* along";
}

std::string_view along_passed(const Step& step) {
    return carries_directions(step) ? ", along" : "";
}

std::string carry_by_move(const Step& step, const Move& move, std::string_view at,
                          std::string_view size) {
    if (!carries_directions(step)) { return {}; }
    const std::string time =
        move.kick ? time_of_stage(step, std::to_string(move.index), "s_") : std::string();
    return Writer(2)
        .line("if (along != nullptr) {{ along->{}(system_, {}, {}{}{}); }}",
              move.kick ? "kick" : "drift", at, size, time.empty() ? "" : ", ", time)
        .str();
}

std::string end_of_moves(const Step& step) {
    if (!carries_directions(step)) { return {}; }
    return Writer(2)
        .open("if (along != nullptr && !along->is_finite()) {{")
        .line("return Status(Status::Code::not_finite);")
        .close()
        .str();
}

std::string call_of_carry(const Step& step) {
    if (!carries_directions(step)) { return {}; }
    return Writer(2)
        .open("if (along != nullptr) {{")
        .line("status = carry({}*along{}, status.iterations);",
              step.layout == Layout::stages ? "" : "x, ", takes_parts(step) ? ", part" : "")
        .line("if (!status.ok()) {{ return status; }}")
        .close()
        .str();
}

void add_carry(ImplicitParts& parts, const Step& step) {
    if (!carries_directions(step)) { return; }
    parts.predict += "\n" + carry_text(step);
    if (step.layout == Layout::stages) { return; }
    parts.constants += tables_text(step);
    parts.runtime.push_back(of_pairs(step) ? "detail/lanes/stage_lanes"
                                           : "detail/lanes/velocity_lanes");
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/clock.hpp"

#include "generator/emit/steps/curve_tables.hpp"
#include "generator/emit/steps/header.hpp"

namespace hvi::gen {
namespace {

/// Returns the text where H depends on time, else nothing.
std::string timed(const Step& step, std::string_view text) {
    return step.depends_on_time() ? std::string(text) : std::string();
}

std::string_view clock(std::string_view s) { return s == "s_" ? "clock_" : "clock"; }

bool is_of_flows(const Step& step) { return std::holds_alternative<FlowStep>(step.form); }

std::string type(const Step& step) {
    if (is_of_flows(step)) { return "hvi::detail::FlowClock<Scalar>"; }
    return fmt::format("hvi::detail::Clock<Scalar, {}>", step.positions.size());
}

}  // namespace

std::string time_of_stage(const Step& step, std::string_view i, std::string_view s) {
    return timed(step, fmt::format("{}.t[{}]", clock(s), i));
}

std::string time_of_start(const Step& step, std::string_view s) {
    return timed(step, fmt::format("{}.start", clock(s)));
}

std::string time_of_thread(const Step& step, std::string_view i) {
    return timed(step, fmt::format("hvi::device::time_at(x, by.t[{}])", i));
}

std::string times_of_lanes(const Step& step) {
    return timed(step, "hvi::detail::lane_row(clock.t)");
}

std::string time_of_trajectories(const Step& step, std::string_view expression) {
    return timed(step, expression);
}

std::string clock_member(const Step& step) { return timed(step, type(step) + " clock_;"); }

std::string clock_reference(const Step& step) {
    return timed(step, fmt::format("const {}& clock;", type(step)));
}

std::string clock_begins(const Step& step, std::string_view forget) {
    const std::string c = is_of_flows(step)   ? ""
                          : has_adjoint(step) ? ", is_adjoint_ ? c_of_adjoint : c"
                                              : fmt::format(", {}c", owner(step, "s_"));
    return timed(step, fmt::format("if (!clock_.begin(x.t, h{})) {{ {}; }}\n"
                                   "if (!clock_.ends()) {{ return "
                                   "Status(Status::Code::not_finite); }}",
                                   c, forget));
}

std::string clock_ends(const Step& step, std::string_view status) {
    return step.depends_on_time() ? fmt::format("clock_.end(x.t, {})", status)
                                  : std::string(status);
}

std::string_view clock_ends_well(const Step& step) {
    return step.depends_on_time() ? "clock_.end(x.t, Status{})" : "{}";
}

std::string times_text(const Step& step) {
    if (!step.depends_on_time()) { return {}; }
    std::vector<Constant> c, c_of_adjoint;
    for (std::size_t i = 0; i < step.c.size(); ++i) {
        const Number other = Number(1) - step.c[i];
        c.push_back({fmt::format("c_{}", i + 1), nearest(step.c[i]), exact_text(step.c[i])});
        c_of_adjoint.push_back({fmt::format("1 - c_{}", i + 1), nearest(other), exact_text(other)});
    }
    Writer writer(1);
    table(writer, "c", c);
    if (has_adjoint(step)) { table(writer, "c_of_adjoint", c_of_adjoint); }
    return writer.str();
}

std::string_view clock_argument(const Step& step) {
    return step.depends_on_time() ? "clock_, " : "";
}

std::vector<std::string> clock_runtime(const Step& step) {
    if (!step.depends_on_time()) { return {}; }
    return {"detail/stages/clock"};
}

std::string_view state_type(const Step& step) {
    return step.depends_on_time() ? "hvi::TimedState<Vector>" : "hvi::State<Vector>";
}

std::string_view trajectory_argument(const Step& step) {
    return step.depends_on_time() ? ", Trajectory" : "";
}

}  // namespace hvi::gen

// Headers of methods that solve stage equations.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "generator/emit/steps/along.hpp"
#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/curve_tables.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/system_part.hpp"
#include "src/hvi/version.hpp"

namespace hvi::gen {

std::vector<std::string> solver_headers(const Step& step, SeldomSolvers seldom) {
    const Iteration* iteration = step.iteration();
    if (iteration == nullptr) { return {}; }
    const std::string newton = newton_policy(step).header;
    switch (iteration->solver) {
    case Solver::of_user:
    case Solver::fixed_point: break;
    case Solver::newton: return {"detail/solvers/" + newton};
    case Solver::newton_taylor: return {"detail/solvers/newton_taylor"};
    case Solver::sweeps: return {"fixed_sweeps"};
    case Solver::automatic: {
        std::vector<std::string> headers{step.corrections ? "detail/solvers/automatic_of_lanes"
                                                          : "detail/solvers/automatic",
                                         "detail/solvers/" + newton};
        if (seldom != SeldomSolvers::within) { headers.emplace_back("detail/solvers/apart"); }
        return headers;
    }
    }
    return {"fixed_point"};
}

std::string runtime_includes(std::vector<std::string> names) {
    names.emplace_back("detail/stepper");
    std::sort(names.begin(), names.end());
    Writer writer(0);
    for (const std::string& name : names) { writer.line("#include <hvi/{}.hpp>", name); }
    return writer.str();
}

namespace {

ImplicitParts parts_of(const Step& step, const auto& form, const SceneWishes& wishes) {
    return step.layout == Layout::stages ? lane_parts(step, form, wishes)
                                         : parts(step, form, wishes);
}

ImplicitParts parts_of(const Step& step, const GalerkinStep& form, const SceneWishes& wishes) {
    return parts(step, form, wishes);
}

bool takes_parts(const Step& step) {
    const Iteration* iteration = step.iteration();
    return iteration != nullptr && iteration->takes_parts();
}

/// The function of a step, or of one of several in a row. NOTE: the action looks at the time
/// itself.
std::string one_step(const Step& step, const std::string& body, const EmitOptions& options) {
    const bool has_parts = takes_parts(step);
    return fill_part(
        "step.hpp.in",
        {{"name", step.in_a_row.empty() ? "step" : "part_of_step"},
         {"part", has_parts ? ", std::size_t part, Scalar size_before" : ""},
         {"along",
          along_argument(step, step.in_a_row.empty() ? StepFunction::whole : StepFunction::part)},
         {"sizes", has_parts ? "h, size_before" : "h"},
         {"begins", begins(step)},
         {"clock", clock_begins(step, options.wishes.action ? "s_.forget()" : "reset()")},
         {"steps", body}});
}

std::string composed_step(const Step& step, bool has_action) {
    const bool alternates = has_adjoint(step);
    const auto where = [&](std::string_view text) { return std::string(has_action ? text : ""); };
    const std::string status = "Status(Status::Code::ok, iterations)";
    return fill_part(
        "composed_step.hpp.in",
        {{"along", along_argument(step, StepFunction::whole)},
         {"part",
          fmt::format("sizes[k]{}{}",
                      takes_parts(step) ? ", k, sizes[(k == 0 ? sizes.size() : k) - 1]" : "",
                      along_passed(step))},
         {"first", alternates ? "is_adjoint_ = false;" : ""},
         {"next", alternates ? "is_adjoint_ = !is_adjoint_;" : ""},
         {"integral", where("Scalar integral = 0;")},
         {"add", where("integral += integral_over_step();")},
         {"begins", where("action_.begin(x, integral);")},
         {"status", has_action ? fmt::format("action_.end(x, {})", status) : status}});
}

std::string emit_implicit(const OneStepMethod& method, const Step& step, const auto& form,
                          const EmitOptions& options) {
    const SystemPart system = system_part(method, step, options);
    const bool has_action = options.wishes.action;
    ImplicitParts parts = parts_of(step, form, options.wishes);
    add_carry(parts, step);
    for (const std::string& header : clock_runtime(step)) { parts.runtime.push_back(header); }
    if (options.wishes.curve) { parts.runtime.push_back("detail/stages/curve"); }
    if (options.wishes.float128) { parts.runtime.push_back("detail/numbers/math"); }
    for (const std::string& header : solver_headers(step, options.seldom)) {
        parts.runtime.push_back(header);
    }
    const bool composes = !step.in_a_row.empty();
    const std::string step_text = one_step(step, parts.steps, options);
    Holes holes = holes_of(system);
    holes.merge(Holes{{"format", std::to_string(hvi::runtime_format)},
                      {"runtime", runtime_includes(std::move(parts.runtime))},
                      {"parameter", parameter_text(step)},
                      {"state", system.state},
                      {"curve", parts.curve},
                      {"step", composes ? composed_step(step, has_action) : step_text},
                      {"part", composes ? step_text : ""},
                      {"action", parts.action},
                      {"integral", parts.integral},
                      {"forget", has_action ? "s_.forget(); action_.forget();" : "s_.forget();"},
                      {"constants", parts.constants},
                      {"predict", parts.predict},
                      {"coupled", parts.coupled},
                      {"members", parts.members}});
    return fill("implicit.hpp.in", holes);
}

}  // namespace

std::string emit_one(const OneStepMethod& method, const Step& step, const PairStep& form,
                     const EmitOptions& options) {
    return emit_implicit(method, step, form, options);
}

std::string emit_one(const OneStepMethod& method, const Step& step, const VelocityStep& form,
                     const EmitOptions& options) {
    return emit_implicit(method, step, form, options);
}

std::string emit_one(const OneStepMethod& method, const Step& step, const GalerkinStep& form,
                     const EmitOptions& options) {
    return emit_implicit(method, step, form, options);
}

}  // namespace hvi::gen

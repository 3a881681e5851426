// Headers of methods that solve stage equations.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "generator/emit/steps/banner.hpp"
#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/system_part.hpp"
#include "src/hvi/version.hpp"

namespace hvi::gen {

namespace {

std::vector<std::string> solver_headers(const Step& step) {
    const Iteration* iteration = step.iteration();
    if (iteration == nullptr) { return {}; }
    const bool has_momenta = std::holds_alternative<PairStep>(step.form);
    const std::string newton = has_momenta ? "newton_pairs" : "newton_positions";
    switch (iteration->solver) {
    case Solver::of_user:
    case Solver::fixed_point: break;
    case Solver::newton: return {"detail/solvers/" + newton};
    case Solver::newton_taylor: return {"detail/solvers/newton_taylor"};
    case Solver::automatic: return {"detail/solvers/automatic", "detail/solvers/" + newton};
    }
    return {"fixed_point"};
}

}  // namespace

std::string runtime_includes(std::vector<std::string> names) {
    names.emplace_back("detail/stepper");
    std::sort(names.begin(), names.end());
    Writer writer(0);
    for (const std::string& name : names) { writer.line("#include <hvi/{}.hpp>", name); }
    return writer.str();
}

namespace {

std::string emit_implicit(const OneStepMethod& method, const Step& step, const auto& form,
                          const EmitOptions& options) {
    const SystemPart system = system_part(method, step, options);
    const bool has_action = options.wishes.action;
    ImplicitParts parts = step.layout == Layout::stages
                              ? lane_parts(step, form, options.wishes)
                              : hvi::gen::parts(step, form, options.wishes);
    for (const std::string& header : clock_runtime(step)) { parts.runtime.push_back(header); }
    if (options.wishes.curve) { parts.runtime.push_back("detail/stages/curve"); }
    if (options.wishes.float128) { parts.runtime.push_back("detail/numbers/math"); }
    for (const std::string& header : solver_headers(step)) { parts.runtime.push_back(header); }
    Holes holes = holes_of(system);
    holes.merge(Holes{{"banner", banner(method, step, options)},
                      {"format", std::to_string(hvi::runtime_format)},
                      {"runtime", runtime_includes(std::move(parts.runtime))},
                      {"parameter", parameter_text(step)},
                      {"state", system.state},
                      {"curve", parts.curve},
                      {"action", parts.action},
                      {"integral", parts.integral},
                      {"forget", has_action ? "s_.forget(); action_.forget();" : "s_.forget();"},
                      {"begins", begins(step)},
                      // NOTE: the action looks at the time itself.
                      {"clock", clock_begins(step, has_action ? "s_.forget()" : "reset()")},
                      {"steps", parts.steps},
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

}  // namespace hvi::gen

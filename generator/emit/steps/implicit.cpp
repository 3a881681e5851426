// Headers of methods that solve stage equations.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "generator/emit/steps/banner.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/system_part.hpp"
#include "src/hvi/version.hpp"

namespace hvi::gen {

namespace {

std::vector<std::string> solver_headers(const Scheme& scheme) {
    const std::string newton = scheme.velocity_form ? "newton_positions" : "newton_pairs";
    if (scheme.is_explicit()) { return {}; }
    switch (scheme.solver) {
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

std::string emit_implicit(const Tableau& tableau, const Scheme& scheme,
                          const EmitOptions& options) {
    const SystemPart system = system_part(tableau, scheme, options);
    ImplicitParts parts = scheme.has_stage_lanes ? lane_parts(scheme, options.wishes)
                          : scheme.velocity_form ? velocity_parts(scheme, options.wishes)
                                                 : pair_parts(scheme, options.wishes);
    if (scheme.depends_on_time) { parts.runtime.push_back("detail/stages/clock"); }
    if (options.wishes.curve) { parts.runtime.push_back("detail/stages/curve"); }
    if (options.wishes.float128) { parts.runtime.push_back("detail/numbers/math"); }
    for (const std::string& header : solver_headers(scheme)) { parts.runtime.push_back(header); }
    Holes holes = holes_of(system);
    holes.merge(Holes{{"banner", banner(tableau, scheme, options)},
                      {"format", std::to_string(hvi::runtime_format)},
                      {"runtime", runtime_includes(std::move(parts.runtime))},
                      {"parameter", parameter_text(scheme)},
                      {"state", system.state},
                      {"curve", parts.curve},
                      {"begins", begins(scheme)},
                      {"clock", clock_begins(scheme)},
                      {"steps", parts.steps},
                      {"constants", parts.constants},
                      {"predict", parts.predict},
                      {"coupled", parts.coupled},
                      {"members", parts.members}});
    return fill("implicit.hpp.in", holes);
}

}  // namespace hvi::gen

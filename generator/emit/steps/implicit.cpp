// Headers of methods that solve stage equations.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "generator/emit/steps/banner.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/system_part.hpp"

namespace hvi::gen {

namespace {

std::vector<std::string> solver_headers(const Scheme& scheme) {
    const std::string newton = scheme.velocity_form ? "newton_positions.hpp" : "newton_pairs.hpp";
    if (scheme.is_explicit()) { return {}; }
    switch (scheme.solver) {
    case Solver::of_user:
    case Solver::fixed_point: break;
    case Solver::newton: return {newton};
    case Solver::newton_taylor: return {"newton_taylor.hpp"};
    case Solver::automatic: return {"automatic.hpp", newton};
    }
    return {"fixed_point.hpp"};
}

}  // namespace

std::string runtime_includes(std::vector<std::string> names) {
    for (const char* name : {"arithmetic.hpp", "coefficients.hpp", "rounded.hpp", "scalar.hpp",
                             "state.hpp", "system.hpp", "version.hpp"}) {
        names.emplace_back(name);
    }
    std::sort(names.begin(), names.end());
    Writer writer(0);
    for (const std::string& name : names) { writer.line("#include <hvi/{}>", name); }
    return writer.str();
}

std::string emit_implicit(const Tableau& tableau, const Scheme& scheme,
                          const EmitOptions& options) {
    const SystemPart system = system_part(tableau, scheme, options);
    ImplicitParts parts = scheme.has_stage_lanes ? lane_parts(scheme, options.wishes)
                          : scheme.velocity_form ? velocity_parts(scheme, options.wishes)
                                                 : pair_parts(scheme, options.wishes);
    if (scheme.depends_on_time) { parts.runtime.push_back("clock.hpp"); }
    if (options.wishes.curve) {
        parts.format = 4;
        parts.runtime.push_back("curve.hpp");
    }
    if (options.wishes.float128) { parts.runtime.push_back("math.hpp"); }
    if (options.scene != nullptr) {
        const bool is_of_8 =
            scheme.has_joint_slopes || (scheme.has_stage_lanes && scheme.extrapolation_before);
        parts.format = scheme.depends_on_time ? 9 : is_of_8 ? 8 : scheme.has_stage_lanes ? 6 : 5;
    }
    for (const std::string& header : solver_headers(scheme)) { parts.runtime.push_back(header); }
    Holes holes = holes_of(system);
    holes.merge(Holes{{"banner", banner(tableau, scheme, options)},
                      {"format", std::to_string(parts.format)},
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

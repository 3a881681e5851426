// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/facts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/lower/flow.hpp"

namespace hvi::gen {

namespace {

/// Returns `1 addition`, `7 multiplications`.
std::string counted(std::size_t count, std::string_view thing) {
    return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

std::string text(const OperationCounts& counts) {
    std::string result;
    const auto add = [&](std::size_t count, std::string_view thing) {
        if (count > 0) { result += (result.empty() ? "" : ", ") + counted(count, thing); }
    };
    add(counts.additions, "addition");
    add(counts.multiplications, "multiplication");
    add(counts.divisions, "division");
    add(counts.square_roots, "square root");
    add(counts.calls, "call");
    return result.empty() ? "nothing to compute" : result;
}

std::string text(const SolverCosts& costs) {
    const std::string linear =
        costs.linear > 0 ? fmt::format(", one with its linear part solved {}", costs.linear) : "";
    return fmt::format(
        "operations on registers of four stages: a sweep {}{}, one with a correction "
        "{}, its factors {}",
        costs.sweep, linear, costs.correction, costs.factors);
}

/// Returns the kind of L = v^T M v/2 + a v - U.
std::string kind_of_lagrangian(const System& system) {
    for (const std::vector<Scaled>& row : hessian_of(system).conjugates) {
        for (const Scaled& entry : row) {
            if (varies(system.graph.at(entry.node).roles)) {
                return "L is quadratic in v, and the mass matrix d2L/dv2 is not constant";
            }
        }
    }
    return "L is quadratic in v, with a constant mass matrix d2L/dv2";
}

std::string kind_of(const System& system) {
    const Structure& found = system.structure;
    if (system.side == Side::lagrangian) { return kind_of_lagrangian(system); }
    if (rotations_of(system) > 0) {
        return fmt::format("H is of {}, with three degrees of freedom each",
                           counted(bodies_of(system), "rotation"));
    }
    if (found.is_quadratic) { return "H is quadratic: Hamilton's equations are linear"; }
    if (found.is_linear_in_p && found.is_linear_in_q) { return "H is linear in q and in p"; }
    if (found.is_linear_in_p) { return "H is linear in p: it has no Lagrangian"; }
    if (found.is_linear_in_q) { return "H is linear in q"; }
    if (found.kinetic_is_quadratic) {
        return "H = T(p) + U(q), and T is quadratic with a constant matrix";
    }
    return found.is_separable ? "H = T(p) + U(q)" : "H is not seen to be T(p) + U(q)";
}

std::string names(const System& system, const std::vector<std::size_t>& degrees) {
    std::string result;
    for (const std::size_t i : degrees) {
        result += (result.empty() ? "" : ", ") + system.coordinates[i].name;
    }
    return result;
}

struct Entries {
    std::size_t all = 0, not_zero = 0, constant = 0;
};

Entries entries(const Graph& graph, const Hessian& hessian) {
    Entries result;
    const auto look = [&](const HessianBlock& block) {
        for (const std::vector<Scaled>& row : block) {
            for (const Scaled& entry : row) {
                ++result.all;
                if (entry.is_zero()) { continue; }
                ++result.not_zero;
                if (!varies(graph.at(entry.node).roles)) { ++result.constant; }
            }
        }
    };
    look(hessian.qq);
    look(hessian.mixed);
    look(hessian.mixed);  // and its transpose
    look(hessian.conjugates);
    return result;
}

/// Returns the cost of a linear map; see LinearMap and LinearIncrements of the runtime.
std::string cost_of_map(std::size_t n, bool is_sheared, bool has_offset) {
    const std::size_t multiplications = (is_sheared ? 3 : 12) * n * n;
    const std::size_t additions =
        is_sheared ? 3 * n * n + (has_offset ? 2 * n : 0) : 36 * n * n + 28 * n;
    return fmt::format("a step: {} and {}", counted(multiplications, "multiplication"),
                       counted(additions, "addition"));
}

/// Returns facts about sums with loops.
std::vector<std::string> facts_of_loops(const System& system) {
    std::vector<std::string> result{kind_of(system)};
    if (system.is_transformed) {
        result.insert(result.begin(), "H = p v - L, the kinetic energy being that of masses");
    }
    if (system.structure.is_quadratic) { result.emplace_back("H = T(p) + U(q)"); }
    if (system.time) { result.emplace_back("H depends on the time"); }
    for (const SystemSum& sum : system.sums) {
        std::string loops;
        for (const Loop& loop : sum.loops) {
            loops += fmt::format("{}{} = {}..{}", loops.empty() ? "" : ", ", loop.index,
                                 to_text(loop.range.first), to_text(loop.range.last));
        }
        result.push_back(fmt::format("{}{}, of {}", counted(sum.accesses.size(), "element"),
                                     loops.empty() ? " in a summand" : " in a sum over " + loops,
                                     sum.by_q.empty() && sum.by_conjugates.empty()
                                         ? "neither coordinates nor momenta"
                                     : sum.by_q.empty()          ? "momenta"
                                     : sum.by_conjugates.empty() ? "coordinates"
                                                                 : "both"));
    }
    if (system.sites) {
        result.push_back(fmt::format("a lattice of {}: a force needs sites that are near",
                                     counted(system.sites->ranges.size(), "index")));
    }
    return result;
}

/// Returns the function in place of H, and the meaning of its last variables.
std::vector<std::string> facts_of_scaled_time(const System& system) {
    return {fmt::format("time is scaled: it is the coordinate {}, and its momentum {} begins as -H",
                        system.coordinates.back().name, system.conjugates.back().name),
            "H here is K = " + to_text(system.expression)};
}

/// Returns the parts of H, and the work of their flows.
std::vector<std::string> costs_of_flows(const System& system, const FlowStep& form) {
    std::vector<std::string> result{"no unknowns: nothing is solved for"};
    const std::vector<HamiltonianPart>& parts = system.parts->parts;
    const std::vector<std::size_t> counts = form.counts();
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const HamiltonianPart& part = parts[k];
        result.push_back(fmt::format("flow of {} = {}, {}, {} in a step: {}", parts[k].name,
                                     text_of(part), part.flow,
                                     counts[k] == 1 ? "once" : fmt::format("{} times", counts[k]),
                                     text(counts_of_flow(system.graph, part))));
    }
    return result;
}

}  // namespace

std::vector<std::string> facts(const System& system) {
    std::vector<std::string> result;
    if (system.scaled) { result = facts_of_scaled_time(system); }
    if (!system.is_written_out()) {
        const std::vector<std::string> of_loops = facts_of_loops(system);
        result.insert(result.end(), of_loops.begin(), of_loops.end());
        return result;
    }
    const Structure& found = system.structure;
    const char f = system.function_letter();
    result.push_back(kind_of(system));
    if (found.is_quadratic && found.is_separable) { result.emplace_back("H = T(p) + U(q)"); }
    if (system.time) { result.push_back(fmt::format("{} depends on the time", f)); }
    const std::vector<std::size_t> cyclic = cyclic_coordinates(system);
    if (!cyclic.empty()) {
        result.push_back(fmt::format("{} does not depend on {}: the momenta are constant", f,
                                     names(system, cyclic)));
    }
    const Entries second = entries(system.graph, hessian_of(system));
    result.push_back(fmt::format("{} of {} second derivatives are not zero, {} constant",
                                 second.not_zero, second.all, second.constant));
    return result;
}

std::vector<std::string> costs(const System& system, const Step& step,
                               const Evaluations& evaluations) {
    const std::size_t n = system.degrees_of_freedom();
    // NOTE: the momenta of charts at the end of the step are solved for, too.
    const std::size_t unknowns =
        n * step.unknowns() + rotations_of_space.tangent * rotations_of(system);
    if (const auto* map = std::get_if<TabulatedStep>(&step.form)) {
        return {cost_of_map(n, map->as == TabulatedStep::As::shears,
                            has_linear_part(system.structure))};
    }
    if (const auto* flows = std::get_if<FlowStep>(&step.form)) {
        return costs_of_flows(system, *flows);
    }
    const std::string by_q = fmt::format("d{}/dq", system.function_letter());
    const std::string by_p =
        fmt::format("d{}/d{}", system.function_letter(), system.conjugate_letter());
    const std::size_t parts = step.in_a_row.size();
    const std::string where = parts == 0 ? "a step" : fmt::format("each of {} steps", parts);
    std::vector<std::string> result;
    result.push_back(unknowns == 0 ? "no unknowns: nothing is solved for"
                                   : fmt::format("{} are solved for in {}",
                                                 counted(unknowns, "unknown"), where));
    if (step.slopes == Slopes::joint) {
        result.push_back(by_q + " and " + by_p +
                         " once: " + text(evaluations.gradients.joint.counts));
    } else {
        result.push_back("dH/dq once: " + text(evaluations.gradients.by_q.counts));
        result.push_back("dH/dp once: " + text(evaluations.gradients.by_conjugates.counts));
    }
    if (evaluations.second) {
        const bool is_newton = step.iteration()->takes_newton();
        const std::string kinetic = fmt::format(
            "d2{}/d{}2 once in a step: ", system.function_letter(), system.conjugate_letter());
        result.push_back(
            (is_newton ? "second derivatives once, where Newton's method is needed: " : kinetic) +
            text(evaluations.second->counts()));
    }
    if (evaluations.tangents) {
        result.push_back("d2H/dq2 times a vector, after dH/dq: " +
                         text(evaluations.tangents->along.counts));
    }
    if (step.corrections) { result.push_back(text(step.corrections->costs)); }
    const std::size_t forces = step.forces_evaluated();
    const std::size_t velocities = step.velocities_evaluated();
    result.push_back(fmt::format("evaluations in {}{}: {} of {}, {} of {}", where,
                                 unknowns == 0 ? "" : " of one iteration", forces, by_q, velocities,
                                 by_p));
    return result;
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/pipeline/split.hpp"

#include <fmt/format.h>

#include <utility>
#include <variant>

#include "generator/lower/orbit_coordinates.hpp"
#include "generator/pipeline/refusals.hpp"
#include "generator/symmetry/kept_by_parts.hpp"

namespace hvi::gen {

namespace {

/// Throws InputError where fast parts take small steps, and the splitting is not made for that.
void check_small_steps(const WrittenOutScene& scene, const Method& method) {
    const bool are_there = scene.split && scene.split->small_steps.exist();
    if (!are_there || method.splitting.empty() || method.splitting == "strang") return;
    throw InputError(
        fmt::format("{} is for flows that are exact, and small steps are not", method.splitting),
        method.place, "take strang, of which --compose makes higher orders");
}

}  // namespace

std::vector<SplitCandidate> ways_to_split(const LoweredScene& scene, const Method& method,
                                          const StepperWishes& wishes) {
    check_splitting(scene.system, method, wishes, scene.place());
    const std::size_t numbers =
        coordinate_nodes(scene.system).size() + conjugate_nodes(scene.system).size();
    if (numbers != variables(*scene.written).size())
        throw InputError("shadows and balances of the energy are not built for flows of parts of H",
                         method.place, "take a method that is no splitting: gauss:2");
    const auto* choice = std::get_if<SplitChoice>(&scene.scene.split);
    if (choice != nullptr && is_of_orbits(*choice))
        return {{"orbits", with_orbits(scene.system, *choice, scene.place())}};
    check_small_steps(*scene.written, method);
    return split_candidates(scene.system, *scene.written);
}

System in_parts(const LoweredScene& scene, const Method& method, const StepperWishes& wishes) {
    std::vector<SplitCandidate> all = ways_to_split(scene, method, wishes);
    // NOTE: the measure is that of strang; other splittings want the large part first.
    const bool is_measured = method.splitting.empty() || method.splitting == "strang";
    if (all.size() == 1 || !is_measured) return std::move(all.front().system);
    measure(all, *scene.written);
    return std::move(all[chosen_split(all)].system);
}

std::optional<System> system_in_parts(const Method& method, const LoweredScene& scene,
                                      const StepperWishes& wishes) {
    if (method.splitting.empty()) return {};
    const System& system = scene.system;
    const bool is_kicked =
        system.side == Side::hamiltonian && is_separable(system) && rotations_of(system) == 0;
    const auto* choice = std::get_if<SplitChoice>(&scene.scene.split);
    const bool wants_kicks = choice != nullptr && *choice == SplitChoice::none;
    if (is_kicked && (wants_kicks || std::holds_alternative<std::monostate>(scene.scene.split)))
        return {};
    if (wants_kicks)
        throw InputError("--split none steps H = T(p) + U(q), and this H is no such sum",
                         method.place, "without it parts of H are found, or those of [split]");
    return in_parts(scene, method, wishes);
}

std::vector<std::string> kept_by_flows(const System& system, const LoweredScene& scene) {
    if (!system.parts || scene.written->invariants.empty()) return {};
    Hamiltonian H = hamiltonian_of(*scene.written);
    H.parameters.clear();
    std::vector<Quantity> quantities;
    for (const NamedExpression& invariant : scene.written->invariants)
        quantities.push_back({invariant.expression, invariant.place.source});
    const KeptByParts found = kept_by_parts(*system.parts, H, quantities);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < quantities.size(); ++i)
        if (is_kept_by_all(found.brackets[i])) names.push_back(scene.written->invariants[i].name);
    return names;
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/pipeline/lowered.hpp"

#include <utility>
#include <variant>

#include "generator/hamiltonian/legendre.hpp"
#include "generator/hamiltonian/time_scale.hpp"
#include "generator/read/scene_times.hpp"
#include "generator/scene/start.hpp"

namespace hvi::gen {

LoweredScene lowered_with_loops(const Scene& scene, const UnrollDecision& decision,
                                const std::vector<SystemPass>& passes) {
    LoweredScene result{scene, decision, std::nullopt, system_of(scene, passes), {}};
    static_cast<void>(times_of(scene));  // checks their words
    return result;
}

LoweredScene lowered_written_out(const Scene& scene, WrittenOutScene written,
                                 const UnrollDecision& decision,
                                 const std::vector<SystemPass>& passes) {
    static_cast<void>(times_of(scene));
    check_start(written);
    if (const auto* L = std::get_if<Lagrangian>(&written.mechanics)) { check_regular(*L); }
    written = with_time_scale(std::move(written));
    System system = system_of(written, passes);
    GradientKernels gradients = gradient_kernels(system);
    return {scene, decision, std::move(written), std::move(system), std::move(gradients)};
}

LoweredScene lowered(const Scene& scene, const UnrollWish& wish) {
    return by_unrolling(
        scene, wish, [&](const UnrollDecision& why) { return lowered_with_loops(scene, why); },
        [&](WrittenOutScene written, const UnrollDecision& why) {
            return lowered_written_out(scene, std::move(written), why);
        });
}

}  // namespace hvi::gen

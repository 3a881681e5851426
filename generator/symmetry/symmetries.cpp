// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symmetry/symmetries.hpp"

#include "generator/symmetry/families.hpp"
#include "generator/symmetry/written_out.hpp"

namespace hvi::gen {

std::string not_zero(const ConservedQuantity& quantity) {
    return "{" + quantity.name + ", H} = " + to_text(quantity.finding.bracket) +
           " is not zero as a function of q and p";
}

std::vector<const ConservedQuantity*> quantities_of(const SceneSymmetries& found) {
    std::vector<const ConservedQuantity*> all;
    for (const auto* list : {&found.momentum_maps, &found.invariants, &found.fields})
        for (const ConservedQuantity& each : *list) all.push_back(&each);
    return all;
}

SceneSymmetries find_symmetries(const Scene& scene, const UnrollWish& wish) {
    return by_unrolling(
        scene, wish, [&](const UnrollDecision&) { return symmetries_of_families(scene); },
        [&](const WrittenOutScene& written, const UnrollDecision&) {
            return symmetries_of(written);
        });
}

}  // namespace hvi::gen

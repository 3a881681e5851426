// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symmetry/kept_by_parts.hpp"

#include <algorithm>

#include "generator/expr/places.hpp"
#include "generator/hamiltonian/body_symmetries.hpp"
#include "generator/support/error.hpp"
#include "generator/support/work.hpp"
#include "generator/symmetry/written_out.hpp"

namespace hvi::gen {

namespace {

constexpr double most_work = 6 * work_of_a_second;  ///< on all parts

/// Looks at the brackets of all quantities with one function.
std::vector<Vanishing> brackets_with(const Expression& function, Hamiltonian H,
                                     const std::vector<Quantity>& quantities) {
    std::vector<Vanishing> result(quantities.size(), Vanishing::unknown);
    H.expression = without_places(function);
    try {
        const std::vector<QuantityFinding> found =
            H.rotations.empty() ? findings(H, quantities) : body_findings(H, quantities, {});
        for (std::size_t i = 0; i < found.size(); ++i) result[i] = found[i].conserved;
    } catch (const InputError&) {  // nothing is known of what GiNaC does not take
    } catch (const MathError&) {}
    return result;
}

/// Looks at the brackets of all quantities with one part. NOTE: what has no bracket with functions
/// has none with a function of these, and where it has one with them that tells nothing.
std::vector<Vanishing> brackets_with(const HamiltonianPart& part, const Hamiltonian& H,
                                     const std::vector<Quantity>& quantities) {
    if (part.made_of.empty())
        return is_too_long(part) ? std::vector<Vanishing>(quantities.size(), Vanishing::unknown)
                                 : brackets_with(part.expression, H, quantities);
    std::vector<Vanishing> result(quantities.size(), Vanishing::proved);
    for (const Expression& each : part.made_of) {
        const std::vector<Vanishing> found = brackets_with(each, H, quantities);
        for (std::size_t i = 0; i < result.size(); ++i)
            if (found[i] != Vanishing::proved) result[i] = Vanishing::unknown;
    }
    return result;
}

/// Tells what is unknown of one part alone. NOTE: H is the sum of its parts, so a quantity that H
/// conserves, and with it all parts but one, is conserved with that one too.
void conclude(BracketsWithParts& brackets) {
    const auto last = std::find(brackets.begin(), brackets.end(), Vanishing::unknown);
    const auto unknown = std::count(brackets.begin(), brackets.end(), Vanishing::unknown);
    const auto refuted = std::count(brackets.begin(), brackets.end(), Vanishing::refuted);
    if (unknown == 1 && refuted == 0) *last = Vanishing::proved;
}

}  // namespace

bool is_kept_by_all(const BracketsWithParts& brackets) {
    return std::all_of(brackets.begin(), brackets.end(),
                       [](Vanishing each) { return each == Vanishing::proved; });
}

std::string names_of_parts(const KeptByParts& parts, const BracketsWithParts& brackets,
                           Vanishing known) {
    std::string names;
    for (std::size_t k = 0; k < brackets.size(); ++k)
        if (brackets[k] == known) names += (names.empty() ? "" : ", ") + parts.parts[k];
    return names;
}

KeptByParts kept_by_parts(const HamiltonianParts& parts, const Hamiltonian& H,
                          const std::vector<Quantity>& quantities) {
    KeptByParts result;
    for (const HamiltonianPart& part : parts.parts) result.parts.push_back(part.name);
    result.brackets.assign(quantities.size(),
                           BracketsWithParts(parts.parts.size(), Vanishing::unknown));
    const WorkLimit limit(most_work);
    try {
        for (std::size_t k = 0; k < parts.parts.size(); ++k) {
            const std::vector<Vanishing> of_part = brackets_with(parts.parts[k], H, quantities);
            for (std::size_t i = 0; i < quantities.size(); ++i) result.brackets[i][k] = of_part[i];
        }
    } catch (const WorkLimitReached&) {}  // what is left is unknown
    return result;
}

KeptByParts kept_by_parts(const HamiltonianParts& parts, const WrittenOutScene& scene,
                          const SceneSymmetries& found) {
    std::vector<Quantity> quantities;
    for (const ConservedQuantity* each : quantities_of(found))
        quantities.push_back({each->expression, each->place.source});
    const Hamiltonian H = with_values(hamiltonian_of(scene), scene);
    quantities.push_back({H.expression, H.source});
    KeptByParts result = kept_by_parts(parts, H, quantities);
    const std::vector<const ConservedQuantity*> all = quantities_of(found);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i]->finding.conserved == Vanishing::proved) conclude(result.brackets[i]);
    conclude(result.brackets.back());
    return result;
}

}  // namespace hvi::gen

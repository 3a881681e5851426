// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ir/part.hpp"

#include <algorithm>

namespace hvi::gen {

bool moves_forms(const HamiltonianParts& parts) {
    return std::any_of(parts.parts.begin(), parts.parts.end(),
                       [](const HamiltonianPart& part) { return !part.forms.empty(); });
}

bool moves_on_orbits(const HamiltonianParts& parts) {
    return std::any_of(parts.parts.begin(), parts.parts.end(),
                       [](const HamiltonianPart& part) { return !part.in_each_flow.empty(); });
}

}  // namespace hvi::gen

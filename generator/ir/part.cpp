// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ir/part.hpp"

#include <algorithm>

namespace hvi::gen {

bool moves_forms(const HamiltonianParts& parts) {
    return std::any_of(parts.parts.begin(), parts.parts.end(),
                       [](const HamiltonianPart& part) { return !part.forms.empty(); });
}

bool calls(const HamiltonianParts& parts, RuntimeFunction function) {
    const auto is_it = [&](const RuntimeValues& values) { return values.function == function; };
    return std::any_of(parts.parts.begin(), parts.parts.end(), [&](const HamiltonianPart& part) {
        return std::any_of(part.in_each_flow.begin(), part.in_each_flow.end(), is_it);
    });
}

}  // namespace hvi::gen

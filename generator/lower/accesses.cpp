// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/accesses.hpp"

#include "generator/lower/kernel.hpp"

namespace hvi::gen {

std::vector<std::size_t> accesses_in(const System& system, const std::vector<Scaled>& values) {
    const Kernel whole = kernel(system.graph, values);
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < system.accesses.size(); ++k) {
        const Access& access = system.accesses[k];
        // NOTE: turns are no inputs.
        if (access.kind != FamilyKind::turn && whole.uses[access.node] != 0) {
            result.push_back(k);
        }
    }
    return result;
}

}  // namespace hvi::gen

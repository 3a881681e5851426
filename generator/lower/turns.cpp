// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/turns.hpp"

namespace hvi::gen {

namespace {

/// Adds (R^T G)_jk = sum_i R_ij G_ik, of a rotation whose entries begin at `first`.
void add_terms(std::vector<Scaled>& terms, System& system, const std::vector<Scaled>& by_entries,
               std::size_t first, std::size_t j, std::size_t k, long sign) {
    Graph& graph = system.graph;
    for (std::size_t i = 0; i < 3; ++i) {
        const Scaled R{{sign, 1}, system.accesses[first + 3 * i + j].node};
        terms.push_back(graph.product(R, by_entries[first + 3 * i + k]));
    }
}

}  // namespace

std::vector<Scaled> by_turns(System& system, const std::vector<Scaled>& by_entries) {
    const std::size_t coordinates = flat_coordinates(system);
    std::vector<Scaled> result(by_entries.begin(),
                               by_entries.begin() + static_cast<std::ptrdiff_t>(coordinates));
    for (std::size_t first = coordinates; first < by_entries.size();
         first += rotations_of_space.point) {
        for (std::size_t a = 0; a < 3; ++a) {
            const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
            std::vector<Scaled> terms;
            add_terms(terms, system, by_entries, first, c, b, 1);
            add_terms(terms, system, by_entries, first, b, c, -1);
            result.push_back(system.graph.sum(std::move(terms)));
        }
    }
    return result;
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/scheme.hpp"

#include <algorithm>

namespace hvi::gen {

std::vector<std::size_t> Block::of(StageNode::Kind kind) const {
    std::vector<std::size_t> indices;
    for (const StageNode& node : nodes) {
        if (node.kind == kind) { indices.push_back(node.index); }
    }
    return indices;
}

bool Scheme::takes_newton() const {
    return solver == Solver::newton || solver == Solver::automatic;
}

bool Scheme::is_explicit() const { return coupled_blocks() == 0; }

std::size_t Scheme::coupled_blocks() const {
    return static_cast<std::size_t>(std::count_if(
        blocks.begin(), blocks.end(), [](const Block& block) { return block.coupled; }));
}

std::size_t Scheme::forces_evaluated() const { return positions.size() - (keeps_force ? 1 : 0); }

std::size_t Scheme::velocities_evaluated() const {
    return momenta.size() - (keeps_velocity ? 1 : 0);
}

}  // namespace hvi::gen

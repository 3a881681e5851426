// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ir/step.hpp"

#include <algorithm>

namespace hvi::gen {

std::vector<std::size_t> Block::of(StageNode::Kind kind) const {
    std::vector<std::size_t> indices;
    for (const StageNode& node : nodes) {
        if (node.kind == kind) { indices.push_back(node.index); }
    }
    return indices;
}

std::vector<FlowStep::Round> FlowStep::between() const {
    std::vector<Round> result = rounds;
    result.front().moves.erase(result.front().moves.begin());
    result.back().moves.pop_back();
    std::erase_if(result, [](const Round& round) { return round.moves.empty(); });
    return result;
}

std::vector<std::size_t> FlowStep::counts() const {
    std::vector<std::size_t> counts(fractions.size());
    for (const Round& round : rounds) {
        for (const Move& move : round.moves) { counts[move.part] += round.times; }
    }
    return counts;
}

std::size_t FlowStep::flows() const {
    std::size_t all = 0;
    for (const Round& round : rounds) { all += round.times * round.moves.size(); }
    return all;
}

bool Iteration::takes_newton() const {
    return solver == Solver::newton || solver == Solver::automatic;
}

bool Iteration::only_sweeps() const {
    return solver == Solver::fixed_point || solver == Solver::sweeps;
}

bool Step::depends_on_time() const {
    const auto* flows = std::get_if<FlowStep>(&form);
    return !c.empty() || (flows != nullptr && flows->clock.has_value());
}

std::size_t Step::coupled_blocks() const {
    return static_cast<std::size_t>(std::count_if(
        blocks.begin(), blocks.end(), [](const Block& block) { return block.coupled; }));
}

const Iteration* Step::iteration() const {
    if (const auto* pairs = std::get_if<PairStep>(&form)) {
        return pairs->iteration ? &*pairs->iteration : nullptr;
    }
    if (const auto* galerkin = std::get_if<GalerkinStep>(&form)) { return &galerkin->iteration; }
    if (const auto* charts = std::get_if<ChartStep>(&form)) { return &charts->iteration; }
    const auto* velocities = std::get_if<VelocityStep>(&form);
    return velocities == nullptr ? nullptr : &velocities->iteration;
}

std::size_t Step::forces_evaluated() const { return positions.size() - (kept.force ? 1 : 0); }

std::size_t Step::velocities_evaluated() const {
    if (std::holds_alternative<VelocityStep>(form)) { return 1; }
    if (std::holds_alternative<GalerkinStep>(form)) { return positions.size(); }
    return momenta.size() - (kept.velocity ? 1 : 0);
}

std::size_t Step::unknowns() const {
    if (const auto* galerkin = std::get_if<GalerkinStep>(&form)) {
        const GalerkinForm& of = galerkin->form;
        return of.functions() + (galerkin->side == Side::hamiltonian ? of.nodes() : 0);
    }
    std::size_t count = 0;
    for (const Block& block : blocks) {
        if (!block.coupled) { continue; }
        count += block.of(StageNode::Kind::Q).size() + block.of(StageNode::Kind::P).size();
    }
    return count;
}

bool operator==(const Step& left, const Step& right) { return dump(left) == dump(right); }

}  // namespace hvi::gen

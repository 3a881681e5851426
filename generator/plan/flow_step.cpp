// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/flow_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "generator/ir/equal.hpp"

namespace hvi::gen {

namespace {

/// A flow over a fraction of h.
struct PartOverFraction {
    std::size_t part;
    Number fraction;
};
using FlowsInTurn = std::vector<PartOverFraction>;

/// Flows in turn, and that so many times.
struct RoundOfFlows {
    FlowsInTurn flows;
    std::size_t times = 1;
};

/// Adds a flow. Two of one part in a row are one.
void add_flow(FlowsInTurn& all, const PartOverFraction& flow) {
    if (!all.empty() && all.back().part == flow.part) {
        all.back().fraction = all.back().fraction + flow.fraction;
    } else {
        all.push_back(flow);
    }
}

/// Returns the flows of `count` parts from `first` on, in the order of the parts and in reverse in
/// turn.
FlowsInTurn flows(std::size_t first, std::size_t count, const NumberVector& substeps) {
    FlowsInTurn result;
    for (std::size_t i = 0; i < substeps.size(); ++i) {
        for (std::size_t k = 0; k < count; ++k) {
            add_flow(result, {first + (i % 2 == 0 ? k : count - 1 - k), substeps[i]});
        }
    }
    return result;
}

/// Adds a round. Rounds that are made once are one.
void add_round(std::vector<RoundOfFlows>& all, const RoundOfFlows& round) {
    if (round.times == 0) { return; }
    if (round.times > 1 || all.empty() || all.back().times > 1) {
        all.push_back(round);
    } else {
        for (const PartOverFraction& flow : round.flows) { add_flow(all.back().flows, flow); }
    }
}

/// Returns the first half of the small steps in a large one over a fraction of h. These are twice
/// `count` steps of the map of all fast flows one after the other, and of its adjoint, in turn.
std::vector<RoundOfFlows> first_half(const SmallSteps& small, const Number& fraction) {
    const Number half = fraction / Number(2 * static_cast<long>(small.count));
    FlowsInTurn next = flows(0, small.parts, {half, half});
    FlowsInTurn last = small.count % 2 == 0 ? next : flows(0, small.parts, {half});
    const PartOverFraction first = next.front();
    next.erase(next.begin());
    last.erase(last.begin());
    next.back().fraction = next.back().fraction + half;
    return {{{first}, 1}, {std::move(next), (small.count - 1) / 2}, {std::move(last), 1}};
}

std::vector<RoundOfFlows> reversed(std::vector<RoundOfFlows> rounds) {
    std::reverse(rounds.begin(), rounds.end());
    for (RoundOfFlows& round : rounds) { std::reverse(round.flows.begin(), round.flows.end()); }
    return rounds;
}

/// Returns the rounds of a step whose first parts take small steps.
std::vector<RoundOfFlows> with_small_steps(std::size_t parts, const SmallSteps& small,
                                           const NumberVector& substeps) {
    std::vector<RoundOfFlows> all;
    const auto add = [&](const std::vector<RoundOfFlows>& rounds) {
        for (const RoundOfFlows& round : rounds) { add_round(all, round); }
    };
    for (std::size_t i = 0; i < substeps.size(); i += 2) {
        const NumberVector halves{substeps[i], substeps[i + 1]};
        const std::vector<RoundOfFlows> before = first_half(small, halves[0] + halves[1]);
        add(before);
        add({{flows(small.parts, parts - small.parts, halves), 1}});
        add(reversed(before));
    }
    return all;
}

/// Returns the place of a number among different ones, where it is put if it is new.
std::size_t place_among(NumberVector& numbers, const Number& number) {
    const auto found = std::find_if(numbers.begin(), numbers.end(),
                                    [&](const Number& other) { return equal(other, number); });
    const auto place = static_cast<std::size_t>(found - numbers.begin());
    if (found == numbers.end()) { numbers.push_back(number); }
    return place;
}

}  // namespace

FlowStep flow_step(std::size_t parts, const SmallSteps& small_steps, const NumberVector& substeps) {
    const std::vector<RoundOfFlows> rounds =
        small_steps.exist() ? with_small_steps(parts, small_steps, substeps)
                            : std::vector<RoundOfFlows>{{flows(0, parts, substeps), 1}};
    FlowStep form{std::vector<NumberVector>(parts), {}, {}};
    for (const RoundOfFlows& round : rounds) {
        FlowStep::Round& moves = form.rounds.emplace_back();
        moves.times = round.times;
        for (const auto& [part, fraction] : round.flows) {
            moves.moves.push_back({part, place_among(form.fractions[part], fraction)});
        }
    }
    return form;
}

FlowStep with_joined_ends(FlowStep form) {
    const FlowStep::Round &begin = form.rounds.front(), &end = form.rounds.back();
    const FlowStep::Move &first = begin.moves.front(), &last = end.moves.back();
    const bool are_made_once = begin.times == 1 && end.times == 1 && form.flows() > 1;
    if (!are_made_once || first.part != last.part) { return form; }
    NumberVector& fractions = form.fractions[first.part];
    form.joined = place_among(fractions, fractions[first.fraction] + fractions[last.fraction]);
    return form;
}

void set_flows(Step& step, const SystemProperties& system, const NumberVector& substeps) {
    const SmallSteps& small = system.small_steps;
    FlowStep form = flow_step(system.parts, small, substeps);
    form.clock = system.clock;
    if (system.rotations > 0) { form.moving = FlowStep::Moving::bodies; }
    step.form = std::move(form);
    step.decisions.push_back({"no solver: a step is flows of parts of H in turn",
                              "each flow is exact, so that their product is symplectic"});
    if (small.exist()) {
        step.decisions.push_back(
            {fmt::format("{} parts take {} small steps in a large one", small.parts, small.count),
             "they are fast, as the scene has it"});
    }
    if (system.clock) {
        step.decisions.push_back(
            {fmt::format("the time goes on with the flow of part {} alone", *system.clock + 1),
             "it is a coordinate, whose momentum is a term of that part"});
    }
    step.decisions.push_back({"values that depend on h alone are computed when h changes",
                              "steps of the same size follow each other"});
    step.decisions.push_back({"sums of the changes in a step are compensated",
                              "round-off then grows like the square root of the number of steps"});
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/flow_step.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/ir/equal.hpp"

namespace hvi::gen {

namespace {

/// A flow over a fraction of h.
struct PartOverFraction {
    std::size_t part;
    Number fraction;
};

/// Returns the flows, in the order of the parts and in reverse in turn.
std::vector<PartOverFraction> flows(std::size_t parts, const NumberVector& substeps) {
    std::vector<PartOverFraction> result;
    for (std::size_t i = 0; i < substeps.size(); ++i) {
        for (std::size_t k = 0; k < parts; ++k) {
            const std::size_t part = i % 2 == 0 ? k : parts - 1 - k;
            if (!result.empty() && result.back().part == part) {
                result.back().fraction = result.back().fraction + substeps[i];
            } else {
                result.push_back({part, substeps[i]});
            }
        }
    }
    return result;
}

/// Returns the place of a number among different ones, where it is put if it is new.
std::size_t place_among(NumberVector& numbers, const Number& number) {
    const auto found = std::find_if(numbers.begin(), numbers.end(),
                                    [&](const Number& other) { return equal(other, number); });
    const auto place = static_cast<std::size_t>(found - numbers.begin());
    if (found == numbers.end()) { numbers.push_back(number); }
    return place;
}

/// Adds the moves, made so many times, behind those of the step.
void add_round(FlowStep& form, const std::vector<PartOverFraction>& moves, std::size_t times) {
    if (moves.empty() || times == 0) { return; }
    const bool goes_on = times == 1 && !form.rounds.empty() && form.rounds.back().times == 1;
    if (!goes_on) { form.rounds.push_back({{}, times}); }
    for (const auto& [part, fraction] : moves) {
        form.rounds.back().moves.push_back({part, place_among(form.fractions[part], fraction)});
    }
}

/// Adds small steps of the last parts, which together last for a fraction of h. Where one begins
/// with the flow that the one before it ends with, this is one flow of twice the length.
void add_small_steps(FlowStep& form, const SmallSteps& small, const Number& fraction) {
    const Number each = fraction / Number(static_cast<long>(small.count));
    const Number half = each / Number(2);
    std::vector<PartOverFraction> first = flows(small.parts, {half, half});
    for (auto& [part, length] : first) { part += form.fractions.size() - small.parts; }
    std::vector<PartOverFraction> next(first.begin() + 1, first.end());
    std::vector<PartOverFraction> last = next;
    next.back().fraction = each;
    add_round(form, {first.front()}, 1);
    add_round(form, next, small.count - 1);
    add_round(form, last, 1);
}

}  // namespace

FlowStep flow_step(std::size_t parts, const SmallSteps& small_steps, const NumberVector& substeps) {
    FlowStep form{std::vector<NumberVector>(parts), {}};
    const std::size_t slow = parts - small_steps.parts;
    for (const auto& [part, fraction] : flows(slow + (small_steps.exist() ? 1 : 0), substeps)) {
        if (part < slow) {
            add_round(form, {{part, fraction}}, 1);
        } else {
            add_small_steps(form, small_steps, fraction);
        }
    }
    return form;
}

void set_flows(Step& step, const SystemProperties& system, const NumberVector& substeps) {
    const SmallSteps& small = system.small_steps;
    step.form = flow_step(system.parts, small, substeps);
    step.decisions.push_back({"no solver: a step is flows of parts of H in turn",
                              "each flow is exact, so that their product is symplectic"});
    if (small.exist()) {
        step.decisions.push_back(
            {fmt::format("{} parts take {} small steps in a large one", small.parts, small.count),
             "they are fast, as the scene has it"});
    }
    step.decisions.push_back({"values that depend on h alone are computed when h changes",
                              "steps of the same size follow each other"});
    step.decisions.push_back({"sums of the changes in a step are compensated",
                              "round-off then grows like the square root of the number of steps"});
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/flow_step.hpp"

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

}  // namespace

void set_flows(Step& step, std::size_t parts, const NumberVector& substeps) {
    FlowStep form{std::vector<NumberVector>(parts), {}};
    for (const auto& [part, fraction] : flows(parts, substeps)) {
        form.moves.push_back({part, place_among(form.fractions[part], fraction)});
    }
    step.form = std::move(form);
    step.decisions.push_back({"no solver: a step is flows of parts of H in turn",
                              "each flow is exact, so that their product is symplectic"});
    step.decisions.push_back({"values that depend on h alone are computed when h changes",
                              "steps of the same size follow each other"});
    step.decisions.push_back({"sums of the changes in a step are compensated",
                              "round-off then grows like the square root of the number of steps"});
}

}  // namespace hvi::gen

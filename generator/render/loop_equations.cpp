// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/render/loop_equations.hpp"

#include <algorithm>
#include <utility>

namespace hvi::gen {

std::vector<NamedSlope> named_slopes(const LoopEquations& step) {
    std::vector<NamedSlope> result;
    const auto add = [&](const std::vector<SystemFamily>& families,
                         const std::vector<ElementSlope>& slopes) {
        for (std::size_t f = 0; f < families.size(); ++f)
            if (!slopes[f].empty()) result.push_back({families[f], slopes[f]});
    };
    add(step.momenta, step.gradient.by_momenta);
    add(step.coordinates, step.gradient.by_coordinates);
    return result;
}

std::vector<PlacedTerm> placed_terms(const ElementSlope& slope, bool in_latex) {
    ElementSlope terms = slope;
    std::stable_partition(terms.begin(), terms.end(),
                          [](const LoopTermOfSlope& term) { return term.where.empty(); });
    std::vector<PlacedTerm> result;
    for (const LoopTermOfSlope& term : terms) {
        std::string text = in_latex ? to_latex(term.value) : to_text(term.value);
        if (!term.where.empty() && term.value.kind == Expression::Kind::sum)
            text = in_latex ? "\\left(" + text + "\\right)" : "(" + text + ")";
        if (!result.empty() && text.front() != '-') text.insert(0, in_latex ? "+ " : "+");
        result.push_back({std::move(text), term.where});
    }
    return result;
}

std::vector<std::string> texts(const std::vector<SystemFamily>& families) {
    std::vector<std::string> result;
    for (const SystemFamily& family : families) result.push_back(to_text(family));
    return result;
}

std::string to_text(const Loop& range) {
    const auto& [first, last] = range.range;
    std::string text = range.index + "=" + to_text(as_expression(first));
    if (first != last) text += ".." + to_text(as_expression(last));
    return text;
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/velocity_form.hpp"

#include "generator/ir/equal.hpp"
#include "generator/stages/dependency_graph.hpp"

namespace hvi::gen {

namespace {

Number weighted(const Step& step, std::size_t i, std::size_t k) {
    return step.m[i][k] * step.momenta[k].weight;
}

/// Returns the sum of a term over the momenta.
Number sum(const Step& step, const auto& term) {
    Number total;
    for (std::size_t k = 0; k < step.momenta.size(); ++k) { total = total + term(k); }
    return total;
}

}  // namespace

// NOTE: where enclosures stand for numbers without a closed form, a row of m is known to be zeros
// or ones, but sums over it are not seen to be.

NumberVector position_times(const Step& step) {
    NumberVector c;
    for (std::size_t i = 0; i < step.positions.size(); ++i) {
        switch (step.positions[i].place) {
        case StageValue::Place::start: c.emplace_back(0); break;
        case StageValue::Place::end: c.emplace_back(1); break;
        case StageValue::Place::inner:
            c.push_back(sum(step, [&](std::size_t k) { return weighted(step, i, k); }));
        }
    }
    return c;
}

VelocityForm velocity_form(const Step& step) {
    const std::size_t r = step.positions.size();
    VelocityForm form{position_times(step), NumberMatrix(r, NumberVector(r))};
    const auto S = [&](std::size_t i, std::size_t j) {
        const auto is_at = [&](std::size_t k, StageValue::Place place) {
            return step.positions[k].place == place;
        };
        if (is_at(i, StageValue::Place::start) || is_at(j, StageValue::Place::start)) {
            return Number(0);
        }
        if (is_at(i, StageValue::Place::end)) { return form.c[j]; }
        if (is_at(j, StageValue::Place::end)) { return form.c[i]; }
        return sum(step, [&](std::size_t k) { return weighted(step, i, k) * step.m[j][k]; });
    };
    for (std::size_t i = 0; i < r; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            const Number S_ij = S(i, j);
            form.n[i][j] = form.c[i] - S_ij;
            form.n[j][i] = form.c[j] - S_ij;
        }
    }
    return form;
}

std::vector<Block> blocks(const VelocityForm& form) {
    const std::size_t r = form.c.size();
    DependencyGraph needs(2 * r);  // the positions, then the forces
    for (std::size_t i = 0; i < r; ++i) {
        for (std::size_t j = 0; j < r; ++j) {
            if (!equal(form.n[i][j], 0)) { needs[i].push_back(r + j); }
        }
        needs[r + i].push_back(i);
    }
    std::vector<Block> result;
    for (const auto& component : components(needs)) {
        Block& block = result.emplace_back();
        block.coupled = component.size() > 1;
        for (const std::size_t v : component) {
            block.nodes.push_back(v < r ? StageNode{StageNode::Kind::Q, v}
                                        : StageNode{StageNode::Kind::Lp, v - r});
        }
    }
    return result;
}

}  // namespace hvi::gen

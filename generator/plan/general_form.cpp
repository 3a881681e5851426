// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/general_form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "generator/ir/equal.hpp"
#include "generator/plan/velocity_form.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

StageValue::Place place_of(const Number& c) {
    if (equal(c, 0)) { return StageValue::Place::start; }
    return equal(c, 1) ? StageValue::Place::end : StageValue::Place::inner;
}

/// Sets the positions with their weights. Returns their nodes, as indices of the rule.
std::vector<std::size_t> set_positions(Step& step, const GalerkinRule& rule) {
    std::vector<std::size_t> used;
    for (std::size_t i = 0; i < rule.nodes(); ++i) {
        if (equal(rule.b[i], 0)) {
            step.decisions.push_back(
                {fmt::format("Q_{} is not computed", i + 1), "its weight is zero"});
            continue;
        }
        used.push_back(i);
        step.positions.push_back({place_of(rule.c[i]), {i}, rule.b[i]});
    }
    return used;
}

VelocityForm form_of(const GalerkinRule& rule, const std::vector<std::size_t>& used) {
    VelocityForm form;
    for (const std::size_t i : used) {
        form.c.push_back(rule.c[i]);
        NumberVector& row = form.n.emplace_back();
        for (const std::size_t j : used) { row.push_back(rule.n[i][j]); }
    }
    return form;
}

/// Returns the blocks with one in place of all from the first to the last block that is solved for,
/// as the runtime solves for one.
std::vector<Block> with_one_coupled(std::vector<Block> blocks) {
    const auto is_coupled = [](const Block& block) { return block.coupled; };
    const auto first = std::find_if(blocks.begin(), blocks.end(), is_coupled);
    const auto last = std::find_if(blocks.rbegin(), blocks.rend(), is_coupled).base();
    if (first == blocks.end()) { return blocks; }
    for (auto block = first + 1; block != last; ++block) {
        first->nodes.insert(first->nodes.end(), block->nodes.begin(), block->nodes.end());
    }
    std::sort(first->nodes.begin(), first->nodes.end(), [](const StageNode& a, const StageNode& b) {
        return std::pair(a.kind, a.index) < std::pair(b.kind, b.index);
    });
    blocks.erase(first + 1, last);
    return blocks;
}

/// Returns the times of kicks, each once, ascending, from 0 to 1.
NumberVector times_of_kicks(const NumberVector& c) {
    NumberVector times{Number(0), Number(1)};
    for (const Number& node : c) {
        const auto place = std::find_if(times.begin(), times.end(), [&](const Number& time) {
            return (time - node).sign() >= 0;
        });
        if (place == times.end() || !equal(*place, node)) { times.insert(place, node); }
    }
    return times;
}

/// Sets an explicit step: n_ij is c_i - c_j or 0, so that the motion is free between kicks at the
/// times c_i. Drifts are from one of these times to the next.
void set_explicit(Step& step, const NumberVector& c) {
    const NumberVector times = times_of_kicks(c);
    for (std::size_t j = 0; j + 1 < times.size(); ++j) {
        step.momenta.push_back({StageValue::Place::inner, {j}, times[j + 1] - times[j]});
    }
    for (const Number& node : c) {
        NumberVector& row = step.m.emplace_back();
        for (std::size_t j = 0; j + 1 < times.size(); ++j) {
            row.emplace_back((node - times[j + 1]).sign() >= 0 ? 1 : 0);
        }
    }
    step.form = ExplicitStep{};
}

}  // namespace

void check_general_form(const std::optional<Place>& place, const SystemProperties& system) {
    if (system.is_degenerate) {
        throw MathError("with more nodes than functions no step is determined: (4.6e) gives more "
                        "equations than velocities, which leave p at the nodes free, and a row of "
                        "d2H/dp2 is zero, so that its rank is below the degrees of freedom",
                        place, "take as many nodes as functions");
    }
    if (system.degrees_of_freedom == 0) {
        throw InputError("steppers of the general Galerkin form are built for one H alone", place,
                         "name a scene, or give --hamiltonian");
    }
}

Quadrature set_rule(Step& step, const GalerkinRule& rule) {
    step.slopes = Slopes::of_parts;
    step.partner = Partner::different;
    step.decisions.push_back(
        {"positions alone are computed",
         "the kinetic energy is quadratic, and (4.6) a Nystrom method of its nodes"});
    const std::vector<std::size_t> used = set_positions(step, rule);
    VelocityForm form = form_of(rule, used);
    Quadrature quadrature{form.c, {}};
    for (const StageValue& position : step.positions) { quadrature.b.push_back(position.weight); }
    std::vector<Block> order = with_one_coupled(blocks(form));
    if (std::none_of(order.begin(), order.end(),
                     [](const Block& block) { return block.coupled; })) {
        set_explicit(step, form.c);
        return quadrature;
    }
    step.m.resize(step.positions.size());
    VelocityStep positions;
    positions.form = std::move(form);
    step.form = std::move(positions);
    step.blocks = std::move(order);
    return quadrature;
}

}  // namespace hvi::gen

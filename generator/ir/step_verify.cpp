// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/ir/equal.hpp"
#include "generator/ir/step.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

using Kind = StageNode::Kind;

/// Returns whether a step has the general form. NOTE: positions of the general Galerkin form have
/// no momenta beside them.
bool is_general_form(const Step& step) {
    const auto* map = std::get_if<TabulatedStep>(&step.form);
    const bool is_curve = map != nullptr && std::holds_alternative<TabulatedCurve>(map->tables);
    return is_curve || std::holds_alternative<VelocityStep>(step.form) ||
           std::holds_alternative<GalerkinStep>(step.form);
}

void verify_stages(const Step& step) {
    const std::size_t r = step.positions.size(), s = step.momenta.size();
    HVI_CHECK(r > 0 && (s > 0 || is_general_form(step)));
    HVI_CHECK(is_table(step.m, r, s));
    HVI_CHECK(step.c.empty() || step.c.size() == r);
    for (const auto* values : {&step.positions, &step.momenta}) {
        for (const StageValue& value : *values) { HVI_CHECK(!value.stages.empty()); }
    }
    for (std::size_t i = 0; i < r; ++i) {
        for (std::size_t j = 0; j < s; ++j) {
            const bool at_start = step.positions[i].place == StageValue::Place::start;
            const bool at_end = step.positions[i].place == StageValue::Place::end;
            HVI_CHECK(!at_start || equal(step.m[i][j], 0));
            HVI_CHECK(!at_end || equal(step.m[i][j], 1));
        }
    }
}

/// Returns the nodes that a node needs: Q_i needs the Lq_j with m_ij != 0, P_j the Lp_i with m_ij
/// != 1, and a slope its stage values.
std::vector<StageNode> needs(const Step& step, const StageNode& node) {
    std::vector<StageNode> result;
    const std::size_t i = node.index;
    switch (node.kind) {
    case Kind::Q:
        for (std::size_t j = 0; j < step.momenta.size(); ++j) {
            if (!equal(step.m[i][j], 0)) { result.push_back({Kind::Lq, j}); }
        }
        break;
    case Kind::P:
        for (std::size_t j = 0; j < step.positions.size(); ++j) {
            if (!equal(step.m[j][i], 1)) { result.push_back({Kind::Lp, j}); }
        }
        break;
    case Kind::Lq:
        result.push_back({Kind::P, i});
        if (!step.is_separable()) { result.push_back({Kind::Q, i}); }
        break;
    case Kind::Lp:
        result.push_back({Kind::Q, i});
        if (!step.is_separable()) { result.push_back({Kind::P, i}); }
        break;
    }
    return result;
}

/// Checks that each block needs only itself and earlier blocks, and that each slope is computed
/// once.
void verify_order(const Step& step) {
    std::vector<StageNode> known;
    for (const Block& block : step.blocks) {
        HVI_CHECK(!block.nodes.empty());
        HVI_CHECK(block.coupled == (block.nodes.size() > 1));
        const std::vector<StageNode> before = known;
        for (const StageNode& node : block.nodes) {
            HVI_CHECK(std::find(before.begin(), before.end(), node) == before.end());
            known.push_back(node);
        }
        for (const StageNode& node : block.nodes) {
            for (const StageNode& needed : needs(step, node)) {
                HVI_CHECK(std::find(known.begin(), known.end(), needed) != known.end());
            }
        }
    }
    HVI_CHECK(known.size() == 2 * (step.positions.size() + step.momenta.size()));
}

void verify_iteration(const Step& step, const Iteration& iteration) {
    HVI_CHECK(iteration.counts_sweeps() ? 0 < iteration.sweeps && iteration.sweeps <= most_sweeps
                                        : iteration.sweeps == 0);
    const std::vector<Extrapolation>& all = iteration.extrapolation;
    if (all.empty()) { return; }
    HVI_CHECK(all.size() == std::max<std::size_t>(1, step.in_a_row.size()));
    const std::size_t s = step.positions.size();
    for (const Extrapolation& from : all) {
        HVI_CHECK(is_table(from.last, s, s));
        HVI_CHECK(from.before.has_value() == all.front().before.has_value());
        HVI_CHECK(!from.before || is_table(*from.before, s, s));
    }
}

bool is_table(const RoundedMatrix& table, std::size_t rows, std::size_t columns) {
    return table.size() == rows &&
           std::all_of(table.begin(), table.end(),
                       [&](const std::vector<Rounded>& row) { return row.size() == columns; });
}

/// Checks m_ij + mt_ji = 1 in each format that has both. Where one is missing the other is, too.
void verify_rounded(const Step& step, const RoundedCoefficients& coefficients) {
    const std::size_t r = step.positions.size(), s = step.momenta.size();
    HVI_CHECK(is_table(coefficients.m, r, s) && is_table(coefficients.mt, s, r));
    for (std::size_t i = 0; i < r; ++i) {
        for (std::size_t j = 0; j < s; ++j) {
            for (std::size_t f = 0; f < formats.size(); ++f) {
                const auto& m = coefficients.m[i][j][f];
                const auto& mt = coefficients.mt[j][i][f];
                HVI_CHECK(m.has_value() == mt.has_value());
                HVI_CHECK(!m || Dyadic(1, 0) - *m == *mt);
            }
        }
    }
}

/// Checks n_ij - n_ji = c_i - c_j in each format.
void verify_rounded(const RoundedVelocityForm& form, std::size_t r) {
    HVI_CHECK(form.c.size() == r && is_table(form.n, r, r));
    for (std::size_t i = 0; i < r; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            for (std::size_t f = 0; f < formats.size(); ++f) {
                HVI_CHECK(form.n[i][j][f] && form.n[j][i][f] && form.c[i][f] && form.c[j][f]);
                HVI_CHECK(*form.n[i][j][f] - *form.n[j][i][f] == *form.c[i][f] - *form.c[j][f]);
            }
        }
    }
}

/// Checks, in each format, A_ij + D_ij = B_j, and that the sum of X_ij over i is B_j.
void verify_rounded(const RoundedGalerkinForm& form, std::size_t r, std::size_t s) {
    HVI_CHECK(is_table(form.X, r, s) && is_table(form.A, r, s) && is_table(form.D, r, s));
    HVI_CHECK(form.B.size() == s);
    for (std::size_t f = 0; f < formats.size(); ++f) {
        for (std::size_t j = 0; j < s; ++j) {
            HVI_CHECK(form.B[j][f]);
            Dyadic rest = *form.B[j][f];
            for (std::size_t i = 0; i < r; ++i) {
                HVI_CHECK(form.X[i][j][f] && form.A[i][j][f] && form.D[i][j][f]);
                HVI_CHECK(*form.B[j][f] - *form.A[i][j][f] == *form.D[i][j][f]);
                rest = rest - *form.X[i][j][f];
            }
            HVI_CHECK(rest.is_zero());
        }
    }
}

void verify_form(const Step& step, const ExplicitStep&) {
    HVI_CHECK(step.is_separable() && step.is_explicit());
    HVI_CHECK(step.layout != Layout::stages && step.layout != Layout::components);
    verify_order(step);
}

void verify_form(const Step& step, const FlowStep& form) {
    const bool are_lanes = step.layout == Layout::trajectories;
    HVI_CHECK(step.is_explicit() && (step.layout == Layout::one || are_lanes));
    HVI_CHECK(!are_lanes || !form.joined);
    HVI_CHECK(step.c.empty() && !step.kept.any() && !step.from_parameter);
    HVI_CHECK(!form.clock || (!are_lanes && *form.clock < form.fractions.size()));
    HVI_CHECK(!form.rounds.empty());
    std::vector<Number> sums(form.fractions.size(), Number(0));
    for (const auto& [moves, times] : form.rounds) {
        HVI_CHECK(!moves.empty() && times > 0);
        for (const auto& [part, fraction] : moves) {
            HVI_CHECK(part < sums.size() && fraction < form.fractions[part].size());
            sums[part] =
                sums[part] + Number(static_cast<long>(times)) * form.fractions[part][fraction];
        }
    }
    for (const Number& sum : sums) { HVI_CHECK(!differ(sum, Number(1))); }
    if (form.joined) {
        const FlowStep::Round &begin = form.rounds.front(), &end = form.rounds.back();
        const FlowStep::Move &first = begin.moves.front(), &last = end.moves.back();
        const NumberVector& of = form.fractions[first.part];
        HVI_CHECK(begin.times == 1 && end.times == 1 && first.part == last.part);
        HVI_CHECK(form.flows() > 1 && *form.joined < of.size());
        HVI_CHECK(!differ(of[*form.joined], of[first.fraction] + of[last.fraction]));
    }
    verify_order(step);
}

/// Checks that one block has all unknowns, of r nodes and s functions.
void verify_curve(const Step& step, const GalerkinForm& form, const RoundedGalerkinForm& rounded) {
    const std::size_t r = form.nodes(), s = form.functions();
    HVI_CHECK(step.positions.size() == r && step.momenta.empty() && step.layout == Layout::one);
    HVI_CHECK(step.blocks.size() == 1 && step.coupled_blocks() == 1);
    HVI_CHECK(!step.kept.any() && !step.from_parameter);
    HVI_CHECK(r >= s && form.b.size() == r && form.gram.size() == s);
    HVI_CHECK(is_table(form.phi, r, s) && is_table(form.A, r, s));
    verify_rounded(rounded, r, s);
}

void verify_tables(const Step& step, const RoundedCoefficients& coefficients) {
    verify_rounded(step, coefficients);
    verify_order(step);
}

void verify_tables(const Step& step, const TabulatedCurve& curve) {
    verify_curve(step, curve.form, curve.rounded);
}

void verify_form(const Step& step, const TabulatedStep& form) {
    HVI_CHECK(!step.is_explicit() && step.layout == Layout::one);
    HVI_CHECK(!step.depends_on_time() && !step.from_parameter);
    std::visit([&](const auto& tables) { verify_tables(step, tables); }, form.tables);
}

void verify_form(const Step& step, const PairStep& form) {
    HVI_CHECK(form.iteration.has_value() != step.is_explicit());
    HVI_CHECK(form.iteration || step.layout == Layout::one);
    verify_rounded(step, form.coefficients);
    if (form.iteration) { verify_iteration(step, *form.iteration); }
    verify_order(step);
}

void verify_form(const Step& step, const ChartStep& form) {
    const std::size_t s = step.positions.size();
    const bool are_lanes = step.layout == Layout::stages;
    HVI_CHECK(step.slopes == Slopes::joint && (step.layout == Layout::one || are_lanes));
    HVI_CHECK(!are_lanes || (s > 1 && step.in_a_row.empty()));
    HVI_CHECK(step.momenta.size() == s && !step.kept.any() && !step.from_parameter);
    HVI_CHECK(step.blocks.size() == 1 && step.coupled_blocks() == 1);
    verify_rounded(step, form.coefficients);
    verify_iteration(step, form.iteration);
    verify_order(step);
}

void verify_form(const Step& step, const VelocityStep& form) {
    const std::size_t r = step.positions.size();
    HVI_CHECK(step.is_separable() && step.coupled_blocks() == 1 && !step.kept.velocity);
    HVI_CHECK(form.form.c.size() == r && is_table(form.form.n, r, r));
    verify_rounded(form.rounded, r);
    for (const Block& block : step.blocks) {
        HVI_CHECK(block.of(Kind::P).empty() && block.of(Kind::Lq).empty());
    }
    verify_iteration(step, form.iteration);
}

void verify_form(const Step& step, const GalerkinStep& form) {
    const std::size_t r = form.form.nodes(), s = form.form.functions();
    verify_curve(step, form.form, form.rounded);
    HVI_CHECK(step.slopes != Slopes::one_by_one);
    HVI_CHECK(form.side == Side::hamiltonian || step.slopes == Slopes::joint);
    verify_iteration(step, form.iteration);
    HVI_CHECK(form.iteration.extrapolation.empty() &&
              (!form.has_adjoint || !step.in_a_row.empty()));
    if (!form.extrapolation) { return; }
    const std::optional<NumberMatrix>& P = form.extrapolation->P;
    HVI_CHECK(is_table(form.extrapolation->W, s, s));
    HVI_CHECK(P.has_value() == (form.side == Side::hamiltonian) && (!P || is_table(*P, r, r)));
}

/// Checks that the container of vectors goes with the lanes.
void verify_container(const Step& step) {
    const bool are_vectors = step.container == Container::vectors;
    const Layout layout = step.layout;
    HVI_CHECK(are_vectors || (layout != Layout::components && layout != Layout::sites));
    HVI_CHECK(!are_vectors || !step.has_lanes());
    HVI_CHECK(layout != Layout::sites || std::holds_alternative<ExplicitStep>(step.form));
}

/// Checks that only stages side by side have parts for lanes.
void verify_lanes(const Step& step) {
    const bool are_lanes = step.layout == Layout::stages;
    HVI_CHECK(step.register_width == widest_register || (are_lanes && step.register_width == 4));
    HVI_CHECK(step.shared_slopes == 0 || (are_lanes && step.slopes == Slopes::one_by_one));
    if (!step.corrections) { return; }
    const auto& [modes, linear, costs] = *step.corrections;
    const bool has_positions_alone = std::holds_alternative<VelocityStep>(step.form);
    HVI_CHECK(are_lanes && step.iteration()->solver == Solver::automatic);
    HVI_CHECK(has_positions_alone || step.partner == Partner::same);
    HVI_CHECK(modes.to.size() == step.positions.size());
    const auto* stiff = std::get_if<StiffComponents>(&linear);
    HVI_CHECK(stiff == nullptr || (has_positions_alone && !stiff->components.empty()));
    HVI_CHECK(costs.sweep > 0 && costs.correction > costs.sweep && costs.factors > 0);
    HVI_CHECK((costs.linear > costs.sweep) == exists(linear));
}

}  // namespace

void verify(const Step& step) {
    HVI_CHECK(step.in_a_row.empty() || step.layout == Layout::stages ||
              std::holds_alternative<GalerkinStep>(step.form));
    verify_stages(step);
    verify_container(step);
    verify_lanes(step);
    std::visit([&](const auto& form) { verify_form(step, form); }, step.form);
}

}  // namespace hvi::gen

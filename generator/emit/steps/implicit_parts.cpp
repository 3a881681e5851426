// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/implicit_parts.hpp"

#include "generator/emit/steps/clock.hpp"

namespace hvi::gen {

namespace {

NumberMatrix complement(const NumberMatrix& m) {
    NumberMatrix mt(m.front().size(), NumberVector(m.size()));
    for (std::size_t i = 0; i < m.size(); ++i) {
        for (std::size_t j = 0; j < m[i].size(); ++j) { mt[j][i] = Number(1) - m[i][j]; }
    }
    return mt;
}

}  // namespace

NewtonPolicy newton_policy(const Step& step) {
    if (const auto* galerkin = std::get_if<GalerkinStep>(&step.form)) {
        return {"newton_curves", galerkin->side == Side::hamiltonian ? "hvi::NewtonOfCurves"
                                                                     : "hvi::NewtonOfLagrangians"};
    }
    if (std::holds_alternative<ChartStep>(step.form)) {
        return {"newton_charts", "hvi::NewtonOfCharts"};
    }
    const bool has_momenta = std::holds_alternative<PairStep>(step.form);
    if (step.corrections) {
        return {"newton_of_lanes",
                has_momenta ? "hvi::NewtonOfPairLanes" : "hvi::NewtonOfPositionLanes"};
    }
    if (has_momenta && step.container == Container::vectors) {
        return {"newton_pair_products", "hvi::NewtonOfPairProducts"};
    }
    if (has_momenta) { return {"newton_pairs", "hvi::NewtonOfPairs"}; }
    switch (std::get<VelocityStep>(step.form).hessian) {
    case HessianForm::dense:
    case HessianForm::none: break;
    case HessianForm::band: return {"newton_chains", "hvi::NewtonOfChains"};
    case HessianForm::sparse: return {"newton_sparse", "hvi::NewtonOfSparse"};
    case HessianForm::products: return {"newton_products", "hvi::NewtonOfProducts"};
    }
    return {"newton_positions", "hvi::NewtonOfPositions"};
}

bool is_kept(const Step& step, const StageNode& slope) {
    return slope.kind == StageNode::Kind::Lp
               ? step.kept.force && step.positions[slope.index].place != StageValue::Place::inner
               : step.kept.velocity && step.momenta[slope.index].place != StageValue::Place::inner;
}

std::vector<std::vector<Constant>> constants(std::string_view name, const NumberMatrix& exact,
                                             const RoundedMatrix& values) {
    std::vector<std::vector<Constant>> rows(exact.size());
    for (std::size_t i = 0; i < exact.size(); ++i) {
        for (std::size_t j = 0; j < exact[i].size(); ++j) {
            rows[i].push_back({fmt::format("{}_{},{}", name, i + 1, j + 1), values[i][j],
                               exact_text(exact[i][j])});
        }
    }
    return rows;
}

std::string coupled_arguments(const Step& step) {
    return fmt::format("system_, {}{}", coefficients_argument(step), clock_argument(step));
}

std::string end_of_step(const Step& step, std::string_view iterations) {
    return clock_ends(step, fmt::format("s_.end(x, {})", iterations));
}

void rough_table(Writer& writer, std::string_view name, const NumberMatrix& exact) {
    std::vector<std::vector<Constant>> rows(exact.size());
    for (std::size_t i = 0; i < exact.size(); ++i) {
        for (std::size_t j = 0; j < exact[i].size(); ++j) {
            rows[i].push_back(constant(fmt::format("{}_{},{}", name, i + 1, j + 1), exact[i][j]));
        }
    }
    table(writer, name, rows);
}

void rough_table(Writer& writer, std::string_view name, std::string_view formula,
                 const NumberVector& exact) {
    std::vector<Constant> entries;
    for (std::size_t j = 0; j < exact.size(); ++j) {
        entries.push_back(constant(fmt::format("{}_{}", formula, j + 1), exact[j]));
    }
    table(writer, name, entries);
}

std::string gamma_table(const NumberVector& steps) {
    if (steps.empty()) { return {}; }
    Writer writer(1);
    writer.blank().comment("A step is steps of these parts of h.");
    rough_table(writer, "gamma", "gamma", steps);
    return writer.str();
}

std::string coefficients_text(const Step& step, const RoundedCoefficients& coefficients) {
    Writer writer(1);
    table(writer, weights_p(step), weights(step.positions));
    refuse_float(writer, weights(step.positions));
    if (weights_q(step) != weights_p(step)) {
        table(writer, weights_q(step), weights(step.momenta));
        refuse_float(writer, weights(step.momenta));
    }
    writer.blank().comment(
        step.partner == Partner::same
            ? "m_ij = a_ij/b_j, rounded so that m_ij + m_ji is 1 exactly, as is mt_ij = m_ij."
            : "m_ij = a_ij/b_j and mt_ij = a~_ij/b_j, rounded so that m_ij + mt_ji is 1 exactly.");
    const auto m = constants("m", step.m, coefficients.m);
    table(writer, "m", m);
    for (const auto& row : m) { refuse_float(writer, row); }
    if (step.partner != Partner::same) {
        table(writer, "mt", constants("mt", complement(step.m), coefficients.mt));
    }
    writer.line("static_assert(hvi::detail::complementary(m, {}), \"the method is symplectic\");",
                table_mt(step));
    return writer.str();
}

}  // namespace hvi::gen

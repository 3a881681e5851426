// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/implicit_parts.hpp"

#include "generator/plan/lattice.hpp"

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

bool is_kept(const Scheme& scheme, const StageNode& slope) {
    return slope.kind == StageNode::Kind::Lp
               ? scheme.keeps_force &&
                     scheme.positions[slope.index].place != StageValue::Place::inner
               : scheme.keeps_velocity &&
                     scheme.momenta[slope.index].place != StageValue::Place::inner;
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

std::string coupled_arguments(const Scheme& scheme) {
    return fmt::format("system_, {}{}", scheme.from_parameter ? "coefficients_, " : "",
                       scheme.depends_on_time ? "clock_, " : "");
}

std::string end_of_step(const Scheme& scheme, std::string_view iterations) {
    const std::string end = fmt::format("s_.end(x, {})", iterations);
    return scheme.depends_on_time ? fmt::format("clock_.end(x.t, {})", end) : end;
}

std::string coefficients_text(const Scheme& scheme) {
    const RoundedCoefficients coefficients = rounded(scheme);
    Writer writer(1);
    table(writer, weights_p(scheme), weights(scheme.positions));
    refuse_float(writer, weights(scheme.positions));
    if (weights_q(scheme) != weights_p(scheme)) {
        table(writer, weights_q(scheme), weights(scheme.momenta));
        refuse_float(writer, weights(scheme.momenta));
    }
    writer.blank().comment(
        scheme.one_tableau()
            ? "m_ij = a_ij/b_j, rounded so that m_ij + m_ji is 1 exactly, as is mt_ij = m_ij."
            : "m_ij = a_ij/b_j and mt_ij = a~_ij/b_j, rounded so that m_ij + mt_ji is 1 exactly.");
    const auto m = constants("m", scheme.m, coefficients.m);
    table(writer, "m", m);
    for (const auto& row : m) { refuse_float(writer, row); }
    if (!scheme.one_tableau()) {
        table(writer, "mt", constants("mt", complement(scheme.m), coefficients.mt));
    }
    writer.line("static_assert(hvi::detail::complementary(m, {}), \"the method is symplectic\");",
                table_mt(scheme));
    return writer.str();
}

}  // namespace hvi::gen

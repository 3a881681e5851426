// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/implicit_parts.hpp"

#include <algorithm>

#include "generator/plan/lattice.hpp"

namespace hvi::gen {

namespace {

/// NOTE: starting values need not be good to the last bit.
RoundedMatrix nearest_or_small(const NumberMatrix& exact) {
    RoundedMatrix values;
    for (const NumberVector& row : exact) {
        std::vector<Rounded>& rounded = values.emplace_back();
        for (const Number& entry : row) { rounded.push_back(nearest_or_small(entry)); }
    }
    return values;
}

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

void open_predict(Writer& writer, const Scheme& scheme, std::string_view slopes) {
    writer.comment(
        scheme.extrapolation
            ? fmt::format("Starting values: the polynomial through the {0} of the last {1}, else "
                          "{0} as at the start of this one.",
                          slopes, scheme.extrapolation_before ? "two steps" : "step")
            : fmt::format("Starting values: {} as at the start of the step.", slopes),
        "/// ");
    writer.open("void predict() {{");
}

std::string extrapolation_text(const Scheme& scheme) {
    Writer writer(1);
    const auto write = [&](std::string_view name, const NumberMatrix& exact) {
        table(writer, name, constants(name, exact, nearest_or_small(exact)));
    };
    if (!scheme.extrapolation_before) {
        writer.comment("Slopes of the next step are about N times those of this one.");
        write("N", *scheme.extrapolation);
        return writer.str();
    }
    writer.comment("Slopes of the next step are about N times those of this one, and N_before "
                   "times those of the one before.");
    write("N", *scheme.extrapolation);
    write("N_before", *scheme.extrapolation_before);
    return writer.str();
}

std::vector<std::string_view> predicted_slopes(const Scheme& scheme) {
    if (scheme.velocity_form) { return {"W"}; }
    const auto are_unknown = [&](StageNode::Kind kind) {
        return std::any_of(scheme.blocks.begin(), scheme.blocks.end(), [&](const Block& block) {
            return block.coupled && !block.of(kind).empty();
        });
    };
    std::vector<std::string_view> slopes;
    // NOTE: for separable H those of p are enough.
    if (!scheme.separable && are_unknown(StageNode::Kind::Lq)) { slopes.push_back("Lq"); }
    if (are_unknown(StageNode::Kind::Lp)) { slopes.push_back("Lp"); }
    return slopes;
}

void open_extrapolation(Writer& writer, const Scheme& scheme) {
    if (scheme.extrapolation_before) {
        writer.line("const bool goes_on = s_.h == s_.h_before;");
        writer.open("if (goes_on && has_slopes_before_) {{");
    } else {
        writer.open("if (s_.h == s_.h_before) {{");
    }
}

void close_extrapolation(Writer& writer, const Scheme& scheme) {
    writer.line("return;").close();
    if (!scheme.extrapolation_before) { return; }
    writer.line("has_slopes_before_ = goes_on;");
    for (const std::string_view slope : predicted_slopes(scheme)) {
        writer.line("{0}_before_ = s_.{0};", slope);
    }
}

void declare_slopes_before(Writer& writer, const Scheme& scheme) {
    if (!scheme.extrapolation_before) { return; }
    for (const std::string_view slope : predicted_slopes(scheme)) {
        writer.line("decltype(s_.{0}) {0}_before_{{}};  // of the step before the last", slope);
    }
    writer.line(
        "bool has_slopes_before_ = false;  // it was of the same size, and led to the last");
}

std::string extrapolated(const Scheme& scheme, std::size_t i, std::string_view slope) {
    std::string sum;
    const auto add = [&](std::string_view table, std::string_view of) {
        for (std::size_t j = 0; j < scheme.positions.size(); ++j) {
            sum += fmt::format("{}{}[{}][{}] * {}{}_{}", sum.empty() ? "" : " + ", table, i, j,
                               slope, of, j + 1);
        }
    };
    add("N", "");
    if (scheme.extrapolation_before) { add("N_before", "_before"); }
    return sum;
}

void recall_slopes(Writer& writer, const Scheme& scheme, std::string_view slope) {
    const std::size_t s = scheme.positions.size();
    for (std::size_t j = 0; j < s; ++j) {
        writer.line("const Scalar {0}_{1} = s_.{0}[{2}][k];", slope, j + 1, j);
    }
    if (!scheme.extrapolation_before) { return; }
    for (std::size_t j = 0; j < s; ++j) {
        writer.line("const Scalar {0}_before_{1} = {0}_before_[{2}][k];", slope, j + 1, j);
    }
    for (std::size_t j = 0; j < s; ++j) {
        writer.line("{0}_before_[{2}][k] = {0}_{1};", slope, j + 1, j);
    }
}

}  // namespace hvi::gen

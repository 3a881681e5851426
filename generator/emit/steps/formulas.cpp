// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/header.hpp"
#include "generator/plan/equal.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

bool is_merged(const Scheme& scheme) {
    for (const auto* values : {&scheme.positions, &scheme.momenta}) {
        for (const StageValue& value : *values) {
            if (value.stages.size() > 1) { return true; }
        }
    }
    return false;
}

/// NOTE: zero and one leave no trace in the arithmetic: no term, no factor.
struct Term {
    Number coefficient;
    std::string factor;  // the coefficient in the header
    std::string slope;
};

std::string sum(const std::vector<Term>& terms) {
    std::string text;
    for (const Term& term : terms) {
        if (equal(term.coefficient, 0)) { continue; }
        if (!text.empty()) { text += " + "; }
        text += equal(term.coefficient, 1) ? term.slope : term.factor + " * " + term.slope;
    }
    HVI_CHECK(!text.empty());
    return text;
}

/// y + (e + (sum)): the small ones first.
std::string stage(std::string_view y, const std::string& terms) {
    const bool one_term = terms.find(" + ") == std::string::npos;
    return one_term ? fmt::format("{0} + (e_{0} + {1})", y, terms)
                    : fmt::format("{0} + (e_{0} + ({1}))", y, terms);
}

std::string factor(const Scheme& scheme, const StageValue& value, std::string_view letter,
                   const std::string& weights, std::size_t index, std::string_view s) {
    if (rounds_weights(scheme)) { return fmt::format("{}.hb_{}[{}]", s, letter, index); }
    if (equal(value.weight, 1)) { return fmt::format("{}.h", s); }
    return fmt::format("{}.h * {}{}[{}]", s, owner(scheme, s), weights, index);
}

}  // namespace

std::string weights_q(const Scheme& scheme) { return is_merged(scheme) ? "b_q" : "b"; }
std::string weights_p(const Scheme& scheme) { return is_merged(scheme) ? "b_p" : "b"; }
std::string_view table_mt(const Scheme& scheme) { return scheme.one_tableau() ? "m" : "mt"; }

std::string_view owner(const Scheme& scheme, std::string_view s) {
    if (!scheme.from_parameter) { return ""; }
    return s == "s_" ? "coefficients_." : "c.";
}

bool rounds_weights(const Scheme& scheme) {
    for (const auto* values : {&scheme.positions, &scheme.momenta}) {
        for (const StageValue& value : *values) {
            if (!is_power_of_two(value.weight)) { return true; }
        }
    }
    return false;
}

std::string position_sum(const Scheme& scheme, std::size_t i, std::string_view s) {
    std::vector<Term> terms;
    for (std::size_t j = 0; j < scheme.momenta.size(); ++j) {
        terms.push_back({scheme.m[i][j], fmt::format("{}m[{}][{}]", owner(scheme, s), i, j),
                         fmt::format("{}.Lq[{}][k]", s, j)});
    }
    return stage("q", sum(terms));
}

std::string momentum_sum(const Scheme& scheme, std::size_t j, std::string_view s) {
    std::vector<Term> terms;
    for (std::size_t i = 0; i < scheme.positions.size(); ++i) {
        terms.push_back({Number(1) - scheme.m[i][j],
                         fmt::format("{}{}[{}][{}]", owner(scheme, s), table_mt(scheme), j, i),
                         fmt::format("{}.Lp[{}][k]", s, i)});
    }
    return stage("p", sum(terms));
}

std::string stage_time(const Scheme& scheme, std::size_t i, std::string_view s) {
    if (!scheme.depends_on_time) { return {}; }
    if (scheme.has_trajectory_lanes) { return fmt::format("x.clock.at(c[{}]), ", i); }
    return fmt::format("{}.t[{}], ", s == "s_" ? "clock_" : "clock", i);
}

std::string_view start_time(const Scheme& scheme) {
    return scheme.depends_on_time ? "clock_.start, " : "";
}

std::string clock_type(const Scheme& scheme) {
    return fmt::format("hvi::detail::Clock<Scalar, {}>", scheme.positions.size());
}

std::string clock_begins(const Scheme& scheme) {
    if (!scheme.depends_on_time) { return {}; }
    return fmt::format("if (!clock_.begin(x.t, h, {}c)) {{ reset(); }}\n"
                       "if (!clock_.ends()) {{ return Status(Status::Code::not_finite); }}",
                       owner(scheme, "s_"));
}

std::string times_text(const Scheme& scheme) {
    std::vector<Constant> c;
    for (std::size_t i = 0; i < scheme.c.size(); ++i) {
        c.push_back({fmt::format("c_{}", i + 1), nearest(scheme.c[i]), exact_text(scheme.c[i])});
    }
    Writer writer(1);
    table(writer, "c", c);
    return writer.str();
}

std::string evaluate_velocity(const Scheme& scheme, std::size_t j, std::string_view s) {
    if (!scheme.separable) {
        return fmt::format("dHdp({0}.Q[{1}], {0}.P[{1}], {2}slope);", s, j,
                           stage_time(scheme, j, s));
    }
    if (scheme.momenta[j].place == StageValue::Place::inner) {
        return fmt::format("dHdp({}.P[{}], slope);", s, j);
    }
    return fmt::format("dHdp({}.at.p, slope);", s);
}

std::string evaluate_force(const Scheme& scheme, std::size_t i, std::string_view s) {
    const std::string time = stage_time(scheme, i, s);
    if (!scheme.separable) {
        return fmt::format("dHdq({0}.Q[{1}], {0}.P[{1}], {2}slope);", s, i, time);
    }
    if (scheme.positions[i].place == StageValue::Place::inner) {
        return fmt::format("dHdq({}.Q[{}], {}slope);", s, i, time);
    }
    return fmt::format("dHdq({}.at.q, {}slope);", s, time);
}

std::string velocity_factor(const Scheme& scheme, std::size_t j, std::string_view s) {
    return factor(scheme, scheme.momenta[j], "q", weights_q(scheme), j, s);
}

std::string force_factor(const Scheme& scheme, std::size_t i, std::string_view s) {
    return "-" + factor(scheme, scheme.positions[i], "p", weights_p(scheme), i, s);
}

}  // namespace hvi::gen

// A certificate for people, in a terminal of 80 columns.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numeric>

#include "generator/render/certificate.hpp"
#include "generator/render/entry.hpp"
#include "generator/render/named_lines.hpp"

namespace hvi::gen {

namespace {

/// Returns what is not proved, and why; empty for a proof.
std::string evidence(bool proved, const Findings& findings) {
    if (proved) { return ""; }
    return findings.within_digits ? ", within digits" : ", by enclosures of 50 digits";
}

}  // namespace

void write_exceptions(NamedLines& lines, const std::vector<ExceptionalValue>& exceptions) {
    for (const ExceptionalValue& value : exceptions) {
        lines.line("", fmt::format("{}{} at {} = {}", value.is_at_least ? "at least " : "",
                                   value.order, value.parameter, value_text(value.value)));
    }
}

std::string yes_or_no(const Verdict& verdict, const Findings& findings) {
    return (verdict.holds ? "yes" : "no") + evidence(verdict.proved, findings);
}

std::string order_text(const OrderConditions& conditions, const Findings& findings) {
    const auto satisfied = std::accumulate(
        conditions.conditions.begin(),
        conditions.conditions.begin() +
            std::min<long>(conditions.order, static_cast<long>(conditions.conditions.size())),
        std::int64_t{0});
    const std::string rest =
        conditions.is_at_least
            ? ", and no higher one was looked at"
            : fmt::format(", and {} of order {} fail{}", conditions.failures.size(),
                          conditions.order + 1, conditions.failures.size() == 1 ? "s" : "");
    return fmt::format("{}{}: {} conditions hold{}{}", conditions.is_at_least ? "at least " : "",
                       conditions.order, satisfied, rest, evidence(conditions.proved, findings));
}

void write_failures(NamedLines& lines, const OrderConditions& conditions) {
    constexpr std::size_t most_shown = 8;
    if (conditions.is_at_least) { return; }
    for (std::size_t i = 0; i < std::min(most_shown, conditions.failures.size()); ++i) {
        const FailedCondition& failure = conditions.failures[i];
        lines.line(i == 0 ? "fails" : "",
                   fmt::format("{}: {}", failure.tree->text, value_text(failure.residual)));
    }
    if (conditions.failures.size() > most_shown) {
        lines.line("", fmt::format("and {} more", conditions.failures.size() - most_shown));
    }
    if (const auto constant = conditions.error_constant()) {
        lines.line("error", short_decimal(*constant) +
                                ", the norm of the first coefficients of the local error");
    }
}

namespace {

std::string conserved(const Certificate& certificate) {
    if (certificate.conserves_quadratic()) { return "all linear and quadratic invariants"; }
    if (certificate.conserves_qCp()) { return "linear invariants and q^T C p"; }
    return certificate.common_weights.holds ? "linear invariants"
                                            : "linear invariants of q alone and of p alone";
}

std::string explicit_text(const Certificate& certificate) {
    if (certificate.coupled_general.empty()) { return "for every H"; }
    return certificate.coupled_separable.empty() ? "for H = T(p) + U(q)" : "no";
}

/// Returns `Q_2, Q_3, P_1`, or of many the first and the last: `Q_1 .. Q_8, P_1 .. P_8`.
std::string group_text(const std::vector<StageNode>& group) {
    std::string text;
    for (const StageNode::Kind kind : {StageNode::Kind::Q, StageNode::Kind::P}) {
        std::vector<std::string> names;
        std::size_t first = 0, last = 0;
        for (const StageNode& node : group) {
            if (node.kind != kind) { continue; }
            if (names.empty()) { first = node.index; }
            last = node.index;
            names.push_back(stage_name(node));
        }
        const bool is_run = names.size() > 3 && last - first + 1 == names.size();
        if (is_run) { names = {names.front() + " .. " + names.back()}; }
        for (const std::string& name : names) { text += (text.empty() ? "" : ", ") + name; }
    }
    return text;
}

void write_coupled(NamedLines& lines, std::string_view what,
                   const std::vector<std::vector<StageNode>>& groups) {
    for (std::size_t i = 0; i < groups.size(); ++i) {
        lines.line(i == 0 ? what : "", group_text(groups[i]) + " are solved for at once");
    }
}

std::string enumerated(const std::vector<std::string>& names) {
    return fmt::format("{}", fmt::join(names, ", "));
}

std::string indices(const std::vector<std::size_t>& numbers, std::string_view letter) {
    std::string text;
    for (const std::size_t i : numbers) {
        text += fmt::format("{}{}_{}", text.empty() ? "" : ", ", letter, i);
    }
    return text;
}

}  // namespace

void write_signs(NamedLines& lines, const Findings& findings) {
    if (!findings.negative_weights.empty()) {
        lines.line("negative", indices(findings.negative_weights, "b"));
    }
    if (!findings.nodes_outside.empty()) {
        lines.line("outside [0,1]", indices(findings.nodes_outside, "c"));
    }
}

namespace {

void write_stability(NamedLines& lines, const LinearStability& stability) {
    std::string intervals;
    for (const StabilityInterval& interval : stability.stable) {
        intervals += fmt::format("{}{}{}, {}{}", intervals.empty() ? "" : ", ",
                                 interval.low_included ? "[" : "(", short_decimal(interval.low),
                                 short_decimal(interval.high), interval.high_included ? "]" : ")");
    }
    lines.line("stable", intervals.empty() ? "nowhere" : "z = h omega in " + intervals);
    std::string poles;
    for (const Number& pole : stability.poles) {
        poles += (poles.empty() ? "" : ", ") + short_decimal(pole);
    }
    if (!poles.empty()) { lines.line("no step", "at z = " + poles); }
    for (const TouchingPoint& point : stability.touching) {
        lines.line("resonance",
                   fmt::format("z = {}: trace/2 = {}{}", short_decimal(point.z), point.half_trace,
                               point.is_identity ? ", the map is that multiple of 1"
                                                 : ", powers of the map grow"));
    }
    const LimitOfHalfTrace& limit = stability.at_infinity;
    lines.line("large z", fmt::format("trace/2 tends to {}: {}",
                                      limit.value      ? short_decimal(*limit.value)
                                      : limit.sign < 0 ? "-infinity"
                                                       : "infinity",
                                      limit.is_stable ? "stable" : "not stable"));
}

std::optional<std::string> half_trace_text(const PolynomialQuotient& half_trace) {
    const std::string too_long = "trace/2 has coefficients that are too long for a line";
    for (const NumberVector* part : {&half_trace.numerator, &half_trace.denominator}) {
        for (const Number& coefficient : *part) {
            const bool is_long = coefficient.has_parameters() && !is_readable(coefficient);
            if (is_long) { return too_long + "; --format json has them"; }
        }
    }
    const auto form = closed_form(half_trace);
    if (!form) { return std::nullopt; }
    const std::string text = to_text(*form);
    return is_readable(text) ? "trace/2 = " + text : too_long;
}

}  // namespace

void write_oscillator(NamedLines& lines, const Findings& findings) {
    const auto& map = findings.oscillator;
    if (!map) {
        lines.line("oscillator", "not looked at: " + why_no_oscillator(findings));
        return;
    }
    if (const auto text = half_trace_text(map->half_trace)) { lines.line("oscillator", *text); }
    if (!map->determinant_one.holds) {
        lines.line("determinant",
                   "not 1: stable is where both eigenvalues lie inside the unit circle");
    } else if (map->determinant_one.proved) {
        lines.line("determinant", "1, by exact arithmetic");
    }
    if (findings.stability) { write_stability(lines, *findings.stability); }
}

void write_splitting(NamedLines& lines, const std::vector<std::size_t>& orders) {
    if (orders.empty()) { return; }
    std::string error;
    for (std::size_t k = 0; k < orders.size(); ++k) {
        error += fmt::format("{}eps{}*h^{}", k == 0 ? "" : " + ",
                             k == 0 ? "" : fmt::format("^{}", k + 1), orders[k]);
    }
    lines.line("for A+eps*B",
               fmt::format("order ({}): the error of the Hamiltonian is O({}), to 50 digits",
                           fmt::join(orders, ", "), error));
}

void write_certificate(NamedLines& lines, const Certificate& certificate) {
    const Orders& orders = certificate.orders;
    lines.line("order", order_text(orders.general, certificate));
    write_exceptions(lines, certificate.exceptions);
    lines.line("  separable", order_text(orders.separable, certificate));
    lines.line("  Nystrom", order_text(orders.nystrom, certificate));
    write_failures(lines, orders.general);
    write_splitting(lines, certificate.splitting);
    lines.blank();
    lines.line("symplectic", yes_or_no(certificate.symplectic, certificate));
    lines.line("self-adjoint", yes_or_no(certificate.symmetric, certificate));
    if (!certificate.symmetric.holds && !certificate.adjoint.empty()) {
        lines.line("adjoint", enumerated(certificate.adjoint));
    }
    lines.line("A == A~", yes_or_no(certificate.runge_kutta, certificate));
    lines.line("conserves", conserved(certificate));
    lines.line("explicit", explicit_text(certificate));
    write_coupled(lines, "  separable", certificate.coupled_separable);
    write_coupled(lines, "  any H", certificate.coupled_general);
    write_signs(lines, certificate);
    lines.blank();
    write_oscillator(lines, certificate);
    lines.blank();
}

std::string render_text(const Certificate& certificate,
                        const std::optional<SceneStatements>& scene) {
    NamedLines lines;
    lines.title(certificate.name.empty() ? certificate.origin : certificate.name);
    if (certificate.name.empty() && !certificate.known_as.empty()) {
        lines.line("known as", enumerated(certificate.known_as));
    }
    lines.blank();
    write_certificate(lines, certificate);
    lines.title(certificate.is_proved() ? "All of it is proved."
                                        : "Some of it rests on enclosures of 50 digits.");
    write_statements(lines, scene);
    return lines.text();
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/functions/domain.hpp"

namespace hvi::gen {

namespace {

std::optional<std::string> short_form(const Number& number) {
    constexpr std::size_t longest = 20;
    const auto form = number.closed_form();
    if (!form) return std::nullopt;
    std::string text = to_text(*form);
    return text.size() <= longest ? std::optional(std::move(text)) : std::nullopt;
}

}  // namespace

std::string Domain::text() const {
    return "[" + short_form(low).value_or(low.decimal(4)) + ", " +
           short_form(high).value_or(high.decimal(4)) + "]";
}

std::optional<Domain> domain_of(const std::vector<Number>& nodes) {
    Domain result;
    for (const Number& node : nodes) {
        if (node.has_parameters()) return std::nullopt;
        // NOTE: most nodes lie in [0, 1] and far from its ends, where the comparison is decided at
        // once.
        const Number below = node - result.low;
        const Number above = node - result.high;
        if (below.known_zero() == true || above.known_zero() == true) continue;
        if (below.sign() < 0) result.low = node;
        if (above.sign() > 0) result.high = node;
    }
    return result;
}

std::string at_tau(const Number& point) {
    const auto form = short_form(point);
    return form ? "at tau = " + *form : "near tau = " + point.decimal(4);
}

}  // namespace hvi::gen

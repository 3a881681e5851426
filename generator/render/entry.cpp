// Common parts of the formats.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/render/entry.hpp"

#include <fmt/format.h>

#include <utility>

namespace hvi::gen {

namespace {

Part vector_part(std::string_view name, const NumberVector& vector) {
    NumberMatrix rows;
    for (const Number& number : vector) rows.push_back({number});
    return {name, true, std::move(rows)};
}

}  // namespace

std::optional<std::string> Entry::exact_text() const {
    if (!exact) return {};
    return to_text(*exact);
}

std::string Entry::best_text() const { return exact ? to_text(*exact) : decimal.value_or("?"); }

Entry make_entry(const Number& number, int digits) {
    HVI_CHECK(digits >= 1);
    Entry entry;
    entry.exact = number.closed_form();
    if (number.has_parameters()) return entry;
    entry.decimal = number.decimal(digits);
    entry.hex = fmt::format("{:a}", number.nearest_double());
    return entry;
}

std::vector<Part> parts(const Tableau& tableau) {
    std::vector<Part> result{vector_part("c", tableau.c),
                             vector_part("b", tableau.b),
                             vector_part("c_tilde", tableau.c_tilde),
                             {"A", false, tableau.A},
                             {"A_tilde", false, tableau.A_tilde}};
    if (!tableau.galerkin) { return result; }
    result.push_back({"M", false, tableau.galerkin->M});
    result.push_back({"M_inverse", false, tableau.galerkin->M_inverse});
    result.push_back(vector_part("B", tableau.galerkin->B));
    result.push_back({"A_psi", false, tableau.galerkin->A_psi});
    return result;
}

std::vector<Part> parts(const GalerkinRule& rule) {
    return {vector_part("c", rule.c), vector_part("b", rule.b),     vector_part("B", rule.B),
            {"Psi", false, rule.Psi}, {"A_psi", false, rule.A_psi}, {"gram", false, rule.gram}};
}

std::vector<Part> nystrom_parts(const GalerkinRule& rule) {
    NystromTableau tableau = nystrom(rule);
    return {vector_part("c", rule.c),
            {"A_bar", false, std::move(tableau.A_bar)},
            vector_part("b_bar", tableau.b_bar),
            vector_part("b", rule.b)};
}

std::vector<Part> all_parts(const GalerkinRule& rule) {
    std::vector<Part> result = parts(rule);
    const std::vector<Part> more = nystrom_parts(rule);
    result.insert(result.end(), {more[1], more[2]});
    return result;
}

}  // namespace hvi::gen

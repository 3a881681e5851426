// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/relations.hpp"

#include <algorithm>
#include <set>

#include "generator/hamiltonian/sparse_equations.hpp"
#include "generator/hamiltonian/vanishing.hpp"

namespace hvi::gen {

namespace {

using GiNaC::ex;

std::vector<SparseVector> rows_of(const std::vector<MonomialSum>& functions) {
    std::map<FunctionMonomial, SparseVector, MonomialOrder> by_monomial;
    for (std::size_t k = 0; k < functions.size(); ++k)
        for (const auto& [monomial, coefficient] : functions[k])
            by_monomial[monomial][k] = coefficient;
    std::vector<SparseVector> rows;
    for (auto& [monomial, row] : by_monomial) rows.push_back(std::move(row));
    std::stable_sort(rows.begin(), rows.end(), [](const SparseVector& a, const SparseVector& b) {
        return a.size() < b.size();
    });
    return rows;
}

}  // namespace

Relations relations(Monomials& monomials, std::vector<MonomialSum> functions,
                    const Sampler& sampler) {
    const bool common = bring_to_common_powers(monomials, functions);
    std::vector<SparseVector> rows = rows_of(functions);
    std::set<std::size_t> undecided;
    for (;;) {
        SparseEquations equations(monomials.algebra());
        Relations result;
        try {
            for (const std::size_t column : undecided)
                static_cast<void>(equations.insert({{column, 1}}));
            for (const SparseVector& row : rows) static_cast<void>(equations.insert(row));
            result.basis = equations.solutions(functions.size());
        } catch (const UndecidedEntry& entry) {
            // NOTE: a vector without this column is a relation all the same.
            undecided.insert(entry.column);
            for (SparseVector& row : rows) row.erase(entry.column);
            continue;
        }
        const bool proved = undecided.empty() &&
                            ((common && is_independent(monomials, functions)) ||
                             (sampler && are_independent_at_points(monomials.algebra(), sampler,
                                                                   equations.pivots())));
        if (!proved)
            result.doubt = undecided.empty()
                               ? "it is not known whether the functions in it are independent"
                               : "it is not known whether some coefficients are zero";
        return result;
    }
}

/// NOTE: the normal form of a sum of many fractions takes minutes.
Vanishing vanishing_by_monomials(const Algebra& algebra, const ex& expression) {
    constexpr std::size_t most_in_normal_form = 40;  // terms
    if (expression.is_zero()) return Vanishing::proved;
    if (is_surely_not_zero(algebra, expression)) return Vanishing::refuted;
    Monomials monomials(algebra);
    const auto sum = monomials.sum(expression);
    if (!sum) return Vanishing::unknown;
    std::vector<MonomialSum> one{*sum};
    static_cast<void>(bring_to_common_powers(monomials, one));
    const bool zero = std::all_of(one[0].begin(), one[0].end(), [&](const auto& term) {
        return vanishing(algebra, term.second) == Vanishing::proved;
    });
    if (zero) return Vanishing::proved;
    return sum->size() <= most_in_normal_form ? vanishing(algebra, expression) : Vanishing::unknown;
}

}  // namespace hvi::gen

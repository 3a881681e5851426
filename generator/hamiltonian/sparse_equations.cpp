// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/sparse_equations.hpp"

#include "generator/hamiltonian/normal_form.hpp"
#include "generator/hamiltonian/vanishing.hpp"
#include "generator/support/work.hpp"

namespace hvi::gen {

namespace {

using GiNaC::ex;

ex in_lowest_terms(const ex& entry) {
    spend_work();
    return GiNaC::is_a<GiNaC::numeric>(entry) ? entry : normal_form(entry);
}

/// Subtracts factor * pivot from a row, which removes the first entry of the pivot from the row.
void subtract(SparseVector& row, const ex& factor, const SparseVector& pivot) {
    const ex times = factor;
    for (const auto& [column, entry] : pivot) {
        ex& target = row[column];
        target = in_lowest_terms(target - times * entry);
        if (target.is_zero()) row.erase(column);
    }
    row.erase(pivot.begin()->first);
}

}  // namespace

bool SparseEquations::is_zero(std::size_t column, const ex& entry) const {
    if (GiNaC::is_a<GiNaC::numeric>(entry)) return entry.is_zero();
    const Vanishing found = vanishing(algebra_, entry);
    if (found == Vanishing::unknown) throw UndecidedEntry{column};
    return found == Vanishing::proved;
}

SparseVector SparseEquations::reduced(SparseVector row) const {
    for (auto position = row.begin(); position != row.end();) {
        const std::size_t column = position->first;
        const auto pivot = pivots_.find(column);
        if (pivot != pivots_.end()) subtract(row, position->second, pivot->second);
        position = row.upper_bound(column);
    }
    return row;
}

bool SparseEquations::insert(SparseVector row) {
    row = reduced(std::move(row));
    while (!row.empty() && is_zero(row.begin()->first, row.begin()->second)) row.erase(row.begin());
    if (row.empty()) return false;
    const std::size_t column = row.begin()->first;
    const ex first = row.begin()->second;
    for (auto& [number, entry] : row) entry = in_lowest_terms(entry / first);
    pivots_.emplace(column, std::move(row));
    return true;
}

std::vector<SparseVector> SparseEquations::solutions(std::size_t unknowns) {
    for (auto pivot = pivots_.rbegin(); pivot != pivots_.rend(); ++pivot) {
        SparseVector rest = pivot->second;
        rest.erase(rest.begin());
        rest = reduced(std::move(rest));
        rest[pivot->first] = 1;
        pivot->second = std::move(rest);
    }
    std::map<std::size_t, SparseVector> by_free_unknown;
    for (std::size_t column = 0; column < unknowns; ++column)
        if (pivots_.count(column) == 0) by_free_unknown[column][column] = 1;
    for (const auto& [column, row] : pivots_)
        for (auto entry = std::next(row.begin()); entry != row.end(); ++entry)
            if (!is_zero(entry->first, entry->second))
                by_free_unknown.at(entry->first)[column] = -entry->second;
    std::vector<SparseVector> basis;
    for (auto& [column, vector] : by_free_unknown) basis.push_back(std::move(vector));
    return basis;
}

std::vector<std::size_t> SparseEquations::pivots() const {
    std::vector<std::size_t> columns;
    for (const auto& [column, row] : pivots_) columns.push_back(column);
    return columns;
}

}  // namespace hvi::gen

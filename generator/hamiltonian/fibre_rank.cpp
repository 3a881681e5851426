// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/fibre_rank.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "generator/hamiltonian/relations.hpp"
#include "generator/hamiltonian/vanishing.hpp"

namespace hvi::gen {

namespace {

using GiNaC::ex;

/// Returns the matrix of second derivatives by the last n variables.
GiNaC::matrix fibre_hessian(const Algebra& algebra, unsigned n) {
    const std::size_t first = algebra.variables().size() - n;
    GiNaC::matrix result(n, n);
    for (unsigned i = 0; i < n; ++i) {
        const ex slope = algebra.derivative(algebra.function(), algebra.variables()[first + i]);
        for (unsigned j = 0; j <= i; ++j)
            result(i, j) = result(j, i) = algebra.derivative(slope, algebra.variables()[first + j]);
    }
    return result;
}

/// Returns equations for the constant vectors that the matrix takes to zero: a row of the matrix
/// has one for each monomial. Returns nothing where an entry is too long.
std::optional<SparseEquations> null_equations(const Algebra& algebra, const GiNaC::matrix& matrix) {
    Monomials monomials(algebra);
    SparseEquations equations(algebra);
    for (unsigned i = 0; i < matrix.rows(); ++i) {
        std::vector<MonomialSum> row;
        for (unsigned j = 0; j < matrix.rows(); ++j) {
            auto entry = monomials.sum(matrix(i, j));
            if (!entry) return {};
            row.push_back(*std::move(entry));
        }
        static_cast<void>(bring_to_common_powers(monomials, row));
        std::map<FunctionMonomial, SparseVector, MonomialOrder> by_monomial;
        for (std::size_t j = 0; j < row.size(); ++j)
            for (const auto& [monomial, coefficient] : row[j])
                by_monomial[monomial][j] = coefficient;
        for (auto& [monomial, equation] : by_monomial)
            static_cast<void>(equations.insert(std::move(equation)));
    }
    return equations;
}

/// Returns the given rows and columns of a matrix.
GiNaC::matrix minor(const GiNaC::matrix& whole, const std::vector<unsigned>& rows,
                    const std::vector<unsigned>& columns) {
    GiNaC::matrix result(static_cast<unsigned>(rows.size()), static_cast<unsigned>(columns.size()));
    for (unsigned i = 0; i < rows.size(); ++i)
        for (unsigned j = 0; j < columns.size(); ++j) result(i, j) = whole(rows[i], columns[j]);
    return result;
}

std::vector<unsigned> with(std::vector<unsigned> numbers, const std::vector<unsigned>& more) {
    numbers.insert(numbers.end(), more.begin(), more.end());
    return numbers;
}

/// Returns the numbers of rows and columns whose minor is surely regular. No one and no two more
/// numbers give a minor that is still seen to be regular.
std::vector<unsigned> regular_part(const Algebra& algebra, const GiNaC::matrix& whole) {
    std::vector<unsigned> kept;
    const auto grows_by = [&](const std::vector<unsigned>& more) {
        const bool is_new = std::none_of(more.begin(), more.end(), [&](unsigned i) {
            return std::find(kept.begin(), kept.end(), i) != kept.end();
        });
        const std::vector<unsigned> all = with(kept, more);
        const bool grows = is_new && is_surely_regular(algebra, minor(whole, all, all));
        if (grows) kept = all;
        return grows;
    };
    for (unsigned i = 0; i < whole.rows(); ++i)
        if (!grows_by({i}))
            for (unsigned j = 0; j < i && !grows_by({j, i}); ++j) {}
    return kept;
}

/// Returns the rank of a symmetric matrix. It is the rank of a regular part if every minor with one
/// more row and column vanishes. Returns nothing where that is not proved, or where these minors
/// are too large.
std::optional<std::size_t> rank_by_minors(const Algebra& algebra, const GiNaC::matrix& whole) {
    constexpr std::size_t most_rows = 4;
    const std::vector<unsigned> kept = regular_part(algebra, whole);
    if (kept.size() >= most_rows) return {};
    for (unsigned i = 0; i < whole.rows(); ++i)
        for (unsigned j = 0; j <= i; ++j) {
            const ex determinant =
                minor(whole, with(kept, {i}), with(kept, {j})).determinant().expand();
            if (vanishing_by_monomials(algebra, determinant) != Vanishing::proved) return {};
        }
    return kept.size();
}

std::optional<std::size_t> rank_of(const Algebra& algebra, std::size_t degrees_of_freedom) {
    const GiNaC::matrix whole = fibre_hessian(algebra, static_cast<unsigned>(degrees_of_freedom));
    if (is_surely_regular(algebra, whole)) return degrees_of_freedom;
    try {
        const auto equations = null_equations(algebra, whole);
        if (!equations) return {};
        // A symmetric matrix has its rank on these rows and columns.
        const std::vector<std::size_t> kept = equations->pivots();
        const auto rank = static_cast<unsigned>(kept.size());
        if (rank == 0) return 0;
        GiNaC::matrix part(rank, rank);
        for (unsigned i = 0; i < rank; ++i)
            for (unsigned j = 0; j < rank; ++j)
                part(i, j) = whole(static_cast<unsigned>(kept[i]), static_cast<unsigned>(kept[j]));
        if (is_surely_regular(algebra, part)) return rank;
        return rank_by_minors(algebra, whole);
    } catch (const UndecidedEntry&) {}
    return {};
}

}  // namespace

std::optional<std::size_t> fibre_rank(const Hamiltonian& hamiltonian) {
    return rank_of(hamiltonian.rotations.empty() ? Algebra(hamiltonian)
                                                 : Algebra::with_entries(hamiltonian),
                   hamiltonian.degrees_of_freedom());
}

std::optional<std::size_t> fibre_rank(const Lagrangian& lagrangian) {
    return rank_of(Algebra(lagrangian), lagrangian.degrees_of_freedom());
}

void check_fibre_rank(const Hamiltonian& hamiltonian, const std::optional<Place>& place) {
    std::optional<std::size_t> rank;
    try {
        rank = fibre_rank(hamiltonian);
    } catch (const InputError&) {
    } catch (const MathError&) {}  // beyond exact algebra
    const std::size_t n = hamiltonian.degrees_of_freedom();
    if (rank.value_or(n) == n) return;
    throw MathError("with more nodes than functions (4.6e) determines p at the nodes only where "
                    "d2H/dp2 is regular, and its rank is " +
                        std::to_string(*rank) + " of " + std::to_string(n),
                    place, "take as many nodes as functions");
}

}  // namespace hvi::gen

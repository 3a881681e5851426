// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/fibre_rank.hpp"

#include <vector>

#include "generator/hamiltonian/relations.hpp"
#include "generator/hamiltonian/vanishing.hpp"

namespace hvi::gen {

namespace {

using GiNaC::ex;

/// By the last n variables.
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

/// The equations of the constant vectors that the matrix takes to zero: a row of it has one for
/// each monomial. Nothing where an entry is too long.
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

std::optional<std::size_t> rank_of(const Algebra& algebra, std::size_t degrees_of_freedom) {
    const GiNaC::matrix whole = fibre_hessian(algebra, static_cast<unsigned>(degrees_of_freedom));
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

}  // namespace hvi::gen

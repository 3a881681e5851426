// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/elimination.hpp"

#include <utility>

#include "generator/hamiltonian/normal_form.hpp"
#include "generator/hamiltonian/vanishing.hpp"

namespace hvi::gen {

namespace {

using GiNaC::ex;

/// Writes a sum as a product of a number, powers of symbols, and the rest. NOTE: GiNaC::factor
/// works for polynomials of symbols only.
ex without_common_factors(const ex& sum, const Algebra& algebra) {
    ex rest = sum.expand();
    if (!GiNaC::is_a<GiNaC::add>(rest)) return rest;
    ex common = rest.integer_content();
    rest = (rest / common).expand();
    for (const auto* symbols : {&algebra.parameters(), &algebra.variables()}) {
        for (const GiNaC::symbol& symbol : *symbols) {
            const ex factor = GiNaC::pow(symbol, rest.ldegree(symbol));
            common *= factor;
            rest = (rest / factor).expand();
        }
    }
    return common * rest;
}

/// Writes an expression as a fraction of expanded polynomials, which does not depend on GiNaC's
/// order of terms.
ex as_fraction(const ex& expression, const Algebra& algebra) {
    const ex both = expression.numer_denom();
    return without_common_factors(both.op(0), algebra) /
           without_common_factors(both.op(1), algebra);
}

/// Replaces even powers of sines by sin^2 = 1 - cos^2 and sinh^2 = cosh^2 - 1.
ex without_squares_of_sines(const ex& polynomial) {
    const ex x = GiNaC::wild();
    const GiNaC::lst squares{GiNaC::pow(GiNaC::sin(x), 2) == 1 - GiNaC::pow(GiNaC::cos(x), 2),
                             GiNaC::pow(GiNaC::sinh(x), 2) == GiNaC::pow(GiNaC::cosh(x), 2) - 1};
    return polynomial.expand().subs(squares, GiNaC::subs_options::algebraic).expand();
}

/// Returns the shorter of the entry and the entry without squares of sines.
ex shortest(const ex& entry, const Algebra& algebra) {
    const ex both = entry.numer_denom();
    const ex other =
        normal_form(without_squares_of_sines(both.op(0)) / without_squares_of_sines(both.op(1)));
    const ex plain = as_fraction(entry, algebra), reduced = as_fraction(other, algebra);
    const auto words = [&](const ex& e) { return word_count(algebra.written(e)); };
    return words(reduced) < words(plain) ? reduced : plain;
}

/// The rows of elimination: a matrix beside the unit matrix, which become the unit matrix beside
/// the inverse.
class Rows {
public:
    Rows(const Algebra& algebra, const GiNaC::matrix& matrix)
        : algebra_(algebra), n_(matrix.rows()), rows_(n_, GiNaC::exvector(2 * n_)) {
        for (unsigned i = 0; i < n_; ++i) {
            for (unsigned j = 0; j < n_; ++j) rows_[i][j] = matrix(i, j);
            rows_[i][n_ + i] = 1;
        }
    }

    [[nodiscard]] Elimination eliminated() {
        Elimination result;
        for (unsigned column = 0; column < n_; ++column)
            if (find_pivot(result.rank, column)) clear(result.rank++, column);
        if (result.rank == n_) result.inverse = right_half();
        return result;
    }

private:
    /// Brings a row with an entry in the column that does not vanish to the place of `row`.
    [[nodiscard]] bool find_pivot(std::size_t row, unsigned column) {
        bool is_sure = true;
        for (std::size_t i = row; i < n_; ++i) {
            const Vanishing entry = vanishing(algebra_, rows_[i][column]);
            if (entry == Vanishing::refuted) {
                std::swap(rows_[row], rows_[i]);
                return true;
            }
            is_sure = is_sure && entry == Vanishing::proved;
        }
        if (!is_sure)
            throw MathError("it is not known whether the Legendre transformation is regular here",
                            algebra_.place(), "write the function in a simpler form");
        return false;
    }

    void clear(std::size_t row, unsigned column) {
        const ex pivot = rows_[row][column];
        for (ex& entry : rows_[row]) entry = normal_form(entry / pivot);
        for (std::size_t i = 0; i < n_; ++i) {
            const ex factor = rows_[i][column];
            if (i == row || factor.is_zero()) continue;
            for (unsigned j = 0; j < 2 * n_; ++j)
                rows_[i][j] = normal_form(rows_[i][j] - factor * rows_[row][j]);
        }
    }

    [[nodiscard]] GiNaC::matrix right_half() const {
        GiNaC::matrix result(n_, n_);
        for (unsigned i = 0; i < n_; ++i)
            for (unsigned j = 0; j < n_; ++j) result(i, j) = shortest(rows_[i][n_ + j], algebra_);
        return result;
    }

    const Algebra& algebra_;
    unsigned n_;
    std::vector<GiNaC::exvector> rows_;
};

}  // namespace

Elimination eliminate(const Algebra& algebra, const GiNaC::matrix& matrix) {
    return Rows(algebra, matrix).eliminated();
}

}  // namespace hvi::gen

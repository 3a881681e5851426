// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/algebra/rational_matrix.hpp"

#include <flint/fmpz_poly_mat.h>

#include "generator/exact/numbers/rational.hpp"

namespace hvi::gen {

RationalMatrix operator*(const RationalMatrix& left, const RationalMatrix& right) {
    RationalMatrix result(static_cast<std::size_t>(fmpq_mat_nrows(left.get())),
                          static_cast<std::size_t>(fmpq_mat_ncols(right.get())));
    fmpq_mat_mul(result.get(), left.get(), right.get());
    return result;
}

RationalMatrix operator-(const RationalMatrix& left, const RationalMatrix& right) {
    RationalMatrix result(static_cast<std::size_t>(fmpq_mat_nrows(left.get())),
                          static_cast<std::size_t>(fmpq_mat_ncols(left.get())));
    fmpq_mat_sub(result.get(), left.get(), right.get());
    return result;
}

bool operator==(const RationalMatrix& left, const RationalMatrix& right) {
    return fmpq_mat_equal(left.get(), right.get()) != 0;
}

RationalMatrix transpose(const RationalMatrix& matrix) {
    RationalMatrix result(static_cast<std::size_t>(fmpq_mat_ncols(matrix.get())),
                          static_cast<std::size_t>(fmpq_mat_nrows(matrix.get())));
    fmpq_mat_transpose(result.get(), matrix.get());
    return result;
}

RationalMatrix coefficient_rows(const std::vector<RationalPolynomial>& polynomials,
                                std::size_t width) {
    RationalMatrix result(polynomials.size(), width);
    for (std::size_t k = 0; k < polynomials.size(); ++k) {
        for (long m = 0; m <= polynomials[k].degree(); ++m) {
            fmpq_poly_get_coeff_fmpq(result.entry(k, static_cast<std::size_t>(m)),
                                     polynomials[k].get(), m);
        }
    }
    return result;
}

RationalPolynomial polynomial(const RationalMatrix& row) {
    RationalPolynomial result;
    for (slong m = 0; m < fmpq_mat_ncols(row.get()); ++m) {
        fmpq_poly_set_coeff_fmpq(result.get(), m, fmpq_mat_entry(row.get(), 0, m));
    }
    return result;
}

std::optional<RationalMatrix> rational_matrix(const NumberMatrix& rows) {
    RationalMatrix result(rows.size(), rows.front().size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t j = 0; j < rows[i].size(); ++j) {
            const auto text = rational_text(rows[i][j]);
            if (!text) { return std::nullopt; }
            fmpq_set_str(result.entry(i, j), text->c_str(), 10);
        }
    }
    return result;
}

RationalPolynomial determinant_of_pencil(const RationalMatrix& X, const RationalMatrix& Y) {
    const slong s = fmpq_mat_nrows(X.get());
    fmpz_mat_t x, y;
    fmpz_mat_init(x, s, s);
    fmpz_mat_init(y, s, s);
    fmpz* const denominators = _fmpz_vec_init(s);
    fmpq_mat_get_fmpz_mat_rowwise_2(x, y, denominators, X.get(), Y.get());
    fmpz_poly_mat_t pencil;
    fmpz_poly_mat_init(pencil, s, s);
    for (slong i = 0; i < s; ++i) {
        for (slong j = 0; j < s; ++j) {
            fmpz_poly_struct* const entry = fmpz_poly_mat_entry(pencil, i, j);
            fmpz_poly_set_coeff_fmpz(entry, 0, fmpz_mat_entry(x, i, j));
            fmpz_poly_set_coeff_fmpz(entry, 1, fmpz_mat_entry(y, i, j));
        }
    }
    fmpz_poly_t integral;
    fmpz_poly_init(integral);
    fmpz_poly_mat_det(integral, pencil);
    RationalPolynomial result;
    fmpq_poly_set_fmpz_poly(result.get(), integral);
    for (slong i = 0; i < s; ++i) {
        fmpq_poly_scalar_div_fmpz(result.get(), result.get(), denominators + i);
    }
    fmpz_poly_clear(integral);
    fmpz_poly_mat_clear(pencil);
    _fmpz_vec_clear(denominators, s);
    fmpz_mat_clear(y);
    fmpz_mat_clear(x);
    return result;
}

}  // namespace hvi::gen

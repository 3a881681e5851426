// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/projected_stages.hpp"

#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

/// Returns the matrix with a single 1.
RationalMatrix unit(std::size_t size, std::size_t row, std::size_t column) {
    RationalMatrix result(size, size);
    fmpq_one(result.entry(row, column));
    return result;
}

RationalMatrix inverse(const RationalMatrix& matrix) {
    RationalMatrix result = transpose(matrix);  // symmetric
    HVI_CHECK(fmpq_mat_inv(result.get(), matrix.get()) != 0);
    return result;
}

RationalPolynomial times(const RationalPolynomial& g, long factor) {
    RationalPolynomial result;
    fmpq_poly_scalar_mul_si(result.get(), g.get(), factor);
    return result;
}

}  // namespace

/// Factors of the matrices. Rows are the coefficients of polynomials modulo P.
struct ProjectedStages::Factors {
    explicit Factors(const RationalRule& rule)
        : size(static_cast<std::size_t>(rule.P.degree())),
          H(moments(rule.P, size)),
          psi(rows(rule, false)),
          A_psi(rows(rule, true)),
          inverse_G(inverse(psi * H * transpose(psi))),
          W(inverse_G * A_psi) {}

    std::size_t size;
    RationalMatrix H;      ///< Gram matrix of <., .>
    RationalMatrix psi;    ///< the basis
    RationalMatrix A_psi;  ///< its integrals from 0 on
    RationalMatrix inverse_G;
    RationalMatrix W;  ///< G^-1 A_psi

private:
    [[nodiscard]] RationalMatrix rows(const RationalRule& rule, bool integrated) const {
        std::vector<RationalPolynomial> result;
        for (const RationalPolynomial& psi_k : rule.psi) {
            result.push_back(remainder(integrated ? antiderivative(psi_k) : psi_k, rule.P));
        }
        return coefficient_rows(result, size);
    }
};

ProjectedStages::ProjectedStages(const RationalRule& rule)
    : ProjectedStages(rule.P, Factors(rule)) {}

/// Sets A = A_psi G^-1 Psi diag(b), A~ = (1 1^T - Psi^T G^-1 A_psi^T) diag(b), the projection Psi^T
/// G^-1 Psi diag(b) and n = x - A_psi G^-1 A_psi^T, as they act on polynomials.
ProjectedStages::ProjectedStages(const RationalPolynomial& P, const Factors& factors)
    : P_(P),
      A_(factors.H * transpose(factors.psi) * factors.W),
      A_tilde_(factors.H * (unit(factors.size, 0, 0) - transpose(factors.W) * factors.psi)),
      projection_(factors.H * transpose(factors.psi) * factors.inverse_G * factors.psi),
      n_(unit(factors.size, 1, 0) - transpose(factors.A_psi) * factors.W) {}

RationalPolynomial ProjectedStages::product(const Function& g, const Function& h) const {
    return remainder(g * h, P_);
}

RationalPolynomial ProjectedStages::defect(Colour, const Function& g, long factor) const {
    RationalPolynomial sum;
    sum.set_coefficient(0, g.integral_over_unit_interval());
    return times(sum, factor) - RationalPolynomial(1);
}

RationalPolynomial ProjectedStages::apply(Colour colour, const Function& g, long factor) const {
    return times(applied(colour == Colour::f ? A_ : A_tilde_, g), factor);
}

RationalPolynomial ProjectedStages::projected(const Function& g) const {
    return applied(projection_, g);
}

RationalPolynomial ProjectedStages::applied(const RationalMatrix& matrix, const Function& g) const {
    return polynomial(coefficient_rows({g}, static_cast<std::size_t>(count())) * matrix);
}

}  // namespace hvi::gen

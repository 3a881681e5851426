// Algorithm 4.3 with free parameters: in the coordinates of its basis, without a division.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <utility>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/algebra/polynomial_arithmetic.hpp"
#include "generator/exact/methods/even_map.hpp"
#include "generator/exact/numbers/minors.hpp"

namespace hvi::gen {

namespace {

/// A ring of NumberPolynomials.
struct PolynomialEntry {
    NumberPolynomial polynomial;

    PolynomialEntry() = default;
    explicit PolynomialEntry(long constant) : polynomial{Number(constant)} {}
    explicit PolynomialEntry(NumberPolynomial value) : polynomial(std::move(value)) {}

    friend PolynomialEntry operator+(const PolynomialEntry& a, const PolynomialEntry& b) {
        return PolynomialEntry(sum(a.polynomial, b.polynomial));
    }
    friend PolynomialEntry operator-(const PolynomialEntry& a, const PolynomialEntry& b) {
        return PolynomialEntry(sum(a.polynomial, scaled(b.polynomial, Number(-1))));
    }
    friend PolynomialEntry operator*(const PolynomialEntry& a, const PolynomialEntry& b) {
        return PolynomialEntry(product(a.polynomial, b.polynomial));
    }
};

/// Values of the rule sum_i b_i f(c_i) for products of psi_1 .. psi_s and of their integrals Psi_1
/// .. Psi_s from 0 on. By Algorithm 4.3 the functions with coordinates x on the psi have
///
///     b.x = B.x,    <x, y> = x^T G y,    A x = sum_j x_j Psi_j at the nodes,
///     <A~ x, y> = (b.x)(b.y) - <x, A y>,
///
/// so that G (1 + t A~ A) = G + t (B m^T - N), where m_j = b.Psi_j and N_ij = <Psi_i, Psi_j>.
struct RuleOfProducts {
    NumberVector B;    ///< b.psi_i
    NumberVector m;    ///< b.Psi_i
    NumberMatrix G;    ///< <psi_i, psi_j>
    NumberMatrix BmN;  ///< B m^T - N
};

RuleOfProducts rule_of(const Galerkin& galerkin, const NumberVector& b) {
    const NumberMatrix& psi = galerkin.M;
    const NumberMatrix Psi = transpose(galerkin.A_psi);
    const auto weighted = [&](NumberMatrix functions) {
        for (NumberVector& row : functions) {
            for (std::size_t k = 0; k < row.size(); ++k) { row[k] = row[k] * b[k]; }
        }
        return transpose(functions);
    };
    RuleOfProducts rule{galerkin.B, Psi * b, psi * weighted(psi), {}};
    const NumberMatrix N = Psi * weighted(Psi);
    for (std::size_t i = 0; i < b.size(); ++i) {
        NumberVector& row = rule.BmN.emplace_back();
        for (std::size_t j = 0; j < b.size(); ++j) {
            row.push_back(rule.B[i] * rule.m[j] - N[i][j]);
        }
    }
    return rule;
}

/// Returns x^T adjugate y.
NumberPolynomial form(const NumberVector& x, const SquareMatrix<PolynomialEntry>& adjugate,
                      const NumberVector& y) {
    NumberPolynomial result;
    for (std::size_t i = 0; i < x.size(); ++i) {
        for (std::size_t j = 0; j < y.size(); ++j) {
            result = sum(result, scaled(adjugate[i][j].polynomial, x[i] * y[j]));
        }
    }
    return result;
}

}  // namespace

std::size_t term_count_in_basis(const Galerkin& galerkin, const NumberVector& b) {
    const RuleOfProducts rule = rule_of(galerkin, b);
    return term_count(rule.G) + term_count(rule.BmN);
}

// The stages are P = (1 + t A~ A)^-1 (p 1 - z omega q c~), as in by_stages, where G 1 = B and G c~
// = B - m.
EvenMap even_map_in_basis(const Galerkin& galerkin, const NumberVector& b) {
    const std::size_t s = b.size();
    const RuleOfProducts rule = rule_of(galerkin, b);
    NumberMatrix all = beside(rule.G, rule.BmN);
    all.push_back(rule.B);
    all.push_back(rule.m);
    const Number scale = common_denominator(all);
    SquareMatrix<PolynomialEntry> pencil(s);
    for (std::size_t i = 0; i < s; ++i) {
        for (std::size_t j = 0; j < s; ++j) {
            pencil[i].emplace_back(NumberPolynomial{rule.G[i][j] * scale, rule.BmN[i][j] * scale});
        }
    }
    const auto [adjugate, determinant] = by_minors(pencil);
    const NumberPolynomial& D = determinant.polynomial;
    const NumberVector scaled_B = rule.B * scale;
    NumberVector rest;
    for (std::size_t i = 0; i < s; ++i) { rest.push_back((rule.B[i] - rule.m[i]) * scale); }
    const Number minus(-1);
    return {sum(D, scaled(shifted(form(rule.B, adjugate, rest)), minus)),
            form(rule.B, adjugate, scaled_B),
            sum(shifted(form(rule.m, adjugate, rest)), scaled(D, minus)),
            sum(D, scaled(shifted(form(rule.m, adjugate, scaled_B)), minus)), D};
}

}  // namespace hvi::gen

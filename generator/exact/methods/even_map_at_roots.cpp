// Galerkin's form at all roots of P, over Q.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "generator/exact/algebra/rational_matrix.hpp"
#include "generator/exact/methods/even_map.hpp"

namespace hvi::gen {

namespace {

/// Functions g, their integrals over [0, tau] and those over [tau, 1]: rows of coefficients.
struct Functions {
    explicit Functions(const std::vector<RationalPolynomial>& functions)
        : width(width_of(functions)),
          g(coefficient_rows(functions, width)),
          from_zero(each(functions, [](const auto& integral) { return integral; })),
          to_one(each(functions,
                      [](const auto& integral) { return integral.at_affine(0, 1) - integral; })) {}

    std::size_t width;
    RationalMatrix g, from_zero, to_one;

private:
    /// Returns the width of rows with room for the integrals.
    static std::size_t width_of(const std::vector<RationalPolynomial>& functions) {
        long degree = 0;
        for (const RationalPolynomial& function : functions) {
            degree = std::max(degree, function.degree());
        }
        return static_cast<std::size_t>(degree) + 2;
    }

    [[nodiscard]] RationalMatrix each(const std::vector<RationalPolynomial>& functions,
                                      auto of_integral) const {
        std::vector<RationalPolynomial> result;
        for (const RationalPolynomial& function : functions) {
            result.push_back(of_integral(antiderivative(function)));
        }
        return coefficient_rows(result, width);
    }
};

/// Returns the polynomials of lower degree than P. NOTE: for Legendre's polynomials G below is
/// nearly diagonal and S nearly tridiagonal, with short entries.
RationalRule all_below(const RationalPolynomial& P) {
    RationalRule rule{P, {}};
    for (long k = 0; k < P.degree(); ++k) {
        rule.psi.push_back(legendre(static_cast<unsigned>(k)).at_affine(2, -1));
    }
    return rule;
}

}  // namespace

/// Returns the map. V = z P is given by a function v of the span, omega Q by the values of q =
/// omega q0 + int_0^tau v, and b_i P_i g(c_i) summed over i gives for every g of the basis
///
///     b(v g) + z^2 b(int_0^tau v int_tau^1 g) = z p0 b(g) - z^2 omega q0 b(int_tau^1 g).
///
/// This is, for v = sum_k v_k g_k, (G + t S)^T v = z p0 beta - t omega q0 gamma; then omega q1 =
/// omega q0 + beta v and p1 = p0 - z omega q0 - z eta v. Every entry is a determinant, by det(K + u
/// v^T) = det(K) (1 + v K^-1 u).
EvenMap even_map(const RationalRule& rule) {
    const std::size_t s = rule.psi.size();
    const Functions basis(rule.psi);
    const RationalMatrix H = moments(rule.P, basis.width);
    const RationalMatrix to_one = transpose(basis.to_one);
    RationalMatrix e(basis.width, 1);  // the function 1
    fmpq_one(e.entry(0, 0));
    const RationalMatrix G = basis.g * H * transpose(basis.g);
    const RationalMatrix S = basis.from_zero * H * to_one;
    const RationalMatrix beta = basis.g * H * e;
    const RationalMatrix gamma = basis.to_one * H * e;
    const RationalMatrix eta = basis.from_zero * H * e;
    const auto updated = [&](bool plus, const RationalMatrix& u, const RationalMatrix& v) {
        const RationalMatrix product = u * transpose(v);
        RationalMatrix Y(s, s);
        (plus ? fmpq_mat_add : fmpq_mat_sub)(Y.get(), S.get(), product.get());
        return determinant_of_pencil(G, Y);
    };
    const RationalPolynomial D = determinant_of_pencil(G, S);
    const RationalPolynomial t_m12 = updated(true, beta, beta) - D;
    RationalPolynomial m12;
    fmpq_poly_shift_right(m12.get(), t_m12.get(), 1);
    return {numbers(updated(false, beta, gamma)), numbers(m12),
            numbers(RationalPolynomial() - updated(false, eta, gamma)),
            numbers(updated(false, eta, beta)), numbers(D)};
}

EvenMap even_map(const RationalPolynomial& P) { return even_map(all_below(P)); }

}  // namespace hvi::gen

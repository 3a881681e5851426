// Polynomials at all roots of P, over Q.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "generator/exact/algebra/rational_matrix.hpp"
#include "generator/exact/methods/even_map.hpp"

namespace hvi::gen {

namespace {

/// H[m][n] = b(tau^(m+n)) for m, n = 0 .. s, where b(g) is the rule: the integral of g mod P.
RationalMatrix moments(const RationalPolynomial& P) {
    const auto s = static_cast<std::size_t>(P.degree());
    RationalMatrix H(s + 1, s + 1);
    RationalPolynomial power(1);
    for (std::size_t k = 0; k <= 2 * s; ++k) {
        fmpq_poly_rem(power.get(), power.get(), P.get());
        fmpq_t moment;
        fmpq_init(moment);
        fmpq_set_str(moment, power.integral_over_unit_interval().c_str(), 10);
        for (std::size_t m = k > s ? k - s : 0; m <= std::min(k, s); ++m) {
            fmpq_set(H.entry(m, k - m), moment);
        }
        fmpq_clear(moment);
        power = power * RationalPolynomial::variable();
    }
    return H;
}

/// A basis g_0 .. g_(s-1) of the polynomials of degree less than s, and its integrals over [0, tau]
/// and [tau, 1]: rows of coefficients. NOTE: for Legendre's polynomials G below is nearly diagonal
/// and S nearly tridiagonal, with short entries.
struct LegendreBasis {
    explicit LegendreBasis(std::size_t s) : g(s, s + 1), from_zero(s, s + 1), to_one(s, s + 1) {
        for (std::size_t k = 0; k < s; ++k) {
            const RationalPolynomial polynomial =
                legendre(static_cast<unsigned>(k)).at_affine(2, -1);
            RationalPolynomial integral;
            fmpq_poly_integral(integral.get(), polynomial.get());
            set_row(g, k, polynomial);
            set_row(from_zero, k, integral);
            set_row(to_one, k, integral.at_affine(0, 1) - integral);
        }
    }

    RationalMatrix g, from_zero, to_one;

private:
    static void set_row(RationalMatrix& matrix, std::size_t row,
                        const RationalPolynomial& polynomial) {
        for (long m = 0; m <= polynomial.degree(); ++m) {
            fmpq_poly_get_coeff_fmpq(matrix.entry(row, static_cast<std::size_t>(m)),
                                     polynomial.get(), m);
        }
    }
};

}  // namespace

/// In Galerkin's form: with V = z P, a polynomial v of degree less than s, omega Q is the values of
/// q = omega q0 + int_0^tau v, and b_i P_i g(c_i) summed over i gives for every g of the basis
///
///     b(v g) + z^2 b(int_0^tau v int_tau^1 g) = z p0 b(g) - z^2 omega q0 b(int_tau^1 g).
///
/// With v = sum_k v_k g_k this is (G + t S)^T v = z p0 beta - t omega q0 gamma; then
/// omega q1 = omega q0 + beta v and p1 = p0 - z omega q0 - z eta v. Every entry is a determinant,
/// by det(K + u v^T) = det(K) (1 + v K^-1 u).
EvenMap even_map(const RationalPolynomial& P) {
    const auto s = static_cast<std::size_t>(P.degree());
    const RationalMatrix H = moments(P);
    const LegendreBasis basis(s);
    const RationalMatrix to_one = transpose(basis.to_one);
    RationalMatrix e(s + 1, 1);  // the function 1
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

}  // namespace hvi::gen

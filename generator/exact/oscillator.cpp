// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/oscillator.hpp"

#include <flint/fmpz_poly_mat.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "generator/exact/matrix.hpp"
#include "generator/exact/number_value.hpp"
#include "generator/exact/polynomial_arithmetic.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/rational_matrix.hpp"
#include "generator/exact/resolvent.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

/// The map by polynomials in t = z^2: m12 and m21 without a factor z.
struct EvenMap {
    NumberPolynomial m11, m12, m21, m22, D;
};

// ---- any numbers ----

Number dot(const NumberVector& left, const NumberVector& right) {
    return (NumberMatrix{left} * right).front();
}

/// t P(t)
NumberPolynomial shifted(NumberPolynomial polynomial) {
    polynomial.insert(polynomial.begin(), Number(0));
    return polynomial;
}

/// Whether exact arithmetic with products of the coefficients would take minutes.
bool are_too_long(const PartitionedMethod& method) {
    constexpr std::size_t most_terms = 2000;
    std::size_t count = 0;
    for (const NumberMatrix* matrix : {&method.A, &method.A_tilde}) {
        for (const NumberVector& row : *matrix) {
            for (const Number& entry : row) {
                if (entry.has_parameters()) { return false; }
                count += term_count(entry);
            }
        }
    }
    return count > most_terms;
}

/// The stages are P = (I + t A~ A)^-1 (p 1 - z omega q c~) and omega Q = omega q 1 + z A P, the
/// step is omega q1 = omega q + z b P, p1 = p - z b~ omega Q.
EvenMap by_stages(const PartitionedMethod& method, PolynomialArithmetic& arithmetic) {
    const bool too_long = are_too_long(method);
    const NumberMatrix A = too_long ? without_closed_form(method.A) : method.A;
    const NumberMatrix A_tilde = too_long ? without_closed_form(method.A_tilde) : method.A_tilde;
    const NumberVector& b = method.b;
    const NumberVector& b_tilde = method.b_tilde;
    const NumberVector ones(method.stages(), Number(1));
    const NumberVector bA = transpose(A) * b_tilde;
    const NumberVector c_tilde = A_tilde * ones;
    const Resolvent P =
        resolvent(A_tilde * A, transpose({c_tilde, ones}), std::numeric_limits<std::size_t>::max());
    const NumberPolynomial& D = P.determinant;
    const auto form = [&](const NumberVector& u, std::size_t column) {
        NumberPolynomial result;
        for (const NumberMatrix& numerator : P.numerator) {
            result.push_back(dot(u, transpose(numerator)[column]));
        }
        return result;
    };
    const Number minus(-1);
    return {arithmetic.sum(D, minus, shifted(form(b, 0))), arithmetic.trimmed(form(b, 1)),
            arithmetic.sum(shifted(form(bA, 0)), -dot(b_tilde, ones), D),
            arithmetic.sum(D, minus, shifted(form(bA, 1))), arithmetic.trimmed(D)};
}

// ---- polynomials at all roots of P, over Q ----

RationalMatrix operator*(const RationalMatrix& left, const RationalMatrix& right) {
    RationalMatrix result(static_cast<std::size_t>(fmpq_mat_nrows(left.get())),
                          static_cast<std::size_t>(fmpq_mat_ncols(right.get())));
    fmpq_mat_mul(result.get(), left.get(), right.get());
    return result;
}

RationalMatrix transpose(const RationalMatrix& matrix) {
    RationalMatrix result(static_cast<std::size_t>(fmpq_mat_ncols(matrix.get())),
                          static_cast<std::size_t>(fmpq_mat_nrows(matrix.get())));
    fmpq_mat_transpose(result.get(), matrix.get());
    return result;
}

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
struct Basis {
    explicit Basis(std::size_t s) : g(s, s + 1), from_zero(s, s + 1), to_one(s, s + 1) {
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

/// det(X + t Y)
RationalPolynomial determinant(const RationalMatrix& X, const RationalMatrix& Y) {
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

/// In Galerkin's form: with V = z P, a polynomial v of degree less than s, omega Q is the values of
/// q = omega q0 + int_0^tau v, and b_i P_i g(c_i) summed over i gives for every g of the basis
///
///     b(v g) + z^2 b(int_0^tau v int_tau^1 g) = z p0 b(g) - z^2 omega q0 b(int_tau^1 g).
///
/// With v = sum_k v_k g_k this is (G + t S)^T v = z p0 beta - t omega q0 gamma; then
/// omega q1 = omega q0 + beta v and p1 = p0 - z omega q0 - z eta v. Every entry is a determinant,
/// by det(K + u v^T) = det(K) (1 + v K^-1 u).
EvenMap by_polynomials(const RationalPolynomial& P) {
    const auto s = static_cast<std::size_t>(P.degree());
    const RationalMatrix H = moments(P);
    const Basis basis(s);
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
        return determinant(G, Y);
    };
    const RationalPolynomial D = determinant(G, S);
    const RationalPolynomial t_m12 = updated(true, beta, beta) - D;
    RationalPolynomial m12;
    fmpq_poly_shift_right(m12.get(), t_m12.get(), 1);
    return {numbers(updated(false, beta, gamma)), numbers(m12),
            numbers(RationalPolynomial() - updated(false, eta, gamma)),
            numbers(updated(false, eta, beta)), numbers(D)};
}

// ---- any coefficients, over Q ----

/// The rows of numbers as a matrix, if all of them are rational.
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

/// t P(t)
RationalPolynomial shifted(const RationalPolynomial& polynomial) {
    return polynomial * RationalPolynomial::variable();
}

/// As by_stages, with u (I + t B)^-1 v det(I + t B) = det(I + t B + v u^T) - det(I + t B). Empty
/// where a coefficient is not rational.
std::optional<EvenMap> by_determinants(const PartitionedMethod& method) {
    const auto A = rational_matrix(method.A);
    const auto A_tilde = rational_matrix(method.A_tilde);
    const auto b = rational_matrix({method.b});
    const auto b_tilde = rational_matrix({method.b_tilde});
    if (!A || !A_tilde || !b || !b_tilde) { return std::nullopt; }
    const std::size_t s = method.stages();
    RationalMatrix one(s, s), ones(s, 1);
    fmpq_mat_one(one.get());
    for (std::size_t i = 0; i < s; ++i) { fmpq_one(ones.entry(i, 0)); }
    const RationalMatrix B = *A_tilde * *A;
    const RationalMatrix c_tilde = *A_tilde * ones;
    const RationalMatrix bA = *b_tilde * *A;
    const RationalPolynomial D = determinant(one, B);
    const auto form = [&](const RationalMatrix& u, const RationalMatrix& v) {
        RationalMatrix X = v * u;
        fmpq_mat_add(X.get(), X.get(), one.get());
        return determinant(X, B) - D;
    };
    RationalPolynomial sum;
    RationalMatrix weights = *b_tilde * ones;
    fmpq_poly_scalar_mul_fmpq(sum.get(), D.get(), weights.entry(0, 0));
    return EvenMap{numbers(D - shifted(form(*b, c_tilde))), numbers(form(*b, ones)),
                   numbers(shifted(form(bA, c_tilde)) - sum), numbers(D - shifted(form(bA, ones))),
                   numbers(D)};
}

// ---- lowest terms ----

bool has_parameters(const EvenMap& map) {
    for (const NumberPolynomial* entry : {&map.m11, &map.m12, &map.m21, &map.m22, &map.D}) {
        for (const Number& coefficient : *entry) {
            if (coefficient.has_parameters()) { return true; }
        }
    }
    return false;
}

/// Both divided by their common divisor, and by the denominator's value at 0.
PolynomialQuotient reduced(const NumberPolynomial& numerator, const NumberPolynomial& denominator,
                           PolynomialArithmetic& arithmetic) {
    const NumberPolynomial above = arithmetic.without(numerator, denominator);
    const NumberPolynomial below = arithmetic.without(denominator, numerator);
    const Number scale = Number(1) / below.front();
    return {above * scale, below * scale};
}

void divide_by_common(EvenMap& map, PolynomialArithmetic& arithmetic) {
    NumberPolynomial common = map.D;
    for (const NumberPolynomial* entry : {&map.m11, &map.m22, &map.m12, &map.m21}) {
        if (common.size() > 1) { common = arithmetic.gcd(common, *entry); }
    }
    for (NumberPolynomial* entry : {&map.m11, &map.m12, &map.m21, &map.m22, &map.D}) {
        if (common.size() > 1) { *entry = arithmetic.divide(*entry, common).quotient; }
    }
}

void make_D_one_at_zero(EvenMap& map) {
    const Number scale = Number(1) / map.D.front();
    if (is_exactly(scale, 1)) { return; }
    for (NumberPolynomial* entry : {&map.m11, &map.m12, &map.m21, &map.m22, &map.D}) {
        *entry = *entry * scale;
    }
}

/// z^shift P(z^2)
NumberPolynomial in_z(const NumberPolynomial& polynomial, std::size_t shift) {
    NumberPolynomial result;
    for (std::size_t k = 0; k < polynomial.size(); ++k) {
        result.resize(2 * k + shift);
        result.push_back(polynomial[k]);
    }
    return result;
}

/// Whether m11 m22 - t m12 m21 = D^2.
Verdict has_determinant_one(const EvenMap& map, PolynomialArithmetic& arithmetic) {
    const NumberPolynomial diagonal = product(map.m11, map.m22);
    const NumberPolynomial other = shifted(product(map.m12, map.m21));
    const NumberPolynomial square = product(map.D, map.D);
    const auto coefficient = [](const NumberPolynomial& polynomial, std::size_t k) {
        return k < polynomial.size() ? polynomial[k] : Number(0);
    };
    Verdict verdict;
    for (std::size_t k = 0; k < std::max({diagonal.size(), other.size(), square.size()}); ++k) {
        const Number difference =
            coefficient(diagonal, k) - coefficient(other, k) - coefficient(square, k);
        const bool holds = arithmetic.is_zero(difference);
        verdict = verdict && Verdict{holds, !holds || is_exact(difference)};
        if (!holds) { break; }
    }
    return verdict;
}

OscillatorMap completed(EvenMap map, PolynomialArithmetic arithmetic) {
    const bool parameters = has_parameters(map);
    if (!parameters) { divide_by_common(map, arithmetic); }
    make_D_one_at_zero(map);
    const NumberPolynomial trace = arithmetic.sum(map.m11, Number(1), map.m22);
    const NumberPolynomial half = trace * (Number(1) / Number(2));
    const PolynomialQuotient half_trace =
        parameters ? PolynomialQuotient{half, map.D} : reduced(half, map.D, arithmetic);
    const bool proved = arithmetic.proved();
    return {in_z(map.m11, 0),
            in_z(map.m12, 1),
            in_z(map.m21, 1),
            in_z(map.m22, 0),
            in_z(map.D, 0),
            {in_z(half_trace.numerator, 0), in_z(half_trace.denominator, 0)},
            has_determinant_one(map, arithmetic),
            proved};
}

}  // namespace

OscillatorMap oscillator_map(const Tableau& tableau) {
    if (!tableau.node_polynomial) { return oscillator_map(partitioned_method(tableau)); }
    const Progress::Stage stage("computing the map of the harmonic oscillator");
    return completed(by_polynomials(*tableau.node_polynomial), {});
}

OscillatorMap oscillator_map(const PartitionedMethod& method) {
    const Progress::Stage stage("computing the map of the harmonic oscillator");
    if (auto map = by_determinants(method)) { return completed(*std::move(map), {}); }
    PolynomialArithmetic arithmetic;
    EvenMap map = by_stages(method, arithmetic);
    return completed(std::move(map), arithmetic);
}

bool takes_long(const PartitionedMethod& method) {
    constexpr std::size_t most_characters = 8000;     // of rational numbers
    constexpr std::size_t most_enclosed_stages = 32;  // where s^4 numbers are kept
    std::size_t characters = 0;
    bool rational = true;
    for (const NumberMatrix* matrix : {&method.A, &method.A_tilde}) {
        for (const NumberVector& row : *matrix) {
            for (const Number& entry : row) {
                const auto text = rational_text(entry);
                rational = rational && text;
                characters += text ? text->size() : 0;
            }
        }
    }
    return characters > most_characters || (!rational && method.stages() > most_enclosed_stages);
}

// ---- what is read and drawn ----

namespace {

/// Highest power first. Empty where a coefficient has no closed form.
std::optional<Expression> closed_form(const NumberPolynomial& polynomial) {
    std::vector<Expression> terms;
    for (std::size_t k = polynomial.size(); k-- > 0;) {
        if (is_exactly(polynomial[k], 0)) { continue; }
        const auto coefficient = polynomial[k].closed_form();
        if (!coefficient) { return std::nullopt; }
        const bool negative = coefficient->kind == Expression::Kind::negation;
        const Expression& size = negative ? coefficient->arguments.front() : *coefficient;
        std::vector<Expression> factors;
        if (k == 0 || to_text(size) != "1") { factors.push_back(size); }
        if (k > 0) {
            const Expression z = Expression::symbol("z");
            factors.push_back(
                k == 1 ? z : Expression::power(z, Expression::integer(static_cast<long>(k))));
        }
        Expression term = Expression::product(std::move(factors));
        terms.push_back(negative ? Expression::negation(std::move(term)) : std::move(term));
    }
    return Expression::sum(std::move(terms));
}

/// NOTE: one coefficient is 1, and so the integers have no common divisor.
PolynomialQuotient with_integers(const RationalPolynomial& numerator,
                                 const RationalPolynomial& denominator) {
    Integer multiple;
    fmpz_lcm(multiple.get(), fmpq_poly_denref(numerator.get()),
             fmpq_poly_denref(denominator.get()));
    RationalPolynomial above, below;
    fmpq_poly_scalar_mul_fmpz(above.get(), numerator.get(), multiple.get());
    fmpq_poly_scalar_mul_fmpz(below.get(), denominator.get(), multiple.get());
    return {numbers(above), numbers(below)};
}

}  // namespace

std::optional<Expression> closed_form(const PolynomialQuotient& quotient) {
    const auto above = over_rationals(quotient.numerator);
    const auto below = over_rationals(quotient.denominator);
    const PolynomialQuotient written = above && below ? with_integers(*above, *below) : quotient;
    auto numerator = closed_form(written.numerator);
    auto denominator = closed_form(written.denominator);
    if (!numerator || !denominator) { return std::nullopt; }
    if (to_text(*denominator) == "1") { return numerator; }
    return Expression::product(
        {*std::move(numerator), Expression::reciprocal(*std::move(denominator))});
}

std::optional<double> value_at(const PolynomialQuotient& quotient, double z) {
    constexpr slong enough_bits = 40;  // behind the binary point
    Ball argument;
    arb_set_d(argument.get(), z);
    for (Precision bits = first_precision; bits <= last_precision; bits *= 2) {
        Ball value = enclosure(quotient.numerator, argument, bits);
        const Ball denominator = enclosure(quotient.denominator, argument, bits);
        arb_div(value.get(), value.get(), denominator.get(), bits);
        mag_t radius;
        mag_init_set(radius, arb_radref(value.get()));
        const bool is_good = mag_cmp_2exp_si(radius, -enough_bits) < 0;
        mag_clear(radius);
        if (is_good) { return arf_get_d(arb_midref(value.get()), ARF_RND_NEAR); }
    }
    return std::nullopt;
}

}  // namespace hvi::gen

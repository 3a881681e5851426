// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/algebra/polynomial.hpp"

#include <arb_fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>

#include <algorithm>
#include <memory>

#include "generator/exact/numbers/number_value.hpp"

namespace hvi::gen {

RationalPolynomial RationalPolynomial::variable() {
    RationalPolynomial result;
    fmpq_poly_set_coeff_si(result.polynomial_, 1, 1);
    return result;
}

std::string RationalPolynomial::coefficient(long index) const {
    fmpq_t value;
    fmpq_init(value);
    fmpq_poly_get_coeff_fmpq(value, polynomial_, index);
    char* const text = fmpq_get_str(nullptr, 10, value);
    std::string result(text);
    flint_free(text);
    fmpq_clear(value);
    return result;
}

void RationalPolynomial::set_coefficient(long index, const std::string& fraction) {
    fmpq_t value;
    fmpq_init(value);
    const bool read = fmpq_set_str(value, fraction.c_str(), 10) == 0;
    fmpq_poly_set_coeff_fmpq(polynomial_, index, value);
    fmpq_clear(value);
    HVI_CHECK(read);
}

RationalPolynomial RationalPolynomial::derivative() const {
    RationalPolynomial result;
    fmpq_poly_derivative(result.polynomial_, polynomial_);
    return result;
}

std::string RationalPolynomial::integral_over_unit_interval() const {
    RationalPolynomial antiderivative;
    fmpq_poly_integral(antiderivative.polynomial_, polynomial_);
    const RationalPolynomial value = antiderivative.at_affine(0, 1);
    return value.coefficient(0);
}

RationalPolynomial RationalPolynomial::at_affine(long slope, long offset) const {
    RationalPolynomial argument;
    fmpq_poly_set_coeff_si(argument.polynomial_, 1, slope);
    fmpq_poly_set_coeff_si(argument.polynomial_, 0, offset);
    RationalPolynomial result;
    fmpq_poly_compose(result.polynomial_, polynomial_, argument.polynomial_);
    return result;
}

RationalPolynomial operator+(const RationalPolynomial& a, const RationalPolynomial& b) {
    RationalPolynomial result;
    fmpq_poly_add(result.polynomial_, a.polynomial_, b.polynomial_);
    return result;
}

RationalPolynomial operator-(const RationalPolynomial& a, const RationalPolynomial& b) {
    RationalPolynomial result;
    fmpq_poly_sub(result.polynomial_, a.polynomial_, b.polynomial_);
    return result;
}

RationalPolynomial operator*(const RationalPolynomial& a, const RationalPolynomial& b) {
    RationalPolynomial result;
    fmpq_poly_mul(result.polynomial_, a.polynomial_, b.polynomial_);
    return result;
}

RationalPolynomial monic(RationalPolynomial polynomial) {
    fmpq_poly_make_monic(polynomial.get(), polynomial.get());
    return polynomial;
}

RationalPolynomial antiderivative(const RationalPolynomial& polynomial) {
    RationalPolynomial result;
    fmpq_poly_integral(result.get(), polynomial.get());
    return result;
}

bool operator==(const RationalPolynomial& a, const RationalPolynomial& b) {
    return fmpq_poly_equal(a.get(), b.get()) != 0;
}

RationalPolynomial remainder(const RationalPolynomial& a, const RationalPolynomial& P) {
    RationalPolynomial result;
    fmpq_poly_rem(result.get(), a.get(), P.get());
    return result;
}

std::optional<RationalPolynomial> inverse_modulo(const RationalPolynomial& a,
                                                 const RationalPolynomial& P) {
    RationalPolynomial divisor, inverse, cofactor;
    fmpq_poly_xgcd(divisor.get(), inverse.get(), cofactor.get(), a.get(), P.get());
    if (divisor.degree() != 0) { return std::nullopt; }
    return remainder(inverse, P);
}

RationalPolynomial legendre(unsigned degree) {
    RationalPolynomial result;
    fmpq_poly_legendre_p(result.get(), degree);
    return result;
}

RationalPolynomial chebyshev_equal_weights(unsigned degree) {
    // The first degree + 1 coefficients of exp(-s sum_k y^2k / (2k (2k+1))) in y = 1/x, reversed.
    RationalPolynomial exponent;
    for (unsigned k = 1; 2 * k <= degree; ++k) {
        exponent.set_coefficient(2 * k, "-" + std::to_string(degree) + "/" +
                                            std::to_string(2 * k * (2 * k + 1)));
    }
    RationalPolynomial series;
    fmpq_poly_exp_series(series.get(), exponent.get(), static_cast<slong>(degree) + 1);
    RationalPolynomial result;
    fmpq_poly_reverse(result.get(), series.get(), static_cast<slong>(degree) + 1);
    return result;
}

namespace {

/// An integer polynomial of FLINT: the numerator of a polynomial over Q, an irreducible factor of
/// one, ...
class IntegerPolynomial {
public:
    IntegerPolynomial() { fmpz_poly_init(polynomial_); }
    IntegerPolynomial(const IntegerPolynomial&) = delete;
    IntegerPolynomial& operator=(const IntegerPolynomial&) = delete;
    ~IntegerPolynomial() { fmpz_poly_clear(polynomial_); }
    [[nodiscard]] fmpz_poly_struct* get() { return polynomial_; }

private:
    fmpz_poly_t polynomial_;
};

/// Returns the real roots of an irreducible polynomial, isolated at the working precision,
/// ascending.
std::vector<Ball> isolate(IntegerPolynomial& factor, Precision bits) {
    const slong degree = fmpz_poly_degree(factor.get());
    acb_ptr roots = _acb_vec_init(degree);
    arb_fmpz_poly_complex_roots(roots, factor.get(), 0, bits);
    std::vector<Ball> result;
    for (slong i = 0; i < degree; ++i) {
        if (!acb_is_real(roots + i)) continue;
        Ball root;
        arb_set(root.get(), acb_realref(roots + i));
        result.push_back(std::move(root));
    }
    _acb_vec_clear(roots, degree);
    std::sort(result.begin(), result.end(), [](const Ball& left, const Ball& right) {
        return arb_lt(left.get(), right.get()) != 0;
    });
    return result;
}

void append_enclosed_roots(NumberVector& roots, std::shared_ptr<IntegerPolynomial> factor) {
    struct Isolated {
        Precision bits = 0;
        std::vector<Ball> roots;
    };
    auto isolated = std::make_shared<Isolated>();
    const auto at = [factor, isolated](Precision bits) -> const std::vector<Ball>& {
        if (isolated->bits < bits) {
            isolated->roots = isolate(*factor, bits);
            isolated->bits = bits;
        }
        return isolated->roots;
    };
    for (std::size_t i = 0; i < at(first_precision).size(); ++i) {
        roots.push_back(number(Real([at, i](Precision bits) { return at(bits).at(i); })));
    }
}

NumberVector coefficients(IntegerPolynomial& factor, const Ground& ground) {
    NumberVector result;
    for (slong i = 0; i <= fmpz_poly_degree(factor.get()); ++i) {
        char* const text = fmpz_get_str(nullptr, 10, fmpz_poly_get_coeff_ptr(factor.get(), i));
        result.push_back(ground.rational(text, "1"));
        flint_free(text);
    }
    return result;
}

/// Returns the real roots of a x^2 + b x + c, if any.
NumberVector quadratic_roots(const Number& a, const Number& b, const Number& c,
                             const Ground& ground) {
    const Number discriminant = b * b - Number(4) * a * c;
    if (discriminant.sign() < 0) return {};
    const Number root = ground.sqrt(discriminant);
    return {(-b - root) / (Number(2) * a), (-b + root) / (Number(2) * a)};
}

/// Appends the roots of a factor where they are written with square roots. Returns whether they
/// are.
bool append_exact_roots(NumberVector& roots, IntegerPolynomial& factor, const Ground& ground) {
    const NumberVector k = coefficients(factor, ground);
    if (k.size() == 2) {
        roots.push_back(-k[0] / k[1]);
        return true;
    }
    if (k.size() == 3) {
        for (const Number& root : quadratic_roots(k[2], k[1], k[0], ground)) roots.push_back(root);
        return true;
    }
    if (k.size() != 5) return false;
    // x = y - m with m = k3/(4 k4) removes y^3; exact when y^1 goes with it.
    const Number m = k[3] / (Number(4) * k[4]);
    const Number linear =
        k[1] - Number(2) * k[2] * m + Number(3) * k[3] * m * m - Number(4) * k[4] * m * m * m;
    if (!linear.is_zero()) return false;
    const Number square = k[2] - Number(3) * k[3] * m + Number(6) * k[4] * m * m;
    const Number constant =
        k[0] - k[1] * m + k[2] * m * m - k[3] * m * m * m + k[4] * m * m * m * m;
    for (const Number& y_squared : quadratic_roots(k[4], square, constant, ground)) {
        if (y_squared.sign() < 0) continue;
        const Number y = ground.sqrt(y_squared);
        roots.push_back(-m - y);
        roots.push_back(-m + y);
    }
    return true;
}

}  // namespace

RationalPolynomial chebyshev_t(unsigned degree) {
    IntegerPolynomial integral;
    fmpz_poly_chebyshev_t(integral.get(), degree);
    RationalPolynomial result;
    fmpq_poly_set_fmpz_poly(result.get(), integral.get());
    return result;
}

std::vector<IrreducibleFactor> irreducible_factors(const RationalPolynomial& polynomial) {
    HVI_CHECK(polynomial.degree() >= 0);
    IntegerPolynomial integral;
    fmpq_poly_get_numerator(integral.get(), polynomial.get());
    fmpz_poly_factor_t factors;
    fmpz_poly_factor_init(factors);
    fmpz_poly_factor(factors, integral.get());
    std::vector<IrreducibleFactor> result(static_cast<std::size_t>(factors->num));
    for (std::size_t i = 0; i < result.size(); ++i) {
        fmpq_poly_set_fmpz_poly(result[i].polynomial.get(), factors->p + i);
        fmpq_poly_make_monic(result[i].polynomial.get(), result[i].polynomial.get());
        result[i].multiplicity = static_cast<unsigned>(factors->exp[i]);
    }
    fmpz_poly_factor_clear(factors);
    return result;
}

Ball enclosure(const RationalPolynomial& polynomial, const Ball& argument, Precision bits) {
    IntegerPolynomial numerator;
    fmpq_poly_get_numerator(numerator.get(), polynomial.get());
    Ball result;
    arb_fmpz_poly_evaluate_arb(result.get(), numerator.get(), argument.get(), bits);
    arb_div_fmpz(result.get(), result.get(), fmpq_poly_denref(polynomial.get()), bits);
    return result;
}

NumberVector real_roots(const RationalPolynomial& polynomial, const Ground& ground) {
    HVI_CHECK(polynomial.degree() >= 0);
    NumberVector roots;
    for (const IrreducibleFactor& irreducible : irreducible_factors(polynomial)) {
        auto factor = std::make_shared<IntegerPolynomial>();
        fmpq_poly_get_numerator(factor->get(), irreducible.polynomial.get());
        if (!append_exact_roots(roots, *factor, ground)) append_enclosed_roots(roots, factor);
    }
    std::sort(roots.begin(), roots.end(),
              [](const Number& left, const Number& right) { return (left - right).sign() < 0; });
    return roots;
}

}  // namespace hvi::gen

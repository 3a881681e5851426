// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/algebra/polynomial_arithmetic.hpp"

#include <acb_poly.h>
#include <arb_mat.h>

#include <algorithm>
#include <memory>

#include "generator/exact/numbers/number_value.hpp"
#include "generator/exact/numbers/rational.hpp"

namespace hvi::gen {

namespace {

bool are_exact(const NumberPolynomial& polynomial) {
    return std::all_of(polynomial.begin(), polynomial.end(), is_exact);
}

bool have_parameters(const NumberPolynomial& polynomial) {
    return std::any_of(polynomial.begin(), polynomial.end(),
                       [](const Number& coefficient) { return coefficient.has_parameters(); });
}

/// Returns whether bounds of the resultant, the determinant of Sylvester's matrix, prove that there
/// is no common root. NOTE: Euclid's algorithm in a field with generators takes seconds where these
/// bounds take no time, and most polynomials that meet here are coprime.
bool surely_coprime(const NumberPolynomial& a, const NumberPolynomial& b) {
    constexpr Precision bits = 512;
    const std::size_t m = a.size() - 1;
    const std::size_t n = b.size() - 1;
    arb_mat_t sylvester;
    arb_mat_init(sylvester, static_cast<slong>(m + n), static_cast<slong>(m + n));
    const auto fill = [&](const NumberPolynomial& polynomial, std::size_t first, std::size_t rows) {
        for (std::size_t i = 0; i < polynomial.size(); ++i) {
            const Ball coefficient = enclosure(polynomial[i], bits);
            for (std::size_t row = 0; row < rows; ++row) {
                arb_set(arb_mat_entry(sylvester, static_cast<slong>(first + row),
                                      static_cast<slong>(row + i)),
                        coefficient.get());
            }
        }
    };
    fill(a, 0, n);
    fill(b, n, m);
    Ball resultant;
    arb_mat_det(resultant.get(), sylvester, bits);
    arb_mat_clear(sylvester);
    return resultant.sign() != 0;
}

NumberPolynomial monic(const NumberPolynomial& polynomial) {
    if (polynomial.empty()) { return polynomial; }
    NumberPolynomial result;
    for (std::size_t i = 0; i + 1 < polynomial.size(); ++i) {
        result.push_back(polynomial[i] / polynomial.back());
    }
    result.emplace_back(1);
    return result;
}

}  // namespace

bool PolynomialArithmetic::is_zero(const Number& number) {
    const auto known = number.known_zero();
    proved_ = proved_ && known;
    return known.value_or(true);
}

NumberPolynomial PolynomialArithmetic::trimmed(NumberPolynomial polynomial) {
    while (!polynomial.empty() && is_zero(polynomial.back())) { polynomial.pop_back(); }
    return polynomial;
}

NumberPolynomial PolynomialArithmetic::sum(const NumberPolynomial& a, const Number& factor,
                                           const NumberPolynomial& b) {
    NumberPolynomial result = a;
    result.resize(std::max(a.size(), b.size()));
    for (std::size_t i = 0; i < b.size(); ++i) { result[i] = result[i] + factor * b[i]; }
    return trimmed(std::move(result));
}

Division PolynomialArithmetic::divide(const NumberPolynomial& dividend,
                                      const NumberPolynomial& divisor) {
    HVI_CHECK(!divisor.empty());
    Division result{{}, dividend};
    NumberPolynomial& rest = result.remainder;
    if (rest.size() < divisor.size()) { return result; }
    result.quotient.resize(rest.size() - divisor.size() + 1);
    for (std::size_t shift = result.quotient.size(); shift-- > 0;) {
        const Number factor = rest.back() / divisor.back();
        rest.pop_back();
        for (std::size_t i = 0; i + 1 < divisor.size(); ++i) {
            rest[shift + i] = rest[shift + i] - factor * divisor[i];
        }
        result.quotient[shift] = factor;
    }
    rest = trimmed(std::move(rest));
    return result;
}

NumberPolynomial PolynomialArithmetic::gcd(const NumberPolynomial& a, const NumberPolynomial& b) {
    if (a.empty() || b.empty()) { return monic(a.empty() ? b : a); }
    if (a.size() == 1 || b.size() == 1) { return {Number(1)}; }
    const auto over_q = over_rationals(a);
    const auto other_over_q = over_rationals(b);
    if (over_q && other_over_q) {
        RationalPolynomial result;
        fmpq_poly_gcd(result.get(), over_q->get(), other_over_q->get());
        return numbers(result);
    }
    if (!have_parameters(a) && !have_parameters(b) && surely_coprime(a, b)) { return {Number(1)}; }
    NumberPolynomial previous = a;
    NumberPolynomial rest = b;
    while (!rest.empty()) {
        NumberPolynomial next = divide(previous, rest).remainder;
        previous = std::move(rest);
        rest = next.empty() ? std::move(next) : monic(next);
    }
    return monic(previous);
}

NumberPolynomial PolynomialArithmetic::without(const NumberPolynomial& a,
                                               const NumberPolynomial& b) {
    const NumberPolynomial common = gcd(a, b);
    return common.size() == 1 ? a : divide(a, common).quotient;
}

NumberPolynomial PolynomialArithmetic::squarefree(const NumberPolynomial& polynomial) {
    return polynomial.size() <= 2 ? polynomial : without(polynomial, derivative(polynomial));
}

NumberPolynomial numbers(const RationalPolynomial& polynomial) {
    NumberPolynomial result;
    fmpq_t coefficient;
    fmpq_init(coefficient);
    for (long i = 0; i <= polynomial.degree(); ++i) {
        fmpq_poly_get_coeff_fmpq(coefficient, polynomial.get(), i);
        result.push_back(number(Element::copy_of(coefficient), nullptr));
    }
    fmpq_clear(coefficient);
    return result;
}

NumberPolynomial derivative(const NumberPolynomial& polynomial) {
    NumberPolynomial result;
    for (std::size_t i = 1; i < polynomial.size(); ++i) {
        result.push_back(polynomial[i] * Number(static_cast<long>(i)));
    }
    return result;
}

Ball enclosure(const NumberPolynomial& polynomial, const Ball& argument, Precision bits) {
    Ball result;
    for (auto next = polynomial.rbegin(); next != polynomial.rend(); ++next) {
        arb_mul(result.get(), result.get(), argument.get(), bits);
        arb_add(result.get(), result.get(), enclosure(*next, bits).get(), bits);
    }
    return result;
}

std::size_t term_count(const Number& number) {
    const Element* const element = number.value().element();
    return element == nullptr ? 0 : element->term_count();
}

std::size_t term_count(const NumberMatrix& rows) {
    std::size_t count = 0;
    for (const NumberVector& row : rows) {
        for (const Number& entry : row) { count += term_count(entry); }
    }
    return count;
}

bool is_less(const Number& left, const Number& right) {
    if (&left.value() == &right.value()) { return false; }
    for (Precision bits = first_precision; bits <= last_precision; bits *= 2) {
        const Ball a = enclosure(left, bits);
        const Ball b = enclosure(right, bits);
        if (arb_overlaps(a.get(), b.get()) == 0) { return arb_lt(a.get(), b.get()) != 0; }
    }
    throw MathError("cannot decide which of two numbers is less");
}

// ---- roots ----

namespace {

/// Returns a Ground over the field of exact coefficients.
Ground ground_of(const NumberPolynomial& polynomial) {
    for (const Number& coefficient : polynomial) {
        if (coefficient.value().field) { return Ground(coefficient.value().field); }
    }
    return Ground(std::make_shared<Field>(Denominators{}));
}

bool is_inside(const Number& z, long bound) {
    return z.sign() > 0 && (Number(bound) - z).sign() > 0;
}

/// Returns P(z^2).
RationalPolynomial of_square(const RationalPolynomial& polynomial) {
    const RationalPolynomial z = RationalPolynomial::variable();
    const RationalPolynomial square = z * z;
    RationalPolynomial result;
    fmpq_poly_compose(result.get(), polynomial.get(), square.get());
    return result;
}

/// Appends the roots in z, where more polynomials have roots of low degree than in z^2. Each factor
/// has a field of its own: together they would need more generators than one field has.
void append_rational(NumberVector& roots, const RationalPolynomial& polynomial, long bound) {
    for (const IrreducibleFactor& factor : irreducible_factors(of_square(polynomial))) {
        const Ground ground(std::make_shared<Field>(Denominators{}));
        for (const Number& z : real_roots(factor.polynomial, ground)) {
            if (is_inside(z, bound)) { roots.push_back(z); }
        }
    }
}

/// Returns the number, without its closed form where that is too long for a line.
Number readable(const Number& z) {
    constexpr std::size_t most_characters = 90;
    const auto form = z.closed_form();
    if (!form || to_text(*form).size() <= most_characters) { return z; }
    return number(Real([z](Precision bits) { return enclosure(z, bits); }));
}

/// Appends roots by the formulas for degree 1 and 2, if the results are short: a square root of a
/// long number takes long to find and to write, and says no more than its decimals.
bool append_exact(NumberVector& roots, const NumberPolynomial& polynomial, long bound) {
    constexpr std::size_t most_terms = 12;
    constexpr std::size_t most_under_root = 32;
    const Ground ground = ground_of(polynomial);
    NumberVector squares;
    if (polynomial.size() == 2) {
        squares.push_back(-polynomial[0] / polynomial[1]);
    } else {
        const Number half = polynomial[1] / (Number(2) * polynomial[2]);
        const Number discriminant = half * half - polynomial[0] / polynomial[2];
        if (term_count(half) + term_count(discriminant) > most_under_root) { return false; }
        if (discriminant.sign() < 0) { return true; }
        const Number root = ground.sqrt(discriminant);
        squares = {-half - root, -half + root};
    }
    for (const Number& t : squares) {
        if (term_count(t) > most_terms) { return false; }
    }
    for (const Number& t : squares) {
        if (is_inside(t, bound * bound)) { roots.push_back(readable(ground.sqrt(t))); }
    }
    return true;
}

/// All complex roots, as Arb isolates them: at a sufficient precision the real ones are told apart
/// from the others.
class IsolatedRoots {
public:
    explicit IsolatedRoots(NumberPolynomial polynomial) : polynomial_(std::move(polynomial)) {}

    /// Returns the real roots, ascending, to about `bits` bits.
    [[nodiscard]] const std::vector<Ball>& at(Precision bits) {
        for (Precision working = bits; bits_ < bits; working *= 2) {
            if (working > last_precision) {
                throw MathError("cannot isolate the real roots of a polynomial with " +
                                std::to_string(last_precision) + " bits");
            }
            if (isolate(working)) { bits_ = bits; }
        }
        return roots_;
    }

private:
    [[nodiscard]] bool isolate(Precision working) {
        const auto degree = static_cast<slong>(polynomial_.size()) - 1;
        acb_poly_t enclosed;
        acb_poly_init(enclosed);
        for (slong i = 0; i <= degree; ++i) {
            const Ball coefficient = enclosure(polynomial_[static_cast<std::size_t>(i)], working);
            acb_poly_fit_length(enclosed, i + 1);
            acb_set_arb(enclosed->coeffs + i, coefficient.get());
            _acb_poly_set_length(enclosed, i + 1);
        }
        acb_ptr roots = _acb_vec_init(degree);
        const bool isolated = acb_poly_find_roots(roots, enclosed, nullptr, 0, working) == degree &&
                              acb_poly_validate_real_roots(roots, enclosed, working) != 0;
        if (isolated) { keep_real(roots, degree); }
        _acb_vec_clear(roots, degree);
        acb_poly_clear(enclosed);
        return isolated;
    }

    void keep_real(acb_srcptr roots, slong degree) {
        roots_.clear();
        for (slong i = 0; i < degree; ++i) {
            if (arb_contains_zero(acb_imagref(roots + i)) == 0) { continue; }
            Ball root;
            arb_set(root.get(), acb_realref(roots + i));
            roots_.push_back(std::move(root));
        }
        std::sort(roots_.begin(), roots_.end(), [](const Ball& left, const Ball& right) {
            return arb_lt(left.get(), right.get()) != 0;
        });
    }

    NumberPolynomial polynomial_;
    Precision bits_ = 0;
    std::vector<Ball> roots_;
};

/// Returns the polynomial without a root at the bound. NOTE: enclosures do not tell a root at the
/// bound from one inside, so it is divided out.
NumberPolynomial without_root_at(const Number& point, const NumberPolynomial& polynomial) {
    const bool is_root = value_at(polynomial, point).known_zero().value_or(false);
    return is_root ? divide(polynomial, {-point, Number(1)}).quotient : polynomial;
}

void append_enclosed(NumberVector& roots, const NumberPolynomial& polynomial, long bound) {
    const auto isolated =
        std::make_shared<IsolatedRoots>(without_root_at(Number(bound * bound), polynomial));
    const std::size_t count = isolated->at(first_precision).size();
    for (std::size_t i = 0; i < count; ++i) {
        const Number t =
            number(Real([isolated, i](Precision bits) { return isolated->at(bits).at(i); }));
        if (!is_inside(t, bound * bound)) { continue; }
        roots.push_back(number(Real([t](Precision bits) {
            Ball root = enclosure(t, bits);
            arb_sqrt(root.get(), root.get(), bits);
            return root;
        })));
    }
}

}  // namespace

NumberVector roots_in_square(const NumberPolynomial& polynomial, long bound) {
    NumberVector roots;
    if (polynomial.size() <= 1) { return roots; }
    if (const auto rational = over_rationals(polynomial)) {
        append_rational(roots, *rational, bound);
    } else {
        const bool has_formula = polynomial.size() <= 3 && are_exact(polynomial);
        if (!has_formula || !append_exact(roots, polynomial, bound)) {
            append_enclosed(roots, polynomial, bound);
        }
    }
    std::sort(roots.begin(), roots.end(), is_less);
    return roots;
}

}  // namespace hvi::gen

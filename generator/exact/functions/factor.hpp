// Factors of terms that take a function out of the class of polynomials, exponentials and waves.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "generator/exact/algebra/number_polynomial.hpp"
#include "generator/exact/functions/function.hpp"
#include "generator/exact/numbers/rational.hpp"

namespace hvi::gen {

/// Whether two numbers are proved to be equal.
[[nodiscard]] bool are_equal(const Number& left, const Number& right);

/// L^exponent * log(L)^logs with the line L = offset + sign*tau, not negative on the domain:
/// square and other roots, logarithms, and the powers of 1/L.
struct LinearPower {
    Number offset;  ///< an element of the field, without free parameter
    int sign = 1;
    Ratio exponent;
    unsigned logs = 0;

    [[nodiscard]] bool is_polynomial() const {
        return logs == 0 && exponent.is_integer() && exponent.above >= 0;
    }
    [[nodiscard]] NumberPolynomial line() const { return {offset, Number(sign)}; }
};

/// 1/polynomial^order, the polynomial monic and irreducible as `factorize` has it, of degree 2 or
/// more.
struct Pole {
    NumberPolynomial polynomial;
    unsigned order = 1;
};

/// base^exponent of what is not zero within the domain, and positive when the exponent is no
/// integer.
struct Power {
    ExactFunction base;
    Ratio exponent;
};

/// A function of expr/functions.def of a function, other than those that are written by others:
/// sqrt, cbrt, cosh, sinh, log10 and atanh.
struct Call {
    std::string name;
    ExactFunction argument;
};

/// A product of two or more factors of the kinds above.
struct Product {
    std::vector<FactorPointer> factors;
};

struct Factor {
    std::variant<LinearPower, Pole, Power, Call, Product> what;
};

template <class Kind>
FactorPointer make_factor(Kind kind) {
    return std::make_shared<const Factor>(Factor{std::move(kind)});
}

/// Whether two factors are known to be the same function.
[[nodiscard]] bool same(const Factor& left, const Factor& right);

/// Whether terms with this factor are independent of all others: powers and logarithms of different
/// lines have their branch points at different places, and partial fractions over coprime
/// denominators are unique. Of other factors nothing is known: 1/(1+tau^4) and the fractions over
/// tau^2 +- sqrt(2)*tau + 1 are dependent.
[[nodiscard]] bool is_independent(const Factor& factor);

/// The terms of a normal form that a term with a factor is the sum of: powers of a line without
/// powers of tau, numerators of smaller degree than denominators, and one exponential.
[[nodiscard]] std::vector<ExactTerm> normal_terms(const ExactTerm& term);

/// Equal lines and bases are put together, and products of rational functions become sums of
/// partial fractions.
[[nodiscard]] ExactFunction product_of_factors(const FactorPointer& left,
                                               const FactorPointer& right);

/// The polynomial, not always monic, and the order of a factor that is 1 over a power of one.
[[nodiscard]] std::optional<Pole> as_pole(const Factor& factor);

/// A function of the table of Call, of a function without constant term for exp. Of the arguments
/// x and -x one is written, as the function is even or odd.
[[nodiscard]] ExactFunction call_of(const std::string& name, const ExactFunction& argument);

/// base^exponent, for what Power allows.
[[nodiscard]] ExactFunction power_of(const ExactFunction& base, const Ratio& exponent);

/// 1/polynomial^order. `inside` is a point of the domain, which tells the sign of a line. The
/// polynomial is a part of `factorize`.
[[nodiscard]] ExactFunction partial_fraction(const NumberPolynomial& polynomial, unsigned order,
                                             const Number& inside);

/// The line of a monic polynomial of degree 1, or its opposite: what is positive inside.
[[nodiscard]] LinearPower line_through(const NumberPolynomial& monic, const Number& inside);

/// The value at a point of the domain. Throws MathError where it is infinite.
[[nodiscard]] Number value(const Factor& factor, const Number& point, const Ground& ground);

}  // namespace hvi::gen

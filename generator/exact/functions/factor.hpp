// Factors of terms beside powers, exponentials and waves.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "generator/exact/algebra/number_polynomial.hpp"
#include "generator/exact/functions/function.hpp"
#include "generator/exact/numbers/rational.hpp"

namespace hvi::gen {

/// Returns whether two numbers are proved to be equal.
[[nodiscard]] bool are_equal(const Number& left, const Number& right);

/// A factor L^exponent * log(L)^logs with the line L = offset + sign*tau, not negative on the
/// domain: square and other roots, logarithms, and the powers of 1/L.
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

/// A factor 1/polynomial^order. The polynomial is monic and irreducible as in `factorize`, of
/// degree 2 or more.
struct Pole {
    NumberPolynomial polynomial;
    unsigned order = 1;
};

/// A factor base^exponent, where the base is not zero within the domain, and positive when the
/// exponent is no integer.
struct Power {
    ExactFunction base;
    Ratio exponent;
};

/// A function of expr/functions.def of a function, except those that are expressed by others: sqrt,
/// cbrt, cosh, sinh, log10 and atanh.
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

/// Returns whether two factors are known to be the same function.
[[nodiscard]] bool same(const Factor& left, const Factor& right);

/// Returns whether terms with this factor are independent of all others. Powers and logarithms of
/// different lines have their branch points at different places, and partial fractions over coprime
/// denominators are unique. Other factors may be dependent: 1/(1+tau^4) and the fractions over
/// tau^2 +- sqrt(2)*tau + 1 are.
[[nodiscard]] bool is_independent(const Factor& factor);

/// Returns a term with a factor as a sum of terms in normal form: powers of a line without powers
/// of tau, numerators of smaller degree than denominators, and one exponential.
[[nodiscard]] std::vector<ExactTerm> normal_terms(const ExactTerm& term);

/// Returns the product of two factors. Equal lines and bases are put together, and products of
/// rational functions become sums of partial fractions.
[[nodiscard]] ExactFunction product_of_factors(const FactorPointer& left,
                                               const FactorPointer& right);

/// Returns the polynomial, not always monic, and the order of a factor that is 1 over a power of a
/// polynomial.
[[nodiscard]] std::optional<Pole> as_pole(const Factor& factor);

/// Returns a function of the table of Call; for exp the argument has no constant term. One of the
/// arguments x and -x is written, as the function is even or odd.
[[nodiscard]] ExactFunction call_of(const std::string& name, const ExactFunction& argument);

/// Returns base^exponent, where Power allows it.
[[nodiscard]] ExactFunction power_of(const ExactFunction& base, const Ratio& exponent);

/// Returns 1/polynomial^order. `inside` is a point of the domain, which tells the sign of a line.
/// The polynomial is a part of `factorize`.
[[nodiscard]] ExactFunction partial_fraction(const NumberPolynomial& polynomial, unsigned order,
                                             const Number& inside);

/// Returns the line of a monic polynomial of degree 1, or its opposite: the one that is positive
/// inside.
[[nodiscard]] LinearPower line_through(const NumberPolynomial& monic, const Number& inside);

/// Returns the value at a point of the domain. Throws MathError where it is infinite.
[[nodiscard]] Number value(const Factor& factor, const Number& point, const Ground& ground);

}  // namespace hvi::gen

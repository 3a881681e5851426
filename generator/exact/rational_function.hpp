// Quotients of polynomials over Q in the transcendental generators of a Field.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <flint/fmpz_mpoly.h>
#include <ginac/ginac.h>

#include <optional>
#include <vector>

namespace hvi::gen {

/// An integer polynomial: FLINT's, with value semantics. The variables are numbered 0, 1, ...
class IntegerMultivariate {
public:
    /// Packed exponents ask for a bound; nobody reads a tableau with so many symbols.
    static constexpr std::size_t most_variables = 32;

    IntegerMultivariate() { fmpz_mpoly_init(polynomial_, context()); }
    IntegerMultivariate(const IntegerMultivariate& other) : IntegerMultivariate() {
        fmpz_mpoly_set(polynomial_, other.polynomial_, context());
    }
    IntegerMultivariate(IntegerMultivariate&& other) noexcept : IntegerMultivariate() {
        fmpz_mpoly_swap(polynomial_, other.polynomial_, context());
    }
    IntegerMultivariate& operator=(IntegerMultivariate other) noexcept {
        fmpz_mpoly_swap(polynomial_, other.polynomial_, context());
        return *this;
    }
    ~IntegerMultivariate() { fmpz_mpoly_clear(polynomial_, context()); }

    [[nodiscard]] fmpz_mpoly_struct* get() { return polynomial_; }
    [[nodiscard]] const fmpz_mpoly_struct* get() const { return polynomial_; }
    [[nodiscard]] static const fmpz_mpoly_ctx_struct* context();

private:
    fmpz_mpoly_t polynomial_;
};

/// An element of Q(x_0, x_1, ...) in lowest terms: numerator and denominator have integer
/// coefficients and no common divisor, the leading coefficient of the denominator is positive. So
/// equal functions have equal parts, and zero is the one with numerator 0.
class RationalFunction {
public:
    RationalFunction() : RationalFunction(0) {}
    RationalFunction(long value);                      // NOLINT(google-explicit-constructor)
    RationalFunction(const GiNaC::numeric& rational);  // NOLINT(google-explicit-constructor)
    /// x_index. Precondition: index < IntegerMultivariate::most_variables.
    [[nodiscard]] static RationalFunction variable(std::size_t index);

    /// coefficient * product of x_i^powers[i].
    struct Term {
        GiNaC::numeric coefficient;
        std::vector<unsigned> powers;
    };
    [[nodiscard]] static RationalFunction of(const Term& term);

    friend RationalFunction operator+(const RationalFunction& a, const RationalFunction& b);
    friend RationalFunction operator*(const RationalFunction& a, const RationalFunction& b);
    friend RationalFunction operator-(const RationalFunction& a);
    /// Precondition: not zero.
    [[nodiscard]] RationalFunction inverse() const;

    [[nodiscard]] bool is_zero() const;
    [[nodiscard]] bool is_rational() const;                ///< no variable occurs
    [[nodiscard]] GiNaC::numeric rational() const;         ///< precondition: is_rational()
    [[nodiscard]] bool contains(std::size_t index) const;  ///< whether x_index occurs

    /// In an order that depends on the polynomial alone; integer coefficients.
    [[nodiscard]] std::vector<Term> numerator() const;
    [[nodiscard]] std::vector<Term> denominator() const;
    [[nodiscard]] std::size_t term_count() const;  ///< of both

    /// The positive rational r for which this is r times a quotient of primitive polynomials.
    [[nodiscard]] GiNaC::numeric content() const;

    /// A square root in the same field, where there is one.
    [[nodiscard]] std::optional<RationalFunction> square_root() const;

    struct Factor;
    /// The numerator without its integer content as a product of irreducible polynomials, in an
    /// order that depends on the polynomial alone. Precondition: not zero.
    [[nodiscard]] std::vector<Factor> factors() const;

    /// The degree of the numerator in x_index.
    [[nodiscard]] unsigned degree(std::size_t index) const;

    /// The least common multiple of the denominators, as a polynomial over Z.
    friend RationalFunction common_denominator(const RationalFunction& a,
                                               const RationalFunction& b);

private:
    using RationalOperation = void (*)(fmpq_t, const fmpq_t, const fmpq_t);
    /// Precondition: both without variables, for which FLINT's rationals are much faster.
    [[nodiscard]] static RationalFunction
    of_rationals(const RationalFunction& a, const RationalFunction& b, RationalOperation operation);

    IntegerMultivariate numerator_;
    IntegerMultivariate denominator_;
};

/// base^exponent, the base a primitive polynomial.
struct RationalFunction::Factor {
    RationalFunction base;
    unsigned exponent;
};

}  // namespace hvi::gen

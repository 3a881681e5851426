// Polynomials over Z in the transcendental generators of a Field.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <flint/fmpz_mpoly.h>

#include <optional>
#include <vector>

#include "generator/exact/numbers/integers.hpp"

namespace hvi::gen {

/// A polynomial in variables x_0, x_1, ...: FLINT's, with value semantics.
class IntegerMultivariate {
public:
    /// Limit of variables, which packed exponents need; nobody reads a tableau with so many
    /// symbols.
    static constexpr std::size_t most_variables = 32;

    IntegerMultivariate() { fmpz_mpoly_init(polynomial_, context()); }  ///< zero
    explicit IntegerMultivariate(long integer) : IntegerMultivariate() {
        fmpz_mpoly_set_si(polynomial_, integer, context());
    }
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

    /// Returns x_index. Precondition: index < most_variables.
    [[nodiscard]] static IntegerMultivariate variable(std::size_t index);

    /// A term coefficient * product of x_i^powers[i].
    struct Term {
        Integer coefficient;
        std::vector<unsigned> powers;
    };
    [[nodiscard]] static IntegerMultivariate of(const Term& term);
    /// Returns the terms in an order that depends on the polynomial alone, beginning with the
    /// leading term.
    [[nodiscard]] std::vector<Term> terms() const;
    [[nodiscard]] std::size_t term_count() const;

    friend IntegerMultivariate operator*(const IntegerMultivariate& a,
                                         const IntegerMultivariate& b);
    IntegerMultivariate& operator+=(const IntegerMultivariate& other);
    /// Divides exactly. Precondition: the divisor divides it.
    IntegerMultivariate& operator/=(const IntegerMultivariate& divisor);
    void negate();

    [[nodiscard]] bool is_zero() const;
    [[nodiscard]] bool is_one() const;
    [[nodiscard]] bool is_constant() const;                ///< no variable occurs
    [[nodiscard]] Integer constant() const;                ///< precondition: is_constant()
    [[nodiscard]] bool contains(std::size_t index) const;  ///< whether x_index occurs
    [[nodiscard]] int leading_sign() const;
    [[nodiscard]] Integer content() const;  ///< of the coefficients; not negative

    [[nodiscard]] unsigned degree(std::size_t index) const;  ///< in x_index; 0 for zero

    /// Returns the quotient, where the divisor divides it.
    [[nodiscard]] std::optional<IntegerMultivariate>
    divided_by(const IntegerMultivariate& divisor) const;

    struct Factor;
    /// Returns the polynomial without its content as a product of irreducible polynomials of
    /// leading sign 1, in an order that depends on the polynomial alone. Precondition: not zero.
    [[nodiscard]] std::vector<Factor> factors() const;

    /// Returns a square root, where there is one.
    [[nodiscard]] std::optional<IntegerMultivariate> square_root() const;

    [[nodiscard]] fmpz_mpoly_struct* get() { return polynomial_; }
    [[nodiscard]] const fmpz_mpoly_struct* get() const { return polynomial_; }
    [[nodiscard]] static const fmpz_mpoly_ctx_struct* context();

private:
    fmpz_mpoly_t polynomial_;
};

/// A factor base^exponent.
struct IntegerMultivariate::Factor {
    IntegerMultivariate base;
    unsigned exponent;
};

/// Returns the greatest common divisor, content included, of leading sign 1.
[[nodiscard]] IntegerMultivariate gcd(const IntegerMultivariate& a, const IntegerMultivariate& b);

[[nodiscard]] IntegerMultivariate power(const IntegerMultivariate& base, unsigned exponent);

}  // namespace hvi::gen

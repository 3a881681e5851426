// Budget of work and memory for the exact arithmetic of one derivation.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "generator/exact/numbers/multivariate.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

/// Thrown where an exact result is too long, or took too long. A number that has a value is then
/// known by its enclosures; for one with free parameters there is no other form.
class TooLarge : public MathError {
public:
    TooLarge();
};

/// Counts the cost of arithmetic, in products of terms. NOTE: never in seconds, so that one input
/// has one output on all machines. A second is some ten or twenty million products.
class Budget {
public:
    /// Limit of the terms of a polynomial in a number, or in an intermediate result.
    static constexpr std::size_t most_terms = 8192;
    static constexpr double most_products_at_once = 1e7;
    static constexpr double most_products = 1.2e8;

    /// Called before a product of these, or after a division with this quotient and divisor. Throws
    /// TooLarge, as the others do.
    void spend_on_product(const IntegerMultivariate& a, const IntegerMultivariate& b);
    /// Called before their greatest common divisor is computed.
    void spend_on_divisor(const IntegerMultivariate& a, const IntegerMultivariate& b);
    /// Called after a product.
    static void check_length(const IntegerMultivariate& result);

private:
    void spend(double products);

    double spent_ = 0;
};

}  // namespace hvi::gen

// How much work and room the exact arithmetic of one derivation may take.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "generator/exact/numbers/multivariate.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

/// An exact result is too long, or took too long. A number that has a value is left to its
/// enclosures then; for one with free parameters there is nothing else.
class TooLarge : public MathError {
public:
    TooLarge();
};

/// Counts what arithmetic takes, in products of terms. NOTE: never in seconds, so that one input
/// has one output on all machines. A second is some ten or twenty million products.
class Budget {
public:
    /// Of a polynomial that stands in a number or on the way to it.
    static constexpr std::size_t most_terms = 8192;
    static constexpr double most_products_at_once = 1e7;
    static constexpr double most_products = 1.2e8;

    /// Before a product of these, or after a division with this quotient and divisor. Throws
    /// TooLarge, as the others do.
    void spend_on_product(const IntegerMultivariate& a, const IntegerMultivariate& b);
    /// Before their greatest common divisor is computed.
    void spend_on_divisor(const IntegerMultivariate& a, const IntegerMultivariate& b);
    /// After a product.
    static void check_length(const IntegerMultivariate& result);

private:
    void spend(double products);

    double spent_ = 0;
};

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/numbers/budget.hpp"

#include <cstdlib>

#include "generator/support/work.hpp"

namespace hvi::gen {

namespace {

/// Returns how much longer a product of two coefficients takes than one of single words.
double words(const IntegerMultivariate& a, const IntegerMultivariate& b) {
    constexpr double bits_of_a_word = 64;
    const auto bits = [](const IntegerMultivariate& polynomial) {
        return static_cast<double>(std::abs(fmpz_mpoly_max_bits(polynomial.get())));
    };
    return 1 + (bits(a) + bits(b)) / bits_of_a_word;
}

double length(const IntegerMultivariate& polynomial) {
    return static_cast<double>(polynomial.term_count());
}

}  // namespace

TooLarge::TooLarge()
    : MathError(
          "exact arithmetic gets too large: polynomials of more than " +
              std::to_string(Budget::most_terms) + " terms, or too many long ones",
          {},
          "choose simpler functions or nodes, or give parameters, where there are some, values "
          "with --param") {}

void Budget::spend(double products) {
    constexpr double units_of_product = 0.05;
    spend_work(units_of_product * products);
    // NOTE: a text and a short sum remain possible after all is spent.
    constexpr double always_there = 200;
    if (products <= always_there) { return; }
    spent_ += products;
    if (products > most_products_at_once || spent_ > most_products) { throw TooLarge(); }
}

void Budget::spend_on_product(const IntegerMultivariate& a, const IntegerMultivariate& b) {
    spend(length(a) * length(b) * words(a, b));
}

void Budget::spend_on_divisor(const IntegerMultivariate& a, const IntegerMultivariate& b) {
    constexpr double products_per_term = 50;  // as measured, where it is not found at once
    const bool at_once = a.term_count() <= 1 || b.term_count() <= 1;
    spend((length(a) + length(b)) * words(a, b) * (at_once ? 1 : products_per_term));
}

void Budget::check_length(const IntegerMultivariate& result) {
    if (result.term_count() > most_terms) { throw TooLarge(); }
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/parameters/near_zero.hpp"

namespace hvi::gen {

namespace {

constexpr Precision near_zero_bits = 512;

/// Adds coefficient * w^power at w = 2^at.
void add(Ball& sum, const Ball& coefficient, std::size_t power, int at) {
    Ball term = coefficient;
    arb_mul_2exp_si(term.get(), term.get(), at * static_cast<slong>(power));
    arb_add(sum.get(), sum.get(), term.get(), near_zero_bits);
}

}  // namespace

NearZero::NearZero(const EntireFunction& function, const EntireGenerators& generators)
    : sum_of_sizes_(function, generators, near_zero_bits, true) {
    const Ball zero;
    coefficients_ = EnclosedFunction(function, generators, near_zero_bits).at(zero, longest);
    majorant_ = sum_of_sizes_.at(zero, longest);
    while (order_ < longest && coefficients_.coefficient(order_).sign() == 0) { ++order_; }
    half_leading_ = absolute(coefficients_.coefficient(order_));
    arb_mul_2exp_si(half_leading_.get(), half_leading_.get(), -1);
}

bool NearZero::is_dominated(int at) const {
    Ball rest = majorant_from(longest, at);
    for (std::size_t j = order_ + 1; j < longest; ++j) {
        add(rest, absolute(coefficients_.coefficient(j)), j, at);
    }
    return is_below(rest, 0, at);
}

std::optional<std::size_t> NearZero::needed(int at) const {
    constexpr int remainder = -118;
    for (std::size_t length = order_ + 1; length <= longest; ++length) {
        if (is_below(majorant_from(length, at), remainder, at)) { return length; }
    }
    return std::nullopt;
}

/// Returns the sum at w = 2^at without the contribution of the first coefficients.
Ball NearZero::majorant_from(std::size_t first, int at) const {
    Ball point;
    arb_one(point.get());
    arb_mul_2exp_si(point.get(), point.get(), at);
    Ball rest = sum_of_sizes_.at(point, 1).coefficient(0);
    for (std::size_t j = 0; j < first; ++j) {
        Ball coefficient = majorant_.coefficient(j);
        arb_neg(coefficient.get(), coefficient.get());
        add(rest, coefficient, j, at);
    }
    return rest;
}

/// Returns whether a sum is below 2^exponent |leading w^order|/2 at w = 2^at.
bool NearZero::is_below(const Ball& sum, int exponent, int at) const {
    Ball bound = half_leading_;
    arb_mul_2exp_si(bound.get(), bound.get(), exponent + at * static_cast<slong>(order_));
    return arb_lt(sum.get(), bound.get()) != 0;
}

}  // namespace hvi::gen

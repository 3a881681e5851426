// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/zero.hpp"

#include <fmt/format.h>

#include <cmath>

#include "generator/exact/number_value.hpp"

namespace hvi::gen {

namespace {

constexpr Precision bits = 256;

Ball ball_of_double(double value) {
    Ball result;
    arb_set_d(result.get(), value);
    return result;
}

Ball value(const ExactTerm& term, const Ball& argument, Precision precision) {
    Ball result = enclosure(term.coefficient, precision);
    Ball factor;
    arb_pow_ui(factor.get(), argument.get(), term.power, precision);
    arb_mul(result.get(), result.get(), factor.get(), precision);
    arb_mul(factor.get(), enclosure(term.rate, precision).get(), argument.get(), precision);
    arb_exp(factor.get(), factor.get(), precision);
    arb_mul(result.get(), result.get(), factor.get(), precision);
    if (term.wave == ExactTerm::Wave::none) { return result; }
    arb_mul(factor.get(), enclosure(term.frequency, precision).get(), argument.get(), precision);
    (term.wave == ExactTerm::Wave::cos ? arb_cos : arb_sin)(factor.get(), factor.get(), precision);
    arb_mul(result.get(), result.get(), factor.get(), precision);
    return result;
}

}  // namespace

Ball enclosure(const ExactFunction& function, const Ball& argument, Precision precision) {
    Ball sum;
    for (const ExactTerm& term : function.terms()) {
        const Ball next = value(term, argument, precision);
        arb_add(sum.get(), sum.get(), next.get(), precision);
    }
    return sum;
}

std::optional<std::string> zero_in_unit_interval(const ExactFunction& function,
                                                 const Ground& ground) {
    constexpr int parts = 64;
    const auto sign = [&](double point) {
        return enclosure(function, ball_of_double(point), bits).sign();
    };
    for (const long end : {0L, 1L}) {
        if (function.at(Number(end), ground).known_zero() == true) { return std::to_string(end); }
    }
    double left = 0.0;
    for (int k = 1; k <= parts; ++k) {
        double right = static_cast<double>(k) / parts;
        if (const int s = sign(right); s == 0) { continue; }
        if (sign(left) * sign(right) < 0) {
            while (right - left > 1e-6) {
                const double middle = (left + right) / 2;
                (sign(middle) == sign(right) ? right : left) = middle;
            }
            return fmt::format("near {:.4f}", (left + right) / 2);
        }
        left = right;
    }
    return std::nullopt;
}

}  // namespace hvi::gen

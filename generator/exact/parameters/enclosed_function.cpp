// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/parameters/enclosed_function.hpp"

#include <algorithm>

#include "generator/exact/numbers/number_value.hpp"

namespace hvi::gen {

Ball absolute(Ball ball) {
    arb_abs(ball.get(), ball.get());
    return ball;
}

EnclosedFunction::EnclosedFunction(const EntireFunction& function,
                                   const EntireGenerators& generators, Precision bits,
                                   bool majorant)
    : bits_(bits), majorant_(majorant) {
    for (const Phase& phase : generators.phases) {
        phases_.emplace_back(phase.kind, part(enclosure(phase.rate, bits)));
    }
    std::vector<Ball> constants;
    for (const Number& constant : generators.constants) {
        constants.push_back(enclosure(constant, bits));
    }
    const std::size_t variables = generators.variables();
    most_.resize(variables);
    for (const EntireFunction::Term& term : function.terms) {
        Ball coefficient = enclosure(term.coefficient, bits);
        for (std::size_t k = 0; k < constants.size(); ++k) {
            Ball power;
            arb_pow_ui(power.get(), constants[k].get(), term.powers[generators.constant(k)], bits);
            arb_mul(coefficient.get(), coefficient.get(), power.get(), bits);
        }
        const auto end = term.powers.begin() + static_cast<long>(variables);
        const std::vector<unsigned> powers(term.powers.begin(), end);
        Ball& sum = terms_[powers];
        arb_add(sum.get(), sum.get(), part(coefficient).get(), bits);
        for (std::size_t v = 0; v < variables; ++v) { most_[v] = std::max(most_[v], powers[v]); }
    }
}

BallSeries EnclosedFunction::at(const Ball& point, std::size_t length) const {
    const auto count = static_cast<slong>(length);
    const Powers powers = powers_at(point, count);
    BallSeries sum;
    for (const auto& [exponents, coefficient] : terms_) {
        BallSeries product;
        arb_poly_set_arb(product.get(), coefficient.get());
        for (std::size_t v = 0; v < exponents.size(); ++v) {
            if (exponents[v] == 0) { continue; }
            const BallSeries& power = powers[v][exponents[v] - 1];
            arb_poly_mullow(product.get(), product.get(), power.get(), count, bits_);
        }
        arb_poly_add(sum.get(), sum.get(), product.get(), bits_);
    }
    return sum;
}

/// Returns scale * (point + t).
BallSeries EnclosedFunction::line(const Ball& scale, const Ball& point) const {
    Ball constant;
    arb_mul(constant.get(), scale.get(), point.get(), bits_);
    BallSeries result;
    arb_poly_set_coeff_arb(result.get(), 0, constant.get());
    arb_poly_set_coeff_arb(result.get(), 1, scale.get());
    return result;
}

/// Returns w and each x and y.
std::vector<BallSeries> EnclosedFunction::variables_at(const Ball& point, slong count) const {
    Ball one;
    arb_one(one.get());
    std::vector<BallSeries> variables{line(one, point)};
    for (const auto& [kind, rate] : phases_) {
        const BallSeries argument = line(rate, point);
        BallSeries& x = variables.emplace_back();
        BallSeries y;
        if (kind == Phase::Kind::exponential) {
            arb_poly_exp_series(x.get(), argument.get(), count, bits_);
            arb_poly_one(y.get());
        } else if (majorant_) {
            arb_poly_sinh_cosh_series(x.get(), y.get(), argument.get(), count, bits_);
        } else {
            arb_poly_sin_cos_series(x.get(), y.get(), argument.get(), count, bits_);
        }
        variables.push_back(std::move(y));
    }
    return variables;
}

/// Returns powers of w and of each x and y, from the first to the largest that occurs.
EnclosedFunction::Powers EnclosedFunction::powers_at(const Ball& point, slong count) const {
    const std::vector<BallSeries> variables = variables_at(point, count);
    Powers powers(variables.size());
    for (std::size_t v = 0; v < variables.size(); ++v) {
        for (unsigned k = 0; k < most_[v]; ++k) {
            BallSeries power = variables[v];
            if (k > 0) {
                arb_poly_mullow(power.get(), power.get(), powers[v].back().get(), count, bits_);
            }
            powers[v].push_back(std::move(power));
        }
    }
    return powers;
}

}  // namespace hvi::gen

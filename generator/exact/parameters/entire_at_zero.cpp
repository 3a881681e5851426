// Power series of entire functions at w = 0, exactly.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <map>
#include <utility>

#include "generator/exact/numbers/number_value.hpp"
#include "generator/exact/parameters/near_zero.hpp"

namespace hvi::gen {

namespace {

using NumberSeries = std::vector<Number>;

NumberSeries truncated_product(const NumberSeries& a, const NumberSeries& b) {
    NumberSeries result(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (is_exactly(a[i], 0)) { continue; }
        for (std::size_t j = 0; i + j < b.size(); ++j) {
            if (is_exactly(b[j], 0)) { continue; }
            result[i + j] = result[i + j] + a[i] * b[j];
        }
    }
    return result;
}

/// Returns rate^n/n!, with the signs and the gaps of sin (first = 1) and cos (first = 0), or of
/// exp.
NumberSeries phase_series(const Phase& phase, std::size_t first, std::size_t length) {
    NumberSeries result(length);
    Number term(1);
    for (std::size_t n = 0; n < length; ++n) {
        if (n > 0) { term = term * phase.rate / Number(static_cast<long>(n)); }
        if (phase.kind == Phase::Kind::exponential) {
            result[n] = term;
        } else if (n % 2 == first) {
            result[n] = (n / 2) % 2 == 0 ? term : -term;
        }
    }
    return result;
}

/// Returns the series of w and of the x and y of phases.
std::vector<NumberSeries> exact_series_of(const EntireGenerators& generators, std::size_t length) {
    NumberSeries w(length);
    if (length > 1) { w[1] = Number(1); }
    std::vector<NumberSeries> result{std::move(w)};
    for (const Phase& phase : generators.phases) {
        result.push_back(phase_series(phase, 1, length));
        if (phase.kind == Phase::Kind::angle) {
            result.push_back(phase_series(phase, 0, length));
        } else {
            result.push_back(NumberSeries(length));
            result.back().front() = Number(1);
        }
    }
    return result;
}

/// Returns the function as a polynomial in w and in the phases, with constants for coefficients.
std::map<std::vector<unsigned>, Number> without_constants(const EntireFunction& function,
                                                          const EntireGenerators& generators) {
    const std::size_t variables = generators.variables();
    std::map<std::vector<unsigned>, Number> result;
    for (const EntireFunction::Term& term : function.terms) {
        Number coefficient = term.coefficient;
        for (std::size_t k = 0; k < generators.constants.size(); ++k) {
            for (unsigned n = 0; n < term.powers[generators.constant(k)]; ++n) {
                coefficient = coefficient * generators.constants[k];
            }
        }
        const auto end = term.powers.begin() + static_cast<long>(variables);
        Number& sum = result[{term.powers.begin(), end}];
        sum = sum + coefficient;
    }
    return result;
}

}  // namespace

bool vanishes_at_zero(const EntireFunction& function, const EntireGenerators& generators,
                      std::size_t order) {
    if (order == 0) { return true; }
    const std::vector<NumberSeries> variables = exact_series_of(generators, order);
    std::vector<std::vector<NumberSeries>> powers_of(variables.size());
    NumberSeries sum(order);
    for (const auto& [powers, coefficient] : without_constants(function, generators)) {
        NumberSeries summand(order);
        summand.front() = coefficient;
        for (std::size_t v = 0; v < powers.size(); ++v) {
            auto& known = powers_of[v];
            if (known.empty()) { known.push_back(variables[v]); }
            while (known.size() < powers[v]) {
                known.push_back(truncated_product(known.back(), known.front()));
            }
            if (powers[v] > 0) { summand = truncated_product(summand, known[powers[v] - 1]); }
        }
        for (std::size_t j = 0; j < order; ++j) { sum[j] = sum[j] + summand[j]; }
    }
    return std::all_of(sum.begin(), sum.end(), [](const Number& c) { return c.is_zero(); });
}

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/parameters/parametric.hpp"

#include <algorithm>
#include <utility>

#include "generator/exact/parameters/entire_quotients.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

void set_orders(ParametricNumbers& numbers) {
    for (ParameterFunction& function : numbers.functions) {
        function.order = order_at_zero(function.function, numbers.generators);
    }
    const auto order = [&](const Quotient& quotient) {
        long result = numbers.functions[quotient.numerator].order;
        for (std::size_t k = 0; k < quotient.exponents.size(); ++k) {
            result -= static_cast<long>(quotient.exponents[k]) * numbers.functions[k].order;
        }
        return result;
    };
    for (const Quotient& weight : numbers.weights) {
        if (order(weight) > 0) { numbers.at_zero = Zero::weight; }
    }
    for (const auto* quotients : {&numbers.weights, &numbers.others}) {
        for (const Quotient& quotient : *quotients) {
            if (order(quotient) < 0) { numbers.at_zero = Zero::pole; }
        }
    }
}

/// Returns the zeros of x, of y, or of both of a phase, as a text.
std::string family(const Number& half_period, bool of_sines, bool of_cosines,
                   const std::string& parameter) {
    const auto text = [](const Number& number) { return to_text(*number.closed_form()); };
    const std::string w = parameter + " = ";
    if (of_sines && of_cosines) { return w + text(half_period) + "*k, k = +-1, +-2, ..."; }
    if (of_sines) { return w + text(Number(2) * half_period) + "*k, k = +-1, +-2, ..."; }
    return w + text(half_period) + "*k, k = +-1, +-3, ...";
}

void add_families(ParametricNumbers& numbers, const Number& pi) {
    const auto occurs = [&](std::size_t which) {
        return std::any_of(numbers.functions.begin(), numbers.functions.end(), [&](const auto& f) {
            return f.zero == Zero::pole && is_generator(f.function, which);
        });
    };
    for (std::size_t p = 0; p < numbers.generators.phases.size(); ++p) {
        const bool sines = occurs(EntireGenerators::x(p));
        const bool cosines = occurs(EntireGenerators::y(p));
        if (!sines && !cosines) { continue; }
        const Number half_period = pi / (Number(2) * numbers.generators.phases[p].rate);
        numbers.zeros.push_back(
            {Zero::pole, family(half_period, sines, cosines, numbers.parameter), {}});
    }
}

void add_places(ParametricNumbers& numbers, Zero zero) {
    ZeroPlaces found{zero, {}, {}};
    for (const ParameterFunction& function : numbers.functions) {
        bool by_family = false;
        for (std::size_t g = EntireGenerators::x(0); g < numbers.generators.variables(); ++g) {
            by_family = by_family || is_generator(function.function, g);
        }
        if (function.zero != zero || by_family) { continue; }
        const auto places =
            real_zeros(function.function, numbers.generators, ParametricNumbers::most_printed);
        found.places.insert(found.places.end(), places.begin(), places.end());
    }
    std::sort(found.places.begin(), found.places.end());
    if (!found.places.empty()) { numbers.zeros.push_back(std::move(found)); }
}

}  // namespace

bool operator==(const Quotient& left, const Quotient& right) {
    return left.numerator == right.numerator && left.exponents == right.exponents &&
           (left.divisor - right.divisor).is_zero();
}

ParametricNumbers parametric(const std::vector<Number>& weights,
                             const std::vector<Number>& others) {
    const Progress::Stage stage("looking at the coefficients near zeros of their denominators");
    std::vector<Number> all = weights;
    all.insert(all.end(), others.begin(), others.end());
    EntireQuotients quotients(all);
    const auto quotients_of = [&](const std::vector<Number>& numbers) {
        std::vector<Quotient> result;
        for (const Number& number : numbers) { result.push_back(quotients.add(number)); }
        return result;
    };
    std::vector<Quotient> first = quotients_of(weights);
    std::vector<Quotient> second = quotients_of(others);
    const Number pi = quotients.generators().pi();
    ParametricNumbers result = std::move(quotients).finish(std::move(first), std::move(second));
    set_orders(result);
    std::vector<EntireFunction> functions;
    for (const ParameterFunction& function : result.functions) {
        functions.push_back(function.function);
    }
    result.series = series_plan(functions, result.generators);
    add_families(result, pi);
    add_places(result, Zero::pole);
    add_places(result, Zero::weight);
    return result;
}

}  // namespace hvi::gen

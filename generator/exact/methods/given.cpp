// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/given.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "generator/exact/expressions/evaluate.hpp"
#include "generator/exact/numbers/rational.hpp"
#include "generator/exact/numbers/rounded.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

/// Replaces each coefficient by the result of `number`.
template <class ToNumber>
NodesAndMethod numbers(const Coefficients& coefficients, ToNumber to_number) {
    const auto vector = [&](const CoefficientVector& entries) {
        NumberVector result;
        for (const Coefficient& entry : entries) { result.push_back(to_number(entry)); }
        return result;
    };
    const auto matrix = [&](const CoefficientMatrix& rows) {
        NumberMatrix result;
        for (const CoefficientVector& row : rows) { result.push_back(vector(row)); }
        return result;
    };
    NodesAndMethod result;
    result.c = vector(coefficients.c);
    PartitionedMethod& method = result.method;
    method.b = vector(coefficients.b);
    method.b_tilde = coefficients.b_tilde ? vector(*coefficients.b_tilde) : method.b;
    method.A = matrix(coefficients.A);
    method.A_tilde = coefficients.A_tilde ? matrix(*coefficients.A_tilde) : method.A;
    return result;
}

/// Checks that a number is exact. NOTE: numbers with free parameters have no enclosures, and so no
/// sum with numbers that have nothing else.
void check_is_exact(const Number& value, const Coefficient& entry) {
    if (is_exact(value)) { return; }
    throw InputError("a tableau with a free parameter and with numbers that have no closed form is "
                     "not built yet",
                     Place{entry.source, {0, entry.source->text.size()}},
                     "give the parameter a value with --param");
}

/// Returns the spacing of doubles at the largest number, when the decimals may be doubles; see
/// unrounded().
std::optional<double> double_spacing(const GivenTableau& given) {
    if (given.digits > most_digits_of_double) { return std::nullopt; }
    double largest = 0;
    const auto look = [&](const NumberVector& numbers) {
        for (const Number& number : numbers) {
            largest = std::max(largest, std::abs(number.nearest_double()));
        }
    };
    const PartitionedMethod& method = given.written.method;
    for (const NumberVector* vector : {&given.written.c, &method.b, &method.b_tilde}) {
        look(*vector);
    }
    for (const NumberMatrix* matrix : {&method.A, &method.A_tilde}) {
        for (const NumberVector& row : *matrix) { look(row); }
    }
    return std::isfinite(largest) ? std::optional(spacing_at(largest)) : std::nullopt;
}

}  // namespace

GivenTableau given_tableau(const Coefficients& coefficients, Ground ground) {
    const Progress::Stage stage("reading the coefficients exactly");
    for (const Parameter& parameter : coefficients.parameters) {
        ground.set_parameter(parameter.name,
                             evaluate_number(parameter.value, parameter.source, ground));
    }
    GivenTableau result;
    result.written = numbers(coefficients, [&](const Coefficient& entry) {
        return evaluate_number(entry.value, entry.source, ground);
    });
    result.parameters = ground.free_parameters();
    if (!result.parameters.empty()) {
        for_each_coefficient(coefficients, [&](const Coefficient& entry) {
            check_is_exact(evaluate_number(entry.value, entry.source, ground), entry);
        });
    } else {
        for_each_coefficient(coefficients, [&](const Coefficient& entry) {
            if (!entry.rounded) { return; }
            ++result.rounded;
            result.digits = std::max(result.digits, entry.rounded->significant);
        });
    }
    result.bits = bits_for(result.digits);
    result.enclosed = result.written;
    if (result.rounded == 0) { return result; }
    const auto spacing = double_spacing(result);
    result.enclosed = numbers(coefficients, [&](const Coefficient& entry) {
        const Number written = evaluate_number(entry.value, entry.source, ground);
        return entry.rounded ? unrounded(written, *entry.rounded, spacing) : written;
    });
    return result;
}

}  // namespace hvi::gen

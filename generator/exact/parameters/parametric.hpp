// Coefficients that depend on a free parameter w, as quotients of entire functions of w.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "generator/exact/numbers/number.hpp"
#include "generator/exact/parameters/entire.hpp"

namespace hvi::gen {

/// Effect of a function's zero on the method.
enum class Zero {
    harmless,  ///< there is none, or the method goes on there
    pole,      ///< a coefficient is infinite
    weight,    ///< a weight is zero
};

struct ParameterFunction {
    EntireFunction function;
    Zero zero = Zero::harmless;
    unsigned order = 0;  ///< order to which it vanishes at w = 0
};

/// A quotient functions[numerator] / (divisor * product of functions[k]^exponents[k] over the first
/// functions).
struct Quotient {
    std::size_t numerator = 0;
    Number divisor;  ///< an integer
    std::vector<unsigned> exponents;

    friend bool operator==(const Quotient& left, const Quotient& right);
};

/// Zeros of functions that are not harmless, for people.
struct ZeroPlaces {
    Zero zero = Zero::pole;
    std::string family;          ///< `w = 3*pi*k, k = +-1, +-2, ...`, or empty
    std::vector<double> places;  ///< up to ParametricNumbers::most_printed in size, with six digits
};

struct ParametricNumbers {
    static constexpr double most_printed = 32;

    std::string parameter;  ///< the name of w
    EntireGenerators generators;
    std::vector<ParameterFunction> functions;  ///< functions in denominators come first
    SeriesPlan series{};
    Zero at_zero = Zero::harmless;  ///< kind of w = 0
    std::vector<ZeroPlaces> zeros;  ///< zeros except w = 0
    std::vector<Quotient> weights;
    std::vector<Quotient> others;
};

/// Returns numbers with one free parameter in a form that can be evaluated without loss of digits;
/// `weights` must not be zero. The quotients are in lowest terms: numerator and denominator have no
/// common divisor as polynomials in w and in the tangents of the angles, over Q and its constants.
/// By Lindemann's theorem then a zero of a denominator that is a polynomial in one tangent over Q
/// is no zero of the numerator, except w = 0.
///
/// Throws InputError for more than one parameter, and for one that stands elsewhere than in w, in
/// sin and cos of constant multiples of w, and in exp of them. Preconditions: none of the numbers
/// is zero; at least one depends on a parameter.
[[nodiscard]] ParametricNumbers parametric(const std::vector<Number>& weights,
                                           const std::vector<Number>& others);

}  // namespace hvi::gen

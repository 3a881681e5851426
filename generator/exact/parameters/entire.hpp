// Entire functions of a free parameter, whose quotients are the coefficients that depend on it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "generator/exact/numbers/number.hpp"

namespace hvi::gen {

/// Two functions of w that occur together: x = sin(rate w) and y = cos(rate w), or x and y with x/y
/// = exp(rate w). Polynomials that are homogeneous in x and y have no common divisor that their
/// quotient does not show, even at tan(rate w) = infinity. And polynomials in exponentials do not
/// overflow when the larger one of x and y is 1.
struct Phase {
    enum class Kind { angle, exponential };
    Kind kind = Kind::angle;
    Number rate;      ///< without the parameter, not zero
    Number argument;  ///< rate w
};

/// The generators of polynomial functions, in the order of EntireFunction::Term::powers: w, then x
/// and y of each phase, then constants such as pi.
struct EntireGenerators {
    std::vector<Phase> phases;
    std::vector<Number> constants;

    [[nodiscard]] static std::size_t w() { return 0; }
    [[nodiscard]] static std::size_t x(std::size_t phase) { return 1 + 2 * phase; }
    [[nodiscard]] static std::size_t y(std::size_t phase) { return 2 + 2 * phase; }
    /// Returns how many generators are not constant: the first ones.
    [[nodiscard]] std::size_t variables() const { return 1 + 2 * phases.size(); }
    [[nodiscard]] std::size_t constant(std::size_t index) const { return variables() + index; }
    [[nodiscard]] std::size_t count() const { return variables() + constants.size(); }
};

/// A polynomial over Z in the generators, homogeneous in the x and y of each phase.
struct EntireFunction {
    struct Term {
        Number coefficient;            ///< an integer
        std::vector<unsigned> powers;  ///< of each generator
    };
    std::vector<Term> terms;
};

/// Returns whether a function is one of the generators, but for a constant factor.
[[nodiscard]] bool is_generator(const EntireFunction& function, std::size_t which);

/// Returns the order to which a function vanishes at w = 0: lower coefficients of its power series
/// are proved to be zero, and the one of that order not to be. Throws MathError where it is above
/// 60.
[[nodiscard]] unsigned order_at_zero(const EntireFunction& function,
                                     const EntireGenerators& generators);

/// Plan of the program that evaluates these functions in arithmetic of twice the digits: by series
/// of `length` terms for |w| <= 2^switch_exponent, else as they are written. No function then loses
/// more than 2^lost_bits of its relative precision to cancellation on [0, 2 switch], and the rest
/// of each series is less than 2^-118 of the function.
struct SeriesPlan {
    int switch_exponent;
    std::size_t length;
    static constexpr int lost_bits = 40;
};

/// Returns a plan, chosen by bounds on the sums of absolute values of all terms. Throws MathError
/// where there is no such choice. Precondition: no function is identically zero.
[[nodiscard]] SeriesPlan series_plan(const std::vector<EntireFunction>& functions,
                                     const EntireGenerators& generators);

/// Returns the real zeros with 0 < |w| <= most, ascending. NOTE: a zero is proved by a change of
/// sign; where the function touches zero, or comes too near to tell, the place is listed as well.
[[nodiscard]] std::vector<double> real_zeros(const EntireFunction& function,
                                             const EntireGenerators& generators, double most);

}  // namespace hvi::gen

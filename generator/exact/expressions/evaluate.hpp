// Evaluation of expressions as exact numbers and functions of tau.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <memory>

#include "generator/exact/functions/domain.hpp"
#include "generator/exact/functions/function.hpp"
#include "generator/exact/numbers/ground.hpp"

namespace hvi::gen {

/// Properties of a method that its functions depend on.
struct Setting {
    std::optional<Domain> domain = Domain{};  ///< empty where it is not known
    std::map<long, long> splines;  ///< the number of B-splines of a degree, see spline.hpp
};

/// Returns the expression as a function of tau. Throws, with the place: DivisionByZero; InputError
/// for numbers and powers of a size that no method needs, and for features to come; MathError where
/// a value is not real, and for a singularity, which it names, that is not integrable.
[[nodiscard]] ExactFunction evaluate_function(const Expression& expression,
                                              const std::shared_ptr<const Source>& source,
                                              const Ground& ground, const Setting& setting = {});

/// Returns the expression as a number. Throws as evaluate_function does, and InputError when tau
/// occurs.
[[nodiscard]] Number evaluate_number(const Expression& expression,
                                     const std::shared_ptr<const Source>& source,
                                     const Ground& ground);

/// Checks the numbers in an expression, the largest subexpressions that are numbers, and refuses
/// them where they are not real, not defined or too large. Throws as evaluate_number() does.
void check_numbers(const Expression& expression, const std::shared_ptr<const Source>& source);

/// Returns whether an expression is proved to be zero, with all its symbols free. NOTE: the exact
/// arithmetic refuses expressions that it has no place for, and a no is no proof of the contrary.
[[nodiscard]] bool is_proved_zero(const Expression& expression);

}  // namespace hvi::gen

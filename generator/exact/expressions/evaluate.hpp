// From what the user wrote to what it means: exact numbers and functions of tau.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <memory>

#include "generator/exact/functions/domain.hpp"
#include "generator/exact/functions/function.hpp"
#include "generator/exact/numbers/ground.hpp"

namespace hvi::gen {

/// What a function must know of the method it belongs to.
struct Setting {
    std::optional<Domain> domain = Domain{};  ///< empty where it is not known
    std::map<long, long> splines;  ///< the number of B-splines of a degree, see spline.hpp
};

/// The expression as a function of tau. Throws, with the place: DivisionByZero; InputError for
/// numbers and powers of a size that no method needs, and for what is to come; MathError where a
/// value is not real, and for a singularity, which it names, that is not integrable.
[[nodiscard]] ExactFunction evaluate_function(const Expression& expression,
                                              const std::shared_ptr<const Source>& source,
                                              const Ground& ground, const Setting& setting = {});

/// The expression as a number. Throws as evaluate_function does, and InputError when tau occurs.
[[nodiscard]] Number evaluate_number(const Expression& expression,
                                     const std::shared_ptr<const Source>& source,
                                     const Ground& ground);

/// Refuses the numbers that are parts of an expression, as large ones as there are, where they are
/// not real, not defined or too large. Throws as evaluate_number() does.
void check_numbers(const Expression& expression, const std::shared_ptr<const Source>& source);

/// Whether it is proved to be zero, with all its symbols free. NOTE: the exact arithmetic refuses
/// what it has no place for, and a no is no proof of the contrary.
[[nodiscard]] bool is_proved_zero(const Expression& expression);

}  // namespace hvi::gen

// From what the user wrote to what it means: exact numbers and functions of tau.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>

#include "generator/exact/function.hpp"
#include "generator/exact/ground.hpp"

namespace hvi::gen {

/// The expression as a function of tau. Throws InputError with its place for a division by zero,
/// for numbers and powers of a size that no method needs, and for functions outside the class of
/// function.hpp, which are to come; MathError with its place where a value is not real.
[[nodiscard]] ExactFunction evaluate_function(const Expression& expression,
                                              const std::shared_ptr<const Source>& source,
                                              const Ground& ground);

/// The expression as a number. Throws as evaluate_function does, and InputError when tau occurs.
[[nodiscard]] Number evaluate_number(const Expression& expression,
                                     const std::shared_ptr<const Source>& source,
                                     const Ground& ground);

}  // namespace hvi::gen

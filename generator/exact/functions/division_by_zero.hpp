// Error for a number that is written as a division by zero.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/support/error.hpp"

namespace hvi::gen {

/// Error for a division by zero. As an item of a list it is no number, and cannot be read. Callers
/// that give a value to something else may treat it as a mathematical error.
class DivisionByZero : public InputError {
public:
    explicit DivisionByZero(std::optional<Place> place = {})
        : InputError("division by zero", std::move(place)) {}
};

}  // namespace hvi::gen

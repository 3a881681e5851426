// A number that is written as a division by zero.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/support/error.hpp"

namespace hvi::gen {

/// Such an item of a list is no number, and cannot be read. What gives a value to something else
/// may take it for mathematics, which forbids it.
class DivisionByZero : public InputError {
public:
    explicit DivisionByZero(std::optional<Place> place = {})
        : InputError("division by zero", std::move(place)) {}
};

}  // namespace hvi::gen

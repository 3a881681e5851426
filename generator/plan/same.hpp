// When two coefficients are the same for a stepper.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/number.hpp"

namespace hvi::gen {

/// Equal, by proof where the difference has a closed form; where a number is known by an enclosure
/// alone, equal to 40 digits. NOTE: a coefficient in doubles does not know the difference, and a
/// proof that there is none cannot be had from enclosures, however long they are refined.
[[nodiscard]] bool same(const Number& a, const Number& b);

}  // namespace hvi::gen

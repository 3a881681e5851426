// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ir/equal.hpp"

namespace hvi::gen {

bool equal(const Number& a, const Number& b) { return (a - b).known_zero() == true; }

bool differ(const Number& a, const Number& b) { return (a - b).known_zero() == false; }

}  // namespace hvi::gen

// Values of a parameter at which several numbers are zero at once.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/exact/algebra/number_vector.hpp"

namespace hvi::gen {

struct CommonZeros {
    std::string parameter;  ///< its name
    NumberVector values;
};

/// Returns the real values of the parameter at which all of these numbers vanish, ascending: the
/// real roots of the greatest common divisor of their numerators. Empty where a number is no
/// rational function over Q of one parameter, the same for all. Precondition: not all of them are
/// zero.
[[nodiscard]] std::optional<CommonZeros> common_zeros(const std::vector<Number>& functions);

}  // namespace hvi::gen

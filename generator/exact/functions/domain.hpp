// The interval on which the functions of a basis must be defined.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/exact/numbers/ground.hpp"

namespace hvi::gen {

/// Hull of [0, 1] and the nodes: the integrals over [0, c_i] run there.
struct Domain {
    Number low = 0;
    Number high = 1;

    [[nodiscard]] Number middle() const { return (low + high) / Number(2); }
    [[nodiscard]] std::string text() const;  ///< `[0, 1]`
};

/// Returns the domain. Empty when a node has a free parameter.
[[nodiscard]] std::optional<Domain> domain_of(const std::vector<Number>& nodes);

/// Returns a point in words: `at tau = 1/3`, `at tau = sqrt(2)/2`, or `near tau = 0.3090` where
/// there is no closed form, or a long one.
[[nodiscard]] std::string at_tau(const Number& point);

}  // namespace hvi::gen

// The generating function of type II of a step for a quadratic Hamiltonian.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/linear/one_step_map.hpp"

namespace hvi::gen {

/// H_d^+ as functions of x = (q_0, p_1).
struct GeneratingFunction {
    QuadraticForm discrete;  ///< H_d^+ of (4.19), by its definition: from the stages
    /// The exact discrete Hamiltonian (4.1), where it has a closed form in our field.
    std::optional<QuadraticForm> exact;
    /// That q_1 = D_2 H_d^+ and p_0 = D_1 H_d^+ (3.10) are the method's map.
    bool gives_map = false;
    /// The largest k with H_d^+ - H_d,exact^+ = O(h^k) as far as powers of h were compared, and
    /// whether the power h^k is there.
    int order_of_difference = 0;
    bool is_at_least = false;
};

[[nodiscard]] GeneratingFunction generating_function(const Tableau& tableau, const QuadraticForm& H,
                                                     const Ground& ground);

}  // namespace hvi::gen

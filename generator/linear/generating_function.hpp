// The generating function of type II of a step for a quadratic Hamiltonian.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/linear/one_step_map.hpp"

namespace hvi::gen {

/// H_d^+ as functions of x = (q_0, p_1).
struct GeneratingFunction {
    QuadraticForm discrete;  ///< H_d^+ of (4.2), (4.19), by its definition: from the stages
    /// The exact discrete Hamiltonian (4.1), where its closed form is known (see
    /// exact_discrete_hamiltonian).
    std::optional<QuadraticForm> exact;
    /// Whether the method has a generating function at all: its (p_0, q_1) as functions of (q_0,
    /// p_1) have a symmetric Jacobian, as the second derivatives of any function are.
    bool is_symmetric = false;
    /// Whether D_1 H_d^+ and D_2 H_d^+ are these p_0 and q_1 (3.10).
    bool gives_map = false;
    /// The largest k with H_d^+ - H_d,exact^+ = O(h^k), by exact Taylor coefficients; r + 1 or more
    /// for a method of order r. With `is_at_least` all compared coefficients agree, and k may be
    /// larger.
    int order_of_difference = 0;
    bool is_at_least = false;
    /// Whether dq_1/dp_0 at fixed q_0 is regular but for single h, so that there also is a
    /// generating function of type I, of (q_0, q_1). There is none for H = q p.
    bool has_type_one = false;
};

/// Returns the generating function. Preconditions and errors as for one_step_map.
[[nodiscard]] GeneratingFunction generating_function(const Tableau& tableau, const QuadraticForm& H,
                                                     const Ground& ground);
[[nodiscard]] GeneratingFunction generating_function(const GalerkinRule& rule,
                                                     const QuadraticForm& H, const Ground& ground);

}  // namespace hvi::gen

// Functions of q and p under the motion of H: whether they are conserved, and which methods may
// keep them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "generator/hamiltonian/zero.hpp"
#include "generator/read/lagrangian.hpp"

namespace hvi::gen {

/// A function of the variables of H. It stands in `source`, or in no text where that is null.
struct Quantity {
    Expression expression;
    std::shared_ptr<const Source> source;
};

/// The findings about a function I beside H.
struct QuantityFinding {
    Vanishing conserved = Vanishing::unknown;  ///< whether {I, H} vanishes
    Expression bracket;  ///< {I, H} = I_q H_p - I_p H_q; 0 where it is seen to vanish

    /// The quadratic term in q and p of an I that is a polynomial of degree 2.
    struct Quadratic {
        bool is_linear = true;
        bool has_squares = false;   ///< q_i q_j or p_i p_j
        bool squares_stay = false;  ///< p^T S p with S H_q = 0, and q^T R q with R H_p = 0
    };
    std::optional<Quadratic> quadratic;
    /// Whether I = p (C q + d), up to a constant.
    bool is_momentum_map = false;
    /// The conserved quantities before this one of which I is a polynomial of degree 2.
    std::vector<std::size_t> made_of;
};

/// Returns the findings for each quantity. Parameters stay symbols if the bracket vanishes for all
/// their values; else they have their values in H, all of which `hamiltonian` has. Throws as
/// Algebra does.
[[nodiscard]] std::vector<QuantityFinding> findings(const Hamiltonian& hamiltonian,
                                                    const std::vector<Quantity>& quantities);

/// Whether L is seen to be a polynomial of degree 2 in q and v; then H is one in q and p.
[[nodiscard]] bool is_quadratic(const Lagrangian& lagrangian);

/// Whether one quantity is seen to be a multiple of the other, up to a constant.
[[nodiscard]] bool are_proportional(const Hamiltonian& hamiltonian, const Quantity& first,
                                    const Quantity& second);
[[nodiscard]] bool are_proportional(const Lagrangian& lagrangian, const Quantity& first,
                                    const Quantity& second);

}  // namespace hvi::gen

// What functions of q and p do under the motion of H, and which steps of a method can see it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "generator/hamiltonian/zero.hpp"
#include "generator/read/lagrangian.hpp"

namespace hvi::gen {

/// A function of the variables of H, which stands in `source`, or nowhere where that is null.
struct Quantity {
    Expression expression;
    std::shared_ptr<const Source> source;
};

/// What is known of a function I beside H.
struct QuantityFinding {
    Vanishing conserved = Vanishing::unknown;  ///< whether {I, H} vanishes
    Expression bracket;                        ///< {I, H} = I_q H_p - I_p H_q; 0 where that is seen

    /// The term of I that is quadratic in q and p, where I is such a polynomial.
    struct Quadratic {
        bool is_linear = true;
        bool has_squares = false;   ///< q_i q_j or p_i p_j
        bool squares_stay = false;  ///< p^T S p with S H_q = 0, and q^T R q with R H_p = 0
    };
    std::optional<Quadratic> quadratic;
    /// I = p (C q + d), and perhaps a constant.
    bool is_momentum_map = false;
    /// Of which of those before it and that are conserved it is a polynomial of degree 2.
    std::vector<std::size_t> made_of;
};

/// Of each. Parameters are symbols where the bracket vanishes so, else they have the values that
/// they have in H, all of which its record has. Throws as Algebra does.
[[nodiscard]] std::vector<QuantityFinding> findings(const Hamiltonian& hamiltonian,
                                                    const std::vector<Quantity>& quantities);

/// Whether L is seen to be a polynomial of degree 2 in q and v; then H is one in q and p.
[[nodiscard]] bool is_quadratic(const Lagrangian& lagrangian);

/// Whether one is seen to be a multiple of the other, up to a constant.
[[nodiscard]] bool are_proportional(const Hamiltonian& hamiltonian, const Quantity& first,
                                    const Quantity& second);
[[nodiscard]] bool are_proportional(const Lagrangian& lagrangian, const Quantity& first,
                                    const Quantity& second);

}  // namespace hvi::gen

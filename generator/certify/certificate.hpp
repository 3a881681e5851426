// What a method can do, each property with its evidence.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/exact/order.hpp"
#include "generator/exact/oscillator.hpp"
#include "generator/exact/properties.hpp"
#include "generator/exact/stability.hpp"
#include "generator/exact/tableau.hpp"

namespace hvi::gen {

struct Certificate {
    std::string name;                     ///< `gauss:2`, or empty for one given by basis and nodes
    std::string origin;                   ///< the METHOD as the command line has it
    std::vector<std::string> parameters;  ///< free symbols, sorted
    std::size_t stages = 0;

    Verdict symplectic;
    Verdict symmetric;    ///< self-adjoint
    Verdict runge_kutta;  ///< A == A~
    Orders orders;
    bool explicit_separable = false;            ///< no stage equations for H = T(p) + U(q)
    bool explicit_general = false;              ///< nor for any other H
    std::vector<std::size_t> negative_weights;  ///< 1-based; empty with a free parameter
    std::vector<std::size_t> nodes_outside;     ///< of [0, 1]; the same

    OscillatorMap oscillator;
    std::optional<LinearStability> stability;  ///< empty with a free parameter

    /// The condition of order 1, the sum of the weights.
    [[nodiscard]] bool is_consistent() const { return orders.general.order >= 1; }
    /// q^T C p with constant C: Hairer, Lubich & Wanner, Geometric Numerical Integration, Theorem
    /// IV.2.4, whose condition is that of symplecticity.
    [[nodiscard]] bool conserves_qCp() const { return symplectic.holds; }
    /// All quadratic invariants: Theorem IV.2.2.
    [[nodiscard]] bool conserves_quadratic() const { return symplectic.holds && runge_kutta.holds; }
    /// Whether no decision rests on an enclosure of zero.
    [[nodiscard]] bool is_proved() const;
};

/// The largest z = h omega up to which linear stability is looked at.
inline constexpr long stability_limit = 20;

/// Everything by computation from the coefficients, whatever they are said to be. Preconditions as
/// for orders().
[[nodiscard]] Certificate certify(const Tableau& tableau, int max_order);

}  // namespace hvi::gen

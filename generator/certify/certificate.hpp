// The properties of a method, each with its evidence.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/certify/exceptions.hpp"
#include "generator/exact/methods/given.hpp"
#include "generator/exact/methods/order.hpp"
#include "generator/exact/methods/oscillator.hpp"
#include "generator/exact/methods/properties.hpp"
#include "generator/exact/methods/stability.hpp"
#include "generator/exact/methods/tableau.hpp"
#include "generator/stages/stage_node.hpp"

namespace hvi::gen {

/// The properties that the conditions on the coefficients decide.
struct Properties {
    Verdict symplectic;
    Verdict symmetric;       ///< self-adjoint
    Verdict runge_kutta;     ///< A == A~
    Verdict common_weights;  ///< b == b~
    Orders orders;

    /// Whether the condition of order 1 holds, the sum of the weights.
    [[nodiscard]] bool is_consistent() const { return orders.general.order >= 1; }
    /// Whether q^T C p with constant C is conserved: Hairer, Lubich & Wanner, Geometric Numerical
    /// Integration, Theorem IV.2.4, whose condition is symplecticity.
    [[nodiscard]] bool conserves_qCp() const { return symplectic.holds; }
    /// Whether all quadratic invariants are conserved: Theorem IV.2.2.
    [[nodiscard]] bool conserves_quadratic() const { return symplectic.holds && runge_kutta.holds; }
    /// Whether no decision rests on an enclosure of zero.
    [[nodiscard]] bool is_proved() const;
};

/// The findings about any method.
struct Findings {
    std::string name;                     ///< `gauss:2`, or empty for one given by basis and nodes
    std::string origin;                   ///< METHOD on the command line
    std::vector<std::string> parameters;  ///< free symbols, sorted
    std::size_t stages = 0;
    /// Whether only some digits of the coefficients are known. Then a property holds for some of
    /// the possible numbers, and is not proved; one that fails, fails for all of them.
    bool within_digits = false;
    std::vector<std::size_t> negative_weights;  ///< 1-based; empty with a free parameter
    std::vector<std::size_t> nodes_outside;     ///< outside of [0, 1]; likewise

    /// Empty where only some digits are known, and for coefficients for which it takes_long().
    std::optional<OscillatorMap> oscillator;
    std::optional<LinearStability> stability;  ///< likewise, also with a free parameter

    /// Whether these findings are proved.
    [[nodiscard]] bool is_proved() const;
};

/// The certificate of a tableau.
struct Certificate : Findings, Properties {
    std::vector<std::string> known_as;         ///< named methods with this tableau
    std::vector<std::string> adjoint;          ///< named methods with its adjoint
    std::vector<ExceptionalValue> exceptions;  ///< values of a parameter with a higher order
    std::vector<std::size_t> splitting;        ///< orders of a splitting: see splitting_orders()

    /// The stage values that are solved for together, for H = T(p) + U(q) and for any H.
    std::vector<std::vector<StageNode>> coupled_separable, coupled_general;

    [[nodiscard]] bool is_proved() const;
};

/// The largest z = h omega for which linear stability is computed.
inline constexpr long stability_limit = 20;

/// Computes everything from the coefficients, whatever their origin; only the names, also of the
/// adjoint, are those of methods with these nodes. Preconditions as for orders().
[[nodiscard]] Certificate certify(const Tableau& tableau, int max_order);

/// Certifies coefficients of another source; name and origin are left empty.
[[nodiscard]] Certificate certify(const NodesAndMethod& given,
                                  const std::vector<std::string>& parameters, int max_order);

/// Certifies coefficients within the given digits.
[[nodiscard]] Certificate certify_within_digits(const GivenTableau& given, int max_order);

/// Decides the conditions alone.
[[nodiscard]] Properties properties(const PartitionedMethod& method, int max_order);

/// Sets weights below zero, nodes outside of [0, 1], and stages that need no solver.
void set_signs(Certificate& certificate, const NodesAndMethod& given);

/// Sets the weights below zero and nodes outside of [0, 1] of c and b, which both variables share.
void set_signs(Findings& findings, const NumberVector& c, const NumberVector& b);

/// Sets the map of the oscillator and its stable intervals; sets nothing where the map is too long.
void set_oscillator(Findings& findings, const GalerkinRule& rule);

}  // namespace hvi::gen

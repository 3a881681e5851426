// What a method can do, each property with its evidence.
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

/// What the conditions on the coefficients decide.
struct Properties {
    Verdict symplectic;
    Verdict symmetric;       ///< self-adjoint
    Verdict runge_kutta;     ///< A == A~
    Verdict common_weights;  ///< b == b~
    Orders orders;

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

/// What there is to say of every method.
struct Findings {
    std::string name;                     ///< `gauss:2`, or empty for one given by basis and nodes
    std::string origin;                   ///< the METHOD as the command line has it
    std::vector<std::string> parameters;  ///< free symbols, sorted
    std::size_t stages = 0;
    /// Of coefficients only some digits are known: what is said to hold does so for some of the
    /// numbers that they can be, and is not proved; what fails, fails for all of them.
    bool within_digits = false;
    std::vector<std::size_t> negative_weights;  ///< 1-based; empty with a free parameter
    std::vector<std::size_t> nodes_outside;     ///< of [0, 1]; the same

    /// Empty where only some digits are known, and for coefficients so long that it takes_long().
    std::optional<OscillatorMap> oscillator;
    std::optional<LinearStability> stability;  ///< the same; empty also with a free parameter

    /// Of what stands here.
    [[nodiscard]] bool is_proved() const;
};

/// Of a tableau.
struct Certificate : Findings, Properties {
    std::vector<std::string> known_as;         ///< the named methods that it is
    std::vector<std::string> adjoint;          ///< those that its adjoint is
    std::vector<ExceptionalValue> exceptions;  ///< of a parameter: where the order is higher

    /// The stage values that are solved for at once for H = T(p) + U(q), and for any H.
    std::vector<std::vector<StageNode>> coupled_separable, coupled_general;

    [[nodiscard]] bool is_proved() const;
};

/// The largest z = h omega up to which linear stability is looked at.
inline constexpr long stability_limit = 20;

/// Everything by computation from the coefficients, whatever they are said to be; but for its names
/// and those of the adjoint, which are those of methods with the same nodes. Preconditions as for
/// orders().
[[nodiscard]] Certificate certify(const Tableau& tableau, int max_order);

/// The same for coefficients that came from elsewhere; name and origin are left empty.
[[nodiscard]] Certificate certify(const NodesAndMethod& given,
                                  const std::vector<std::string>& parameters, int max_order);

/// The same within the digits that are given.
[[nodiscard]] Certificate certify_within_digits(const GivenTableau& given, int max_order);

/// The conditions alone.
[[nodiscard]] Properties properties(const PartitionedMethod& method, int max_order);

/// Weights below zero, nodes outside of [0, 1], stages that need no solver.
void set_signs(Certificate& certificate, const NodesAndMethod& given);

/// Those of c and b, the same for both variables.
void set_signs(Findings& findings, const NumberVector& c, const NumberVector& b);

/// The map of the oscillator and where it is stable; nothing where the map is too long.
void set_oscillator(Findings& findings, const GalerkinRule& rule);

}  // namespace hvi::gen

// A method's map of the harmonic oscillator.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/algebra/polynomial_quotient.hpp"
#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/exact/methods/number_stages.hpp"

namespace hvi::gen {

struct Composition;

/// One step of the method (4.18) for H = (p^2 + omega^2 q^2)/2 with z = h omega takes
/// x = (omega q, p) to 1/D (m11 m12; m21 m22) x. D, m11 and m22 are even in z, m12 and m21 odd.
struct OscillatorMap {
    NumberVector m11, m12, m21, m22;  ///< polynomials in z, lowest coefficient first
    NumberVector D;                   ///< D(0) = 1
    /// Half the trace, which decides on stability. Its denominator is 1 at z = 0 as well.
    PolynomialQuotient half_trace;
    /// Whether the map is symplectic: its determinant is 1, m11 m22 - m12 m21 = D^2.
    Verdict determinant_one;
    /// Whether no enclosure was taken for zero. Then there is no divisor that all five, or the two
    /// of half_trace, have in common; but with free parameters none is looked for.
    bool proved = false;
};

/// Precondition: with free parameters, it does not take long.
[[nodiscard]] OscillatorMap oscillator_map(const Tableau& tableau);

/// The same for any coefficients: with weights b~ of its own, p1 takes these.
[[nodiscard]] OscillatorMap oscillator_map(const PartitionedMethod& method);

/// That of the general Galerkin form.
[[nodiscard]] OscillatorMap oscillator_map(const GalerkinRule& rule);

/// That of steps of a method in a row, whose z are gamma_1 z, gamma_2 z, ...: as exact as the map
/// of the method. Precondition: this has determinant 1.
[[nodiscard]] OscillatorMap composed(const OscillatorMap& method, const Composition& composition);

/// Whether this map, or linear stability by it, is a matter of minutes.
[[nodiscard]] bool takes_long(const PartitionedMethod& method);

/// The same of the general Galerkin form.
[[nodiscard]] bool takes_long(const GalerkinRule& rule);

/// Whether a method has free parameters, and a map of so many terms that it takes minutes.
[[nodiscard]] bool takes_long(const Tableau& tableau);

}  // namespace hvi::gen

// A method's map of the harmonic oscillator.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/algebra/polynomial_quotient.hpp"
#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/exact/methods/number_stages.hpp"

namespace hvi::gen {

struct Composition;
struct EvenMap;

/// Map of one step of the method (4.18) for H = (p^2 + omega^2 q^2)/2 with z = h omega. It takes x
/// = (omega q, p) to 1/D (m11 m12; m21 m22) x. D, m11 and m22 are even in z, m12 and m21 odd.
struct OscillatorMap {
    NumberVector m11, m12, m21, m22;  ///< polynomials in z, lowest coefficient first
    NumberVector D;                   ///< D(0) = 1
    /// Half the trace, which decides on stability. Its denominator is 1 at z = 0 as well.
    PolynomialQuotient half_trace;
    /// Whether the map is symplectic: its determinant is 1, m11 m22 - m12 m21 = D^2.
    Verdict determinant_one;
    /// Whether no enclosure was taken for zero. Then all five, and the two of half_trace, have no
    /// common divisor; but with free parameters none is looked for.
    bool proved = false;
};

/// Returns the map of a tableau. Precondition: with free parameters, it does not take long.
[[nodiscard]] OscillatorMap oscillator_map(const Tableau& tableau);

/// Returns the map of any coefficients: p1 takes the weights b~.
[[nodiscard]] OscillatorMap oscillator_map(const PartitionedMethod& method);

/// Returns the map of the general Galerkin form.
[[nodiscard]] OscillatorMap oscillator_map(const GalerkinRule& rule);

/// Returns the map that has these polynomials in t = z^2.
[[nodiscard]] OscillatorMap oscillator_map(EvenMap map);

/// Returns the map of steps of a method in a row, with gamma_1 z, gamma_2 z, ... for z. It is as
/// exact as the map of the method. Precondition: that map has determinant 1.
[[nodiscard]] OscillatorMap composed(const OscillatorMap& method, const Composition& composition);

/// Returns whether this map, or linear stability by it, takes minutes.
[[nodiscard]] bool takes_long(const PartitionedMethod& method);

/// Returns whether the map of the general Galerkin form takes minutes.
[[nodiscard]] bool takes_long(const GalerkinRule& rule);

/// Returns whether a method has free parameters, and a map of so many terms that it takes minutes.
[[nodiscard]] bool takes_long(const Tableau& tableau);

}  // namespace hvi::gen

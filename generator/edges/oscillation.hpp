// Orbits of a method by the exact map of the harmonic oscillator.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/exact/methods/composed_method.hpp"
#include "generator/exact/methods/stability.hpp"

namespace hvi::gen {

/// Facts about a method on the oscillator, computed from its exact coefficients.
struct KnownOscillator {
    std::string method;
    OscillatorMap map;
    LinearStability stability;
    PartitionedMethod stages;
    /// The factor by which fixed-point iteration for positions multiplies errors, divided by z^2:
    /// the spectral radius of A A~. A composition's steps are iterated one by one, so it has the
    /// factor of its largest step.
    double contraction = 0;
};

[[nodiscard]] KnownOscillator known_oscillator(const ExactMethod& method);

/// The behaviour at one z = h omega.
struct Oscillation {
    bool is_stable = false;
    /// An upper bound of |R^n|, for all n, where R is the map of (omega q, p); infinite if not
    /// stable.
    double bound = 0;
    /// log10 of the spectral radius of R; 0 if stable.
    double growth = 0;
};

/// Decides by the stable intervals below known.stability.until, and beyond by half the trace
/// exactly at this z. Precondition: z > 0 is no pole.
[[nodiscard]] Oscillation oscillation(const KnownOscillator& known, double z);

/// Returns the response of (omega q, p) to a force in a step: forces of at most G in the stages
/// change the result of R by at most h G times this. Precondition: z is no pole.
[[nodiscard]] double response(const PartitionedMethod& method, double z);

}  // namespace hvi::gen

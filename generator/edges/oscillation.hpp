// What the exact map of the harmonic oscillator says of the orbits of a method.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/exact/methods/composed_method.hpp"
#include "generator/exact/methods/stability.hpp"

namespace hvi::gen {

/// What is known of a method on the oscillator beforehand, by its exact coefficients.
struct KnownOscillator {
    std::string method;
    OscillatorMap map;
    LinearStability stability;
    PartitionedMethod stages;
    /// A fixed-point iteration for positions multiplies errors by z^2 times this: the spectral
    /// radius of A A~. Of a composition, whose steps are iterated one by one, that of the largest.
    double contraction = 0;
};

[[nodiscard]] KnownOscillator known_oscillator(const ExactMethod& method);

/// At one z = h omega.
struct Oscillation {
    bool is_stable = false;
    /// An upper bound of |R^n|, for all n, where R is the map of (omega q, p); infinite if not
    /// stable.
    double bound = 0;
    /// log10 of the spectral radius of R; 0 if stable.
    double growth = 0;
};

/// Below known.stability.until by its intervals, and beyond by half the trace exactly at this z.
/// Precondition: z > 0 is no pole.
[[nodiscard]] Oscillation oscillation(const KnownOscillator& known, double z);

/// How much of a force on the oscillator reaches (omega q, p) in a step: where the stages meet
/// forces of at most G, they move it by at most h G times this from where R leaves it.
/// Precondition: z is no pole.
[[nodiscard]] double response(const PartitionedMethod& method, double z);

}  // namespace hvi::gen

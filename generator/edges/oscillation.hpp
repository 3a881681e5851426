// What the exact map of the harmonic oscillator says of the orbits of a method.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/certify/certificate.hpp"

namespace hvi::gen {

/// At one z = h omega.
struct Oscillation {
    bool is_stable = false;
    /// An upper bound of |R^n|, for all n, where R is the map of (omega q, p); infinite if not
    /// stable.
    double bound = 0;
    /// log10 of the spectral radius of R; 0 if stable.
    double growth = 0;
};

/// Below certificate.stability->until by its intervals, and beyond by half the trace exactly at
/// this z. Preconditions: the certificate has both; z > 0 is no pole.
[[nodiscard]] Oscillation oscillation(const Certificate& certificate, double z);

/// The spectral radius of A A~: a fixed-point iteration for positions multiplies errors by z^2
/// times this.
[[nodiscard]] double contraction(const Tableau& tableau);

/// How much of a force on the oscillator reaches (omega q, p) in a step: where the stages meet
/// forces of at most G, they move it by at most h G times this from where R leaves it.
/// Precondition: z is no pole.
[[nodiscard]] double response(const Tableau& tableau, double z);

}  // namespace hvi::gen

// The properties of steps that make a counted number of sweeps, each with its evidence.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "generator/certify/certificate.hpp"
#include "generator/exact/methods/counted_sweeps.hpp"

namespace hvi::gen {

/// A polynomial near to the slopes of steps before, whose values are starting slopes.
struct ExtrapolatedSlopes {
    std::size_t steps = 1;
    std::size_t degree = 0;
};

/// The certificate of steps of K sweeps that begin with the slopes at the start of each. A family
/// is empty where not all stages are iterated: values that are known before, or computed after,
/// have another number of sweeps.
struct SweptCertificate : Findings {
    int sweeps = 0;
    std::optional<SweptFamily> in_turn, at_once;  ///< for any H; see SweepForm
    std::optional<SweptFamily> separable, nystrom;
    std::optional<Term> growth = {};  ///< see first_of_determinant(); of the oscillator

    std::optional<ExtrapolatedSlopes> extrapolated = {};
    /// Extrapolated slopes have errors of O(h^starting_order): of the polynomial O(h^(degree+1)),
    /// and of slopes at stages one power more than their order.
    int starting_order = 1;

    [[nodiscard]] bool is_empty() const { return !in_turn && !separable; }
    [[nodiscard]] bool is_proved() const;
};

/// Certifies sweeps of a method, whose tableau is given too. Preconditions as for swept_family().
/// Throws MathError where the coefficients are known by enclosures alone, or are too long.
[[nodiscard]] SweptCertificate certify_sweeps(const Method& method, const Tableau& tableau,
                                              int sweeps, int max_order,
                                              std::optional<ExtrapolatedSlopes> extrapolated);

/// The powers of h up to which K sweeps from slopes with errors of O(h^q) agree with the method, at
/// least: each sweep gains one, and two where Lp does not depend on P nor Lq on Q. Of a quadratic T
/// a last Lq gains one more.
[[nodiscard]] int power_for_any(const SweptCertificate& certificate);
[[nodiscard]] int power_for_separable(const SweptCertificate& certificate);
[[nodiscard]] int power_for_nystrom(const SweptCertificate& certificate);

}  // namespace hvi::gen

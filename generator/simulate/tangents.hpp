// Directions along a run: its derivative, and how chaotic it is.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <complex>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "generator/drive/tangents.hpp"
#include "generator/simulate/answers.hpp"

namespace hvi::gen {

/// Findings on directions, as far as they were wished for.
struct TangentFindings {
    std::optional<double> lyapunov, megno, sali;
    std::vector<double> exponents;  ///< descending
    std::vector<double> entries;    ///< of the derivative, row by row: q and p by q and p
    std::vector<double> own;        ///< of the direction with a start of its own, at the end
    double form = 0;                ///< how far it is from symplectic
    /// Eigenvalues of the derivative, the largest first: the multipliers of an orbit that closes.
    std::vector<std::complex<double>> multipliers = {};
    /// Derivatives by the start of the time of an event at the end, and row by row of its state;
    /// empty where the motion does not cross its surface.
    std::vector<double> event_time = {}, event_state = {};
    /// Multipliers of the return map to the surface of the event, the largest first, where that
    /// does not move: eigenvalues of the derivative of its state but for one, which is 0.
    std::vector<std::complex<double>> return_multipliers = {};
    std::string fault = {};  ///< why a step failed; empty where none did
};

/// Throws as ask() does. Precondition: the target has a stepper of stepper_of_directions(),
/// or of tangent_stepper().
[[nodiscard]] TangentFindings find_tangents(const Target& target, const TangentWishes& wishes,
                                            const std::function<void(double)>& on_progress);

}  // namespace hvi::gen

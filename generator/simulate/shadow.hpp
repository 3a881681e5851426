// The modified Hamiltonian of a method along a run.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <string>

#include "generator/drive/shadow.hpp"
#include "generator/simulate/answers.hpp"

namespace hvi::gen {

/// Measurements of the modified Hamiltonian.
struct ShadowFindings {
    double start = 0, largest = 0, last = 0;  ///< first value, then changes
    double error = 0;        ///< the largest error of differences in place of derivatives
    std::string fault = {};  ///< why a step failed; empty where none did
};

/// Measures the modified Hamiltonian. Throws as ask() does. Preconditions: the target has a stepper
/// of shadow_stepper(), and there are at least as many steps as it takes.
[[nodiscard]] ShadowFindings find_shadow(const Target& target, const ShadowWishes& wishes,
                                         const std::function<void(double)>& on_progress);

}  // namespace hvi::gen

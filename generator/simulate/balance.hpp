// The energy balance along a run of an H that depends on time.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <string>

#include "generator/drive/balance.hpp"
#include "generator/simulate/answers.hpp"

namespace hvi::gen {

/// The balance H(t) - H(0) - the integral of dH/dt by t alone. It is 0 but for the errors of steps.
struct BalanceFindings {
    double largest = 0, last = 0;
    std::string fault = {};  ///< why a step failed; empty where none did
};

/// Measures the balance. Throws as ask() does. Precondition: the target has a stepper of
/// balance_stepper().
[[nodiscard]] BalanceFindings find_balance(const Target& target, const BalanceWishes& wishes,
                                           const std::function<void(double)>& on_progress);

}  // namespace hvi::gen

// The balance between the energy and its change by an H that depends on time.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>

namespace hvi::gen {

/// Steps along which the balance is measured.
struct BalanceWishes {
    double h = 0;
    std::int64_t steps = 0;
};

/// Takes the steps of DrivenProblem, whose energy is H + e, and reports its largest change and its
/// change at the end. Returns the exit status 0 also where a step failed.
[[nodiscard]] int take_balance(const BalanceWishes& wishes);

}  // namespace hvi::gen

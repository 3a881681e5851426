// The balance of the energy and of what an H that depends on the time takes in.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>

namespace hvi::gen {

/// Steps along which the balance is measured.
struct BalanceWishes {
    double h = 0;
    std::int64_t steps = 0;
};

/// Takes the steps of DrivenProblem, whose energy is H + e, and says its largest change and that at
/// the end. The status of its end is 0 also where a step failed.
[[nodiscard]] int take_balance(const BalanceWishes& wishes);

}  // namespace hvi::gen

// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/simulate/balance.hpp"

namespace hvi::gen {

BalanceFindings find_balance(const Target& target, const BalanceWishes& wishes,
                             const std::function<void(double)>& on_progress) {
    const Answers answers = ask(target, wishes, on_progress);
    if (answers.has("fault")) return {.fault = answers.text("fault")};
    return {answers.number("largest"), answers.number("last"), {}};
}

}  // namespace hvi::gen

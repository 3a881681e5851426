// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/balance.hpp"

#include <algorithm>

#include <driver/answer.hpp>
#include <driver/departure.hpp>

#include "generator/drive/driven_problem.hpp"
#include "generator/drive/progress_of_steps.hpp"

namespace hvi::gen {

int take_balance(const BalanceWishes& wishes) {
    constexpr std::int64_t at_once = 100'000;
    DrivenStepper stepper = DrivenProblem::stepper();
    DrivenStepper::State x = stepper.initial();
    driver::Invariants<DrivenProblem> invariants(stepper, x);
    ProgressOfSteps progress(wishes.steps, 0, 1);
    for (std::int64_t taken = 0; taken < wishes.steps;) {
        const std::int64_t next = std::min(at_once, wishes.steps - taken);
        const Run run = invariants.take(stepper, x, wishes.h, next);
        if (!run.ok()) {
            driver::say("fault", run.status.message());
            return 0;
        }
        taken += next;
        progress.tell(taken);
    }
    const detail::Departure& departure = invariants.departures().front();
    driver::say("largest", departure.largest);
    driver::say("last", departure.last);
    return 0;
}

}  // namespace hvi::gen

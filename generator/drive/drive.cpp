// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/drive.hpp"

#include <driver/departures.hpp>
#include <driver/guarded.hpp>
#include <driver/large_measure.hpp>
#include <driver/measure.hpp>

#include "generator/drive/driven_problem.hpp"

namespace hvi::gen {

namespace {

using Words = std::vector<std::string_view>;

int run(std::string_view command, const Words& words) {
    if (command == "measure") return driver::measure<DrivenProblem>(words);
    if (command == "departures") return driver::departures<DrivenProblem>(words);
    return 2;
}

/// Runs a command that computes invariants where rows are written.
int run_by_rows(std::string_view command, const Words& words) {
    if (command == "measure") return driver::large_measure<DrivenProblem>(words);
    if (command == "departures") return driver::large_departures<DrivenProblem>(words);
    if (command == "pace") return driver::large_pace<DrivenProblem>(words);
    return 2;
}

int run(Words words) {
    const bool by_rows = !words.empty() && words.front() == rows_word;
    if (by_rows) words.erase(words.begin());
    if (words.empty()) return 2;
    const std::string_view command = words.front();
    words.erase(words.begin());
    return by_rows ? run_by_rows(command, words) : run(command, words);
}

/// Runs work() on the steppers, which may throw as drivers do. Returns its exit status.
template <class Work>
int status_of(const FindSteppers& find, Work work) {
    try {
        return driver::guarded([&] {
            DrivenProblem::make = find();
            return work();
        });
    } catch (const detail::SolverIsApart&) { return solver_is_apart; }
}

}  // namespace

int drive(const FindSteppers& find, const Words& command) {
    return status_of(find, [&] { return run(command); });
}

int drive(const FindSteppers& find, const TrajectoryWishes& wishes) {
    return status_of(find, [&] { return take_trajectory(wishes); });
}

int drive(const FindSteppers& find, const TangentWishes& wishes) {
    return status_of(find, [&] { return take_tangents(wishes); });
}

int drive(const FindSteppers& find, const ShadowWishes& wishes) {
    return status_of(find, [&] { return take_shadow(wishes); });
}

int drive(const FindSteppers& find, const BalanceWishes& wishes) {
    return status_of(find, [&] { return take_balance(wishes); });
}

int drive(const FindSteppers& find, const EventfulRunWishes& wishes) {
    return status_of(find, [&] { return take_eventful_run(wishes); });
}

}  // namespace hvi::gen

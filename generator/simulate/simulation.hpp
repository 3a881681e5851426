// A scene that is run: compiled, and started as a program of its own.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "generator/emit/scene_stepper.hpp"
#include "generator/exact/step_count.hpp"
#include "generator/program/cache.hpp"

namespace hvi::gen {

/// A quantity that the exact motion keeps, over a run.
struct Conserved {
    std::string name;  ///< `energy`, or that of an invariant
    double start = 0;
    double largest = 0;  ///< the largest departure from the start; NaN or infinite where it is lost
    double last = 0;     ///< the departure at the end, with its sign
};

/// What became of a run.
struct Simulation {
    std::string status;            ///< `ok`, or why it stopped early
    std::int64_t steps = 0;        ///< taken
    std::int64_t rows = 0;         ///< of the table, without the names
    std::int64_t iterations = 0;   ///< of the solver
    std::int64_t evaluations = 0;  ///< of dH/dq
    double seconds_of_step = 0;    ///< where nobody looks on; 0 where no step was taken
    std::vector<Conserved> conserved;

    [[nodiscard]] bool ok() const { return status == "ok"; }
};

/// The names of what a run keeps: the energy, where H does not depend on the time, and invariants.
[[nodiscard]] std::vector<std::string> conserved_names(const LoweredScene& lowered);

/// What steppers of simulations are to have.
[[nodiscard]] StepperWishes simulation_wishes(Solver solver);

/// Throws InputError where a parameter of the method is left without a value.
void check_simulation(const SceneStepper& stepper);

/// The program that run_simulation() starts. Precondition: `stepper` is made as wished for, and
/// checked.
[[nodiscard]] ProgramText simulation_program(const SceneStepper& stepper);

/// Runs the compiled program; it writes the table of t, the variables, the energy and the
/// invariants, one row in `every` steps and the last, into `table`. `on_progress` gets the part of
/// it that is done. Throws EnvironmentError where the table cannot be written, and Interruption.
[[nodiscard]] Simulation run_simulation(const std::filesystem::path& program,
                                        const SceneStepper& stepper, const Steps& steps,
                                        std::int64_t every, const std::filesystem::path& table,
                                        const std::function<void(double)>& on_progress);

}  // namespace hvi::gen

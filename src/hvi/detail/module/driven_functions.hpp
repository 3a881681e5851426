// The functions of a module that hvi-gen compiles and drives itself.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <hvi/detail/module/departure.hpp>
#include <hvi/detail/module/loaded_solvers.hpp>

namespace hvi::detail {

/// Version of these functions: hvi-gen takes no module of another one.
inline constexpr int driven_version = 4;

/// Codes of steps that are none of a Status.
inline constexpr int driven_out_of_memory = -1, driven_solver_is_apart = -2;

enum class DrivenAnswer : int { ok, out_of_memory, failed };

/// Numbers of a state, whether the time follows them, and invariants of the scene.
struct DrivenSizes {
    std::size_t coordinates, momenta;
    bool has_time;
    std::size_t invariants;
};

struct DrivenCounts {
    std::int64_t steps, iterations, evaluations;
};

/// Functions of a module, which it has as its symbol hvi_scene. Steppers are pointers to nothing;
/// states are coordinates, momenta, and the time where the function depends on it.
struct DrivenFunctions {
    int version;
    void (*take_solvers)(FindSolver find);
    /// Makes a stepper; else `message` is why not, in `room` characters.
    DrivenAnswer (*create)(const char* directory, unsigned threads, const double* parameters,
                           std::size_t count, void** made, char* message, std::size_t room);
    void (*destroy)(void* stepper);
    DrivenSizes (*sizes)(const void* stepper);
    DrivenCounts (*counts)(const void* stepper);
    void (*begin)(const void* stepper, double* state);
    /// Takes steps until one fails: the code of its Status, or one that is none.
    int (*take)(void* stepper, double* state, double h, std::int64_t steps);
    /// Takes steps as take() does, and looks after each at the energy, where the function does not
    /// depend on the time, and at the invariants.
    int (*follow)(void* stepper, double* state, double h, std::int64_t steps,
                  Departure* departures);
    /// Takes a step, and so many directions along, q and p of each one after the other: the code of
    /// its status, as of take(). A rotation has three numbers, the theta of R exp(hat theta).
    /// Unless the status is ok, the directions have kept their bits. Null where steps carry none.
    int (*carry)(void* stepper, double* state, double* directions, std::size_t count, double h);
    /// Forgets what steps have left behind.
    void (*reset)(void* stepper);
    double (*energy)(const void* stepper, const double* state);
    void (*invariants)(const void* stepper, const double* state, double* values);
};

}  // namespace hvi::detail

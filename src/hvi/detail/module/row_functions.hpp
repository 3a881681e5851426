// The functions of a module that takes many rows of an ensemble at once.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <hvi/detail/module/driven_functions.hpp>

namespace hvi::detail {

/// Version of these functions: hvi-gen takes no module of another one.
inline constexpr int rows_version = 1;

/// Code of a row that was not taken to its end, as somebody asked for the end of the work.
inline constexpr int row_not_finished = -3;

/// Trajectories of an ensemble, from their starts to their ends. Lists have a place for each row,
/// or as many numbers for each as is said, one row after the other.
struct EnsembleRows {
    std::size_t count;
    const double* parameters;   ///< as those of DrivenFunctions::create(), for each row
    const double* h;            ///< is finite and not 0
    const std::int64_t* steps;  ///< to take, at least 0
    double* states;             ///< at the end: coordinates, momenta, the time where there is one
    std::int64_t* taken;        ///< steps that went well
    int* statuses;              ///< codes of Status, or row_not_finished
    double* energy_errors;      ///< the largest departures of the energy, or null: not asked for
    double* conserved;          ///< at the end: the energy, unless H depends on the time, then
                                ///< invariants; or null: not asked for
    bool (*is_stopped)();       ///< asked every few thousand steps: whether the work is to end
    /// For modules whose rows carry a direction along: dq, then dp, of norm 1, which each row
    /// begins with; and of each row the logarithm of its growth, and MEGNO.
    const double* direction = nullptr;
    double* growths = nullptr;
};

/// Functions of such a module, which it has as its symbol hvi_rows. Where rows carry a direction
/// along, coordinates are (q, dq), and momenta (dp, p).
struct RowFunctions {
    int version;
    DrivenSizes sizes;
    /// Takes all rows: each has the same bits whatever the others are. `directory` has the files
    /// that the scene reads. Unless the answer is ok, `message` is what is wrong with the
    /// parameters or the machine, in `room` characters.
    DrivenAnswer (*take)(const char* directory, std::size_t parameters, const EnsembleRows& rows,
                         char* message, std::size_t room);
};

}  // namespace hvi::detail

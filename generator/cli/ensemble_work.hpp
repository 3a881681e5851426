// Workers of a study: processes of this machine, or ranks of mpirun.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <functional>

#include "generator/cli/ensemble_rows.hpp"
#include "generator/cli/runner.hpp"

namespace hvi::gen {

/// Computes the chunks of a study by so many processes, which share the work with all other workers
/// of its directory. Shows progress. Returns false where an interruption has come. Throws
/// EnvironmentError where a worker fails. Precondition: begin(study), and interruptions are held.
bool compute(const Study& study, const EnsembleWork& work, const RowSource& source,
             std::size_t workers, Runner& runner);

/// Returns the steppers of a study, compiled or interpreted. Throws as Runner::target() does.
[[nodiscard]] Targets targets_of(const EnsembleWork& work, Runner& runner);

/// Computes the chunks of a study by the ranks of mpirun, to which rank 0 hands them out, and calls
/// `finish` on rank 0 when all are computed. Throws as under_mpi() does, and Interruption where a
/// signal asks for the end. Precondition: interruptions are held.
void compute_by_ranks(const Study& study, const EnsembleWork& work, const RowSource& source,
                      Runner& runner, const std::function<void()>& finish);

}  // namespace hvi::gen

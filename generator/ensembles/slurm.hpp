// Batch files of Slurm for a study.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/ensembles/study.hpp"

namespace hvi::gen {

/// Returns a batch file for an array of tasks, each of which starts workers of the study on its
/// cores. `words` are those of the command line, `--slurm` among them. Slurm signals a task a
/// minute before its limit, so that it ends cleanly; the same file goes on with the study.
[[nodiscard]] std::string slurm_script(const Study& study, const std::vector<std::string>& words,
                                       int tasks);

}  // namespace hvi::gen

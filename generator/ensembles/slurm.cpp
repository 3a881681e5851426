// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ensembles/slurm.hpp"

#include <fmt/format.h>

#include "generator/support/shell_word.hpp"

namespace hvi::gen {

namespace {

/// Returns the command without --slurm and its value.
std::string command_of(const std::vector<std::string>& words) {
    std::string command = "hvi-gen";
    for (std::size_t k = 0; k < words.size(); ++k) {
        if (words[k] == "--slurm") {
            ++k;
        } else if (!words[k].starts_with("--slurm=")) {
            command += " " + shell_word(words[k]);
        }
    }
    return command;
}

}  // namespace

std::string slurm_script(const Study& study, const std::vector<std::string>& words, int tasks) {
    return fmt::format(R"sh(#!/bin/sh
#SBATCH --job-name=hvi
#SBATCH --array=1-{tasks}
#SBATCH --nodes=1
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --time=01:00:00
#SBATCH --signal=B:USR1@60
#SBATCH --open-mode=append

# {rows} rows in {chunks} chunks. Submitted again, this file goes on with the study. Each task starts as
# many workers as it has cores; cores and time are yours to choose.
trap 'kill -USR1 "$hvi"; wait "$hvi"; exit $?' USR1 TERM
{command} --workers "${{SLURM_CPUS_PER_TASK:-1}}" &
hvi=$!
wait "$hvi"
)sh",
                       fmt::arg("tasks", tasks), fmt::arg("rows", study.rows),
                       fmt::arg("chunks", study.chunks()), fmt::arg("command", command_of(words)));
}

}  // namespace hvi::gen

// The results of a study: its summary and its map.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/cli/options.hpp"
#include "generator/ensembles/study.hpp"

namespace hvi::gen {

/// Throws InputError where a map names no columns of the study, or not two or three. `map` may be
/// none.
void check_map(const Study& study, const Given& map);

/// Writes summary.txt, and map.svg where it is asked for, into the directory of a study, and prints
/// the summary. Where other workers still have chunks it says so, and writes nothing. Throws
/// EnvironmentError.
void write_results(const Study& study, const EnsembleOptions& options);

}  // namespace hvi::gen

// The steppers that take the rows of an ensemble.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/cli/ensemble_rows.hpp"
#include "generator/cli/method.hpp"
#include "generator/cli/options.hpp"

namespace hvi::gen {

/// Chooses the steppers, and plans the rows of `source`; columns are left to the caller. Throws
/// InputError for wishes that are not built for this scene and method.
[[nodiscard]] EnsembleWork work_of(const EnsembleOptions& options, const MethodAndScene& both,
                                   const RowSource& source, const SceneTimes& times);

}  // namespace hvi::gen

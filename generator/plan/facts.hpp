// Facts about a Hamiltonian, and costs of a step, in words.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/ir/step.hpp"
#include "generator/ir/system.hpp"
#include "generator/plan/evaluations.hpp"

namespace hvi::gen {

/// Returns the proved properties of H, one line each, without a full stop.
[[nodiscard]] std::vector<std::string> facts(const System& system);

/// Returns the work of a step, one line each: unknowns, evaluations and the operations of their
/// kernels.
[[nodiscard]] std::vector<std::string> costs(const System& system, const Step& step,
                                             const Evaluations& evaluations);

}  // namespace hvi::gen

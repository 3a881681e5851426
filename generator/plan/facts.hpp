// What was found in a Hamiltonian, and what a step of a step costs, in words.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/ir/step.hpp"
#include "generator/ir/system.hpp"
#include "generator/plan/evaluations.hpp"

namespace hvi::gen {

/// One line each, without a full stop: what is proved of H.
[[nodiscard]] std::vector<std::string> facts(const System& system);

/// The same of the work: unknowns, evaluations and the operations of their kernels.
[[nodiscard]] std::vector<std::string> costs(const System& system, const Step& step,
                                             const Evaluations& evaluations);

}  // namespace hvi::gen

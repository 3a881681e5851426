// Elimination of the momenta.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/step.hpp"

namespace hvi::gen {

/// Returns the c_i = sum_j m_ij b_j of the positions.
[[nodiscard]] NumberVector position_times(const Step& step);

/// Returns the step for quadratic kinetic energy; see VelocityForm. Preconditions: it is separable
/// and not explicit, depends on no parameter, and its weights add up to 1.
[[nodiscard]] VelocityForm velocity_form(const Step& step);

/// Returns the order in which positions and forces are then computed.
[[nodiscard]] std::vector<Block> blocks(const VelocityForm& form);

}  // namespace hvi::gen

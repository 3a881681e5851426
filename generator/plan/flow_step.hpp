// Steps that are flows of parts of H.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/algebra/number_vector.hpp"
#include "generator/ir/step.hpp"

namespace hvi::gen {

/// Returns the flows of a step. `substeps`: steps of the map of all flows one after the other, and
/// of its adjoint, in turn; see substeps() of a splitting. Flows of one part in a row are one.
///
/// Fast parts are one part F, the last one. In place of its flow over tau stand `count` steps of
/// their own splitting strang, each over tau / count (Tuckerman, Berne & Martyna, J. Chem. Phys. 97
/// (1992) 1990). Precondition: where there are fast parts, each substep of the adjoint is as long
/// as the one before it.
[[nodiscard]] FlowStep flow_step(std::size_t parts, const SmallSteps& small_steps,
                                 const NumberVector& substeps);

/// Makes the step one of flows of the parts of the system. Preconditions: those of flow_step(); the
/// stages, places and blocks are those of a separable H.
void set_flows(Step& step, const SystemProperties& system, const NumberVector& substeps);

}  // namespace hvi::gen

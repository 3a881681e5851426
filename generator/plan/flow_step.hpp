// Steps that are flows of parts of H.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/algebra/number_vector.hpp"
#include "generator/ir/step.hpp"

namespace hvi::gen {

/// Returns the flows of a step. `substeps`: steps of the map of all flows one after the other, and
/// of its adjoint, in turn; see substeps() of a splitting. Flows of one part in a row are one.
///
/// Fast parts come first: before the flows of the other parts there and back, which last as long as
/// a substep and that of the adjoint after it, they take half of `count` small steps, and the other
/// half thereafter. A small step is one of their own splitting strang; of an odd number the middle
/// one is taken apart in its middle. So the others, whose forces take time, have their turn once in
/// a step: the impulse method, or RESPA (Tuckerman, Berne & Martyna, J. Chem. Phys. 97 (1992)
/// 1990), seen half a step later. Precondition: where there are fast parts, each substep of the
/// adjoint is as long as the one before it.
[[nodiscard]] FlowStep flow_step(std::size_t parts, const SmallSteps& small_steps,
                                 const NumberVector& substeps);

/// Joins the last flow of a step with the first one of the next where both are of one part. Such
/// steps in a row have one flow less each.
[[nodiscard]] FlowStep with_joined_ends(FlowStep form);

/// Makes the step one of flows of the parts of the system. Preconditions: those of flow_step(); the
/// stages, places and blocks are those of a separable H.
void set_flows(Step& step, const SystemProperties& system, const NumberVector& substeps);

}  // namespace hvi::gen

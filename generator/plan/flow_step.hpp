// Steps that are flows of parts of H.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/algebra/number_vector.hpp"
#include "generator/ir/step.hpp"

namespace hvi::gen {

/// Makes the step one of flows of so many parts. `substeps`: steps of the map of all flows one
/// after the other, and of its adjoint, in turn; see substeps() of a splitting. Flows of one part
/// in a row are one. Precondition: the stages, places and blocks are those of a separable H.
void set_flows(Step& step, std::size_t parts, const NumberVector& substeps);

}  // namespace hvi::gen

// Second derivatives of H along a direction, as straight-line code.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/ir/system.hpp"
#include "generator/lower/kernel.hpp"

namespace hvi::gen {

/// Rows of d2H times a direction, at one point and for several directions.
struct DirectionKernel {
    Kernel point;            ///< what all directions share: factors of the point
    std::vector<Node> kept;  ///< inputs in the place of these results
    Kernel along;            ///< of a direction, and of what is kept
};

/// The equations in which directions move with (q, p).
struct DirectionKernels {
    std::vector<Node> dq, dp;  ///< inputs of the graph
    DirectionKernel by_q, by_p;
    DirectionKernel both;  ///< by_q, then by_p
};

/// Adds them to the graph of the system. They are the gradient of K = H_q dq + H_p dp by q and p,
/// which costs as much as a few gradients of H, however many degrees of freedom there are; and what
/// does not depend on the direction is multiplied before it comes to that.
/// Precondition: an H that is written out, without rotations.
[[nodiscard]] DirectionKernels direction_kernels(System& system);

}  // namespace hvi::gen

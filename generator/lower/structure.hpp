// Second derivatives, and what a Hamiltonian is made of, as far as that is proved.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Of H or L, added to the graph; what is proved to be constant does not vary in it. Precondition:
/// the gradient is there.
[[nodiscard]] Hessian hessian(System& system);

/// What H is made of. Precondition: the Hessian is there, and it is that of H.
[[nodiscard]] Structure structure(System& system);

}  // namespace hvi::gen

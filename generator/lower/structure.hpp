// What a Hamiltonian is made of, as far as that is proved.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Adds the second derivatives to the graph. Precondition: the gradient is there.
[[nodiscard]] Structure structure(System& system);

}  // namespace hvi::gen
